package org.palpate.realtime;

/** Spins until the moment has come. */
final class SpinWait implements DeadlineWait {
  @Override
  public void until(long nanoTime) {
    while (System.nanoTime() < nanoTime) {
      Thread.onSpinWait();
    }
  }
}
