package org.palpate.app.process;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.palpate.display.DisplayLoss;
import org.palpate.io.file.AtomicFile;

/**
 * Decides what Ctrl-C, or another request to end the process, does at present: delete unfinished
 * files, end quietly, or end the command in order.
 *
 * <p>There is one hook in the process. A command changes what it does and changes it back.
 */
public final class ShutdownHook {
  /** Longer than a session needs to stop and a report to be written. */
  private static final long COMMAND_WAIT_SECONDS = 20;

  private static final CountDownLatch COMMAND_DONE = new CountDownLatch(1);
  private static volatile int exitCode = PalpateException.FAILED;
  private static volatile Runnable atEnd = AtomicFile::discardUnfinished;

  private ShutdownHook() {}

  /** Adds the hook to the process. Called by the main thread when the process starts. */
  public static void install() {
    Runtime.getRuntime().addShutdownHook(new Thread(() -> atEnd.run(), "palpate-end"));
  }

  /** From now on, the end of the process deletes unfinished files, as it does at first. */
  public static void discardUnfinishedFiles() {
    atEnd = AtomicFile::discardUnfinished;
  }

  /**
   * From now on, the process ends at once with exit code 0 and leaves no unfinished file. For a
   * command that has nothing to complete yet.
   */
  public static void endQuietly() {
    atEnd =
        () -> {
          AtomicFile.discardUnfinished();
          Runtime.getRuntime().halt(0);
        };
  }

  /**
   * From now on, the end of the process asks the command to stop, waits until it has written its
   * output, and keeps the command's own exit code.
   *
   * @param stop asks the command to stop; it must not wait
   */
  public static void endInOrder(Runnable stop) {
    atEnd =
        () -> {
          stop.run();
          awaitCommand();
        };
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
}
