package org.palpate.loop;

/** Where time comes from: {@code System::nanoTime} in a session, a variable in a test. */
@FunctionalInterface
public interface NanoClock {
  /** The clock of the machine. */
  NanoClock SYSTEM = System::nanoTime;

  /** Nanoseconds from an arbitrary origin; compare by difference only. */
  long nanoTime();
}
