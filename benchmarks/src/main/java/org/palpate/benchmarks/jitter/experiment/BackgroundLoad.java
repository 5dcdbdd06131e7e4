package org.palpate.benchmarks.jitter.experiment;

import java.util.concurrent.locks.LockSupport;

/** Background loads in the measured JVM. */
public enum BackgroundLoad {
  NONE("none"),
  /** Allocates 100 MB per second and keeps the last 50 MB. */
  ALLOCATES("alloc"),
  /** Keeps one processor busy. */
  BURNS("burn");

  private static final int ARRAYS_KEPT = 1000;
  private static final int ARRAY_BYTES = 50_000;
  private static final int ARRAYS_PER_MILLI = 2;
  private static final long NANOS_PER_MILLI = 1_000_000;

  private final String label;

  BackgroundLoad(String label) {
    this.label = label;
  }

  /** Returns the word for a table. */
  public String label() {
    return label;
  }

  /** Starts the load in a daemon thread of its own. */
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
      for (int i = 0; i < ARRAYS_PER_MILLI; i++) {
        kept[next] = new byte[ARRAY_BYTES];
        next = (next + 1) % ARRAYS_KEPT;
      }
      due += NANOS_PER_MILLI;
      LockSupport.parkNanos(due - System.nanoTime());
    }
  }

  private static void burn() {
    long value = 1;
    while (value != 0) { // the generator has its full period, so that zero takes centuries
      value = value * 6364136223846793005L + 1442695040888963407L;
    }
  }
}
