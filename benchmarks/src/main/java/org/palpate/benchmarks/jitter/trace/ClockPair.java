package org.palpate.benchmarks.jitter.trace;

import jdk.jfr.Category;
import jdk.jfr.Event;
import jdk.jfr.Label;
import jdk.jfr.Name;
import jdk.jfr.StackTrace;

/** One moment on the clock of the flight recording and on that of {@link System#nanoTime}. */
@Name(FlightRecording.CLOCK_PAIR)
@Label("Clock pair")
@Category("Palpate")
@StackTrace(false)
public final class ClockPair extends Event {
  private static final int PAIRS = 40;

  @Label("nanoTime before")
  long before;

  @Label("nanoTime after")
  long after;

  /** Notes some pairs, of which the reader takes the tightest. */
  public static void note() {
    for (int i = 0; i < PAIRS; i++) {
      ClockPair pair = new ClockPair();
      pair.before = System.nanoTime();
      pair.begin();
      pair.after = System.nanoTime();
      pair.commit();
    }
  }
}
