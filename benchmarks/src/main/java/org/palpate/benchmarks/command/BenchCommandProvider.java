package org.palpate.benchmarks.command;

import java.util.concurrent.Callable;
import org.palpate.app.CommandProvider;

/** Adds {@link BenchCommand} to the command line. */
public final class BenchCommandProvider implements CommandProvider {
  @Override
  public Callable<Integer> command() {
    return new BenchCommand();
  }
}
