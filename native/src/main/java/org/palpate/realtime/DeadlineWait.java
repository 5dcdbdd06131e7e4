package org.palpate.realtime;

import org.palpate.loop.Pacer;

/**
 * A way to wait that may hold something of the system's. Belongs to one thread. On the clock of
 * {@link System#nanoTime}.
 */
public interface DeadlineWait extends Pacer, AutoCloseable {
  /** Lets go what the system lent. Not while the thread waits. */
  @Override
  default void close() {}
}
