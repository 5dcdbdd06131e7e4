package org.palpate.realtime;

import org.palpate.loop.Pacer;

/**
 * A pacer that may own a resource of the operating system. Belongs to one thread. Deadlines are on
 * the clock of {@link System#nanoTime}.
 */
public interface DeadlineWait extends Pacer, AutoCloseable {
  /** Releases the system's resources. Not to be called while the thread waits. */
  @Override
  default void close() {}
}
