package org.palpate.app.process;

import org.palpate.io.volume.ReadProgress;

/** A progress bar on a terminal for work that takes longer than a second. One thread. */
public final class ProgressLine implements ReadProgress {
  private static final long SECOND_NANOS = 1_000_000_000L;
  private static final int WIDTH = 40;

  private final String what;
  private final boolean shown = Terminal.isInteractive();
  private final long startNanos = System.nanoTime();
  private int drawn = -1;

  /**
   * Creates a progress bar.
   *
   * @param what the work, printed before the bar
   */
  public ProgressLine(String what) {
    this.what = what;
  }

  @Override
  public void slicesRead(int done, int total) {
    if (!shown || (drawn < 0 && System.nanoTime() - startNanos < SECOND_NANOS)) {
      return;
    }
    int length = (int) ((long) WIDTH * done / total);
    if (done == total) {
      clear();
      return;
    }
    if (length != drawn) {
      System.err.print("\r" + what + " [" + "#".repeat(length) + ".".repeat(WIDTH - length) + "]");
    }
    drawn = length;
  }

  /** Removes the bar, so that a line can be printed; the next progress draws it again. */
  public void clear() {
    if (shown && drawn >= 0) {
      System.err.print("\r" + " ".repeat(what.length() + WIDTH + 4) + "\r");
      drawn = -1;
    }
  }
}
