package org.palpate.benchmarks.jitter;

import java.util.concurrent.Callable;
import org.palpate.app.CommandProvider;

/** Adds {@link JitterCommand} to the command line. */
public final class JitterCommandProvider implements CommandProvider {
  @Override
  public Callable<Integer> command() {
    return new JitterCommand();
  }
}
