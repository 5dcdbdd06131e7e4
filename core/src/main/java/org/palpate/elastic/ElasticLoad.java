package org.palpate.elastic;

import org.palpate.geometry.Vec3;

/** The place at which a tool presses an elastic body, and the force. One thread. */
final class ElasticLoad {
  /** The point in material coordinates. */
  final Vec3 point = new Vec3();

  /** The force on the material, N. */
  final Vec3 forceNewton = new Vec3();

  /** Copies another load. */
  void set(ElasticLoad other) {
    point.set(other.point);
    forceNewton.set(other.forceNewton);
  }
}
