package org.palpate.realtime;

/** Reads the clock in a loop until the deadline has passed. */
final class SpinWait implements DeadlineWait {
  @Override
  public void awaitUntil(long deadlineNanos) {
    while (System.nanoTime() < deadlineNanos && !Thread.currentThread().isInterrupted()) {
      Thread.onSpinWait();
    }
  }

  @Override
  public String toString() {
    return "spin";
  }
}
