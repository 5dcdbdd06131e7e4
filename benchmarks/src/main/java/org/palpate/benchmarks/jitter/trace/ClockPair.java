package org.palpate.benchmarks.jitter.trace;

import jdk.jfr.Category;
import jdk.jfr.Event;
import jdk.jfr.Label;
import jdk.jfr.Name;
import jdk.jfr.StackTrace;

/** An event with one moment on the recording's clock and on that of {@link System#nanoTime}. */
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

  /** Emits several pairs, of which the reader uses the narrowest. */
  public static void emit() {
    for (int i = 0; i < PAIRS; i++) {
      ClockPair pair = new ClockPair();
      pair.before = System.nanoTime();
      pair.begin();
      pair.after = System.nanoTime();
      pair.commit();
    }
  }
}
