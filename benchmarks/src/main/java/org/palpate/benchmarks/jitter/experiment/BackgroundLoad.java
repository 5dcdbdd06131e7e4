package org.palpate.benchmarks.jitter.experiment;

import java.util.concurrent.locks.LockSupport;

/** What else the JVM does while it is measured. */
public enum BackgroundLoad {
  NONE("none"),
  /** Allocates 100 MB a second and keeps the last 50 MB. */
  ALLOCATES("alloc"),
  /** Keeps one core busy. */
  BURNS("burn");

  private static final int ARRAYS_KEPT = 1000;
  private static final int ARRAY_BYTES = 50_000;
  private static final int ARRAYS_A_MILLI = 2;
  private static final long NANOS_A_MILLI = 1_000_000;

  private final String label;

  BackgroundLoad(String label) {
    this.label = label;
  }

  public String label() {
    return label;
  }

  /** Starts it in a daemon thread of its own. */
  void start() {
    if (this != NONE) {
      Thread thread =
          new Thread(this == ALLOCATES ? BackgroundLoad::allocate : BackgroundLoad::burn, label);
      thread.setDaemon(true);
      thread.start();
    }
  }

  private static void allocate() {
    byte[][] kept = new byte[ARRAYS_KEPT][];
    int next = 0;
    long due = System.nanoTime();
    while (true) {
      for (int i = 0; i < ARRAYS_A_MILLI; i++) {
        kept[next] = new byte[ARRAY_BYTES];
        next = (next + 1) % ARRAYS_KEPT;
      }
      due += NANOS_A_MILLI;
      LockSupport.parkNanos(due - System.nanoTime());
    }
  }

  private static void burn() {
    long value = 1;
    while (value != 0) { // a generator of full period: zero comes in some centuries
      value = value * 6364136223846793005L + 1442695040888963407L;
    }
  }
}
