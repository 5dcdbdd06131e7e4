package org.palpate.loop;

/** A source of time: {@code System::nanoTime} in a session, a variable in a test. */
@FunctionalInterface
public interface NanoClock {
  /** The clock of the machine. */
  NanoClock SYSTEM = System::nanoTime;

  /** {@return nanoseconds from an arbitrary origin} Compare two times by their difference only. */
  long nanoTime();
}
