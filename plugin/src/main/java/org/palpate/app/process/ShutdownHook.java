package org.palpate.app.process;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.palpate.display.DisplayLoss;

/**
 * Turns Ctrl-C, or another request to end the process, into an orderly end of the command.
 *
 * <p>The hook asks the command to stop, waits until it has written its output, and lets the process
 * end with the command's own exit code.
 */
public final class ShutdownHook {
  /** Longer than a session needs to stop and a report to be written. */
  private static final long COMMAND_WAIT_SECONDS = 20;

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

  /**
   * Returns an open hook: until it is closed, the end of the process calls {@code stop}, which must
   * not wait.
   */
  public static ShutdownHook install(Runnable stop) {
    ShutdownHook installed = new ShutdownHook(stop);
    Runtime.getRuntime().addShutdownHook(installed.hook);
    return installed;
  }

  /** Records that the command is done. Called by the main thread before it exits. */
  public static void commandDone(int code) {
    exitCode = code;
    COMMAND_DONE.countDown();
  }

  private static void awaitCommand() {
    try {
      if (COMMAND_DONE.await(COMMAND_WAIT_SECONDS, TimeUnit.SECONDS)) {
        DisplayLoss.exitIfLost(exitCode);
        // the signal's own exit code would report a failure that did not happen
        Runtime.getRuntime().halt(exitCode);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Removes the hook. */
  public void close() {
    try {
      Runtime.getRuntime().removeShutdownHook(hook);
    } catch (IllegalStateException e) {
      // The process is ending; the hook runs or has run.
    }
  }
}
