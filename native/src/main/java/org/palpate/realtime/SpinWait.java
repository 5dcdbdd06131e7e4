package org.palpate.realtime;

/** Spins until the moment has come. */
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
