package org.palpate.app.process;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.palpate.display.DisplayLoss;
import org.palpate.io.file.AtomicFile;

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

  /** Ends the process before the session starts; null while none is installed. */
  private static volatile ShutdownHook quiet;

  /** Number of hooks that wait for a command that completes its files. */
  private static final AtomicInteger ORDERLY = new AtomicInteger();

  private final Thread hook;

  private ShutdownHook() {
    hook =
        new Thread(
            () -> {
              AtomicFile.discardUnfinished();
              Runtime.getRuntime().halt(0);
            },
            "palpate-end");
  }

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
    ORDERLY.incrementAndGet();
    ShutdownHook before = quiet;
    if (before != null) {
      before.close();
    }
    return installed;
  }

  /**
   * Returns an open hook that ends the process at once with exit code 0 and leaves no unfinished
   * file. A command uses it while it has nothing to complete. {@link #install} closes it.
   */
  public static ShutdownHook endQuietlyUntilStart() {
    ShutdownHook installed = new ShutdownHook();
    Runtime.getRuntime().addShutdownHook(installed.hook);
    quiet = installed;
    return installed;
  }

  /**
   * Lets the end of the process delete unfinished files, unless a hook waits for a command that
   * completes them. Called by the main thread when the process starts.
   */
  public static void discardUnfinishedFiles() {
    Runtime.getRuntime()
        .addShutdownHook(
            new Thread(
                () -> {
                  if (ORDERLY.get() == 0) {
                    AtomicFile.discardUnfinished();
                  }
                },
                "palpate-discard"));
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
      AtomicFile.discardUnfinished();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Removes the hook. May be called repeatedly. */
  public void close() {
    try {
      boolean removed = Runtime.getRuntime().removeShutdownHook(hook);
      if (removed && this != quiet) {
        ORDERLY.decrementAndGet();
      }
    } catch (IllegalStateException e) {
      // The process is ending; the hook runs or has run.
    }
  }
}
