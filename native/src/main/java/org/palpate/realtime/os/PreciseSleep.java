package org.palpate.realtime.os;

/** A sleep until an absolute time. Belongs to one thread; allocates nothing. */
public interface PreciseSleep extends AutoCloseable {
  /**
   * Sleeps until the given time or slightly later; returns at once if it has passed. May return
   * early.
   *
   * @param nanoTime the time on the clock of {@link System#nanoTime}
   */
  void until(long nanoTime);

  /** Releases the system's resources; may be called twice, but not while the thread sleeps. */
  @Override
  default void close() {}
}
