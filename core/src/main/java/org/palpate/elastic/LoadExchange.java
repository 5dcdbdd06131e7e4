package org.palpate.elastic;

import org.palpate.sync.Accumulator;
import org.palpate.sync.PositionProperty;

/**
 * Hands the load of each frame from the haptic thread to the thread of the updates: the last whole
 * one wins. Neither waits.
 */
final class LoadExchange {
  private final Accumulator accumulator = new Accumulator();
  private final PositionProperty point = accumulator.position("point");
  private final PositionProperty forceNewton = accumulator.position("force");

  /** Writes a load. Haptic thread. */
  void write(ElasticLoad load) {
    point.set(load.point);
    forceNewton.set(load.forceNewton);
    accumulator.publish();
  }

  /** Reads the last load, or none before the first frame. Thread of the updates. */
  void read(ElasticLoad dest) {
    accumulator.take();
    point.read(dest.point);
    forceNewton.read(dest.forceNewton);
  }
}
