package org.palpate.realtime;

import org.palpate.realtime.os.PreciseSleep;

/** Sleeps to an absolute time by the system's own call, and again if a signal ends it early. */
final class AbsoluteWait implements DeadlineWait {
  private final PreciseSleep sleep;

  AbsoluteWait(PreciseSleep sleep) {
    this.sleep = sleep;
  }

  @Override
  public void awaitUntil(long deadlineNanos) {
    while (System.nanoTime() < deadlineNanos && !Thread.currentThread().isInterrupted()) {
      sleep.until(deadlineNanos);
    }
  }

  @Override
  public void close() {
    sleep.close();
  }

  @Override
  public String toString() {
    return "absolute sleep";
  }
}
