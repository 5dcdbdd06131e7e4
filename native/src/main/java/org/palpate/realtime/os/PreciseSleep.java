package org.palpate.realtime.os;

/** A sleep that ends at a moment. Belongs to one thread; allocates nothing. */
public interface PreciseSleep extends AutoCloseable {
  /**
   * Sleeps until the moment or a little later; returns at once where it has passed. May return
   * early.
   *
   * @param nanoTime on the clock of {@link System#nanoTime}
   */
  void until(long nanoTime);

  /** Lets go what the system lent; may be called twice, not while the thread sleeps. */
  @Override
  default void close() {}
}
