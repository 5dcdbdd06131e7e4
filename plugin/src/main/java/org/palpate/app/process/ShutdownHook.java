package org.palpate.app.process;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.palpate.display.DisplayLoss;

/**
 * Turns Ctrl-C, or another wish that the process end, into an orderly end of the command: asks it
 * to stop, waits until it has written what it has to write, and lets the process end with the
 * command's own exit code.
 */
public final class ShutdownHook {
  /** Longer than a session takes to stop and a report to be written. */
  private static final long PATIENCE_SECONDS = 20;

  private static final CountDownLatch COMMAND_DONE = new CountDownLatch(1);
  private static volatile int exitCode = PalpateException.FAILED;

  private final Thread hook;

  private ShutdownHook(Runnable stop) {
    hook =
        new Thread(
            () -> {
              stop.run();
              awaitCommand();
            },
            "palpate-end");
  }

  /** While open, {@code stop} is called when the process is to end; it must not wait. */
  public static ShutdownHook asks(Runnable stop) {
    ShutdownHook end = new ShutdownHook(stop);
    Runtime.getRuntime().addShutdownHook(end.hook);
    return end;
  }

  /** Says that the command is done; called by the process's main thread before it exits. */
  public static void commandDone(int code) {
    exitCode = code;
    COMMAND_DONE.countDown();
  }

  private static void awaitCommand() {
    try {
      if (COMMAND_DONE.await(PATIENCE_SECONDS, TimeUnit.SECONDS)) {
        DisplayLoss.exitIfLost(exitCode);
        // the signal's own exit code would tell of a failure that there was not
        Runtime.getRuntime().halt(exitCode);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Asks no one any more. */
  public void close() {
    try {
      Runtime.getRuntime().removeShutdownHook(hook);
    } catch (IllegalStateException e) {
      // the process is ending, and the hook runs or has run
    }
  }
}
