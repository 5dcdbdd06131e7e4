package org.palpate.app;

import java.util.concurrent.Callable;
import org.palpate.app.process.PalpateException;

/**
 * Adds a command to the command line. {@link java.util.ServiceLoader} finds providers, so that a
 * module that this one must not use can contribute commands.
 */
public interface CommandProvider {

  /**
   * Returns a new command: an object with picocli's {@code @Command} annotation.
   *
   * <p>Its {@code name} is what the user types, and its call returns the exit code. It throws
   * {@link PalpateException} for errors that the user can correct.
   */
  Callable<Integer> command();
}
