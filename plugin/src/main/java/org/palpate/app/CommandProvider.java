package org.palpate.app;

import java.util.concurrent.Callable;
import org.palpate.app.process.PalpateException;

/**
 * Adds a command to the command line. Found by {@link java.util.ServiceLoader}, so that a module
 * that this one must not know can bring commands of its own.
 */
public interface CommandProvider {

  /**
   * A new command: an object with picocli's {@code @Command} annotation, whose {@code name} is what
   * a person types, and whose call gives the exit code. It throws {@link PalpateException} for what
   * a person can mend.
   */
  Callable<Integer> command();
}
