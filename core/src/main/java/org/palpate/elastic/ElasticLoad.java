package org.palpate.elastic;

import org.palpate.geometry.Vec3;
import org.palpate.sync.Accumulator;
import org.palpate.sync.PositionProperty;

/**
 * The force with which a tool presses an elastic body, and the place where it will press when the
 * field for it is in use, see {@link SlideForecast}. One thread.
 */
final class ElasticLoad {
  /** The place in material coordinates. */
  final Vec3 point = new Vec3();

  /** The force on the material, N. */
  final Vec3 forceNewton = new Vec3();

  /** Whether this is the load of a recorded update to the bit. */
  boolean isOf(RecordedUpdate update) {
    return point.sameBits(update.point()) && forceNewton.sameBits(update.forceNewton());
  }

  /** Copies another load. */
  void set(ElasticLoad other) {
    point.set(other.point);
    forceNewton.set(other.forceNewton);
  }

  /**
   * Hands the load of each frame from the haptic thread to the thread of the updates: the last
   * whole one wins. Neither waits.
   */
  static final class Exchange {
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
}
