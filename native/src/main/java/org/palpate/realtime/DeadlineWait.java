package org.palpate.realtime;

/** Waits until a moment and never returns before it. Belongs to one thread; allocates nothing. */
public interface DeadlineWait extends AutoCloseable {
  /**
   * Waits; returns at once where the moment has passed.
   *
   * @param nanoTime on the clock of {@link System#nanoTime}
   */
  void until(long nanoTime);

  /** Lets go what the system lent. Not while the thread waits. */
  @Override
  default void close() {}
}
