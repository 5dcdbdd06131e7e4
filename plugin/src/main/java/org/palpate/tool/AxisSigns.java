package org.palpate.tool;

import java.util.Optional;
import org.palpate.geometry.Vec3;
import org.palpate.io.volume.CoordinateSystem;

/** Converts positions between worlds whose axes point to opposite sides of the patient. */
final class AxisSigns {
  private AxisSigns() {}

  /**
   * Returns the sign by which each coordinate changes from one world to the other; empty if the
   * directions of exactly one of them are not known.
   */
  static Optional<Vec3> between(CoordinateSystem from, CoordinateSystem to) {
    if (from == to) {
      return Optional.of(new Vec3(1, 1, 1));
    }
    if (from == CoordinateSystem.UNKNOWN || to == CoordinateSystem.UNKNOWN) {
      return Optional.empty();
    }
    return Optional.of(apply(toLps(from), toLps(to)));
  }

  private static Vec3 toLps(CoordinateSystem system) {
    return switch (system) {
      case RAS -> new Vec3(-1, -1, 1);
      case LAS -> new Vec3(1, -1, 1);
      case LPS, UNKNOWN -> new Vec3(1, 1, 1);
    };
  }

  /** Returns a position or direction with the signs of its coordinates changed. */
  static Vec3 apply(Vec3 signs, Vec3 v) {
    return new Vec3(signs.x * v.x, signs.y * v.y, signs.z * v.z);
  }
}
