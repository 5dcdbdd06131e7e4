package org.palpate.elastic;

import org.palpate.geometry.Vec3;

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
}
