package org.palpate.realtime;

import org.palpate.realtime.os.PreciseSleep;

/** The system's sleep to an absolute moment, again where a signal ended it early. */
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
