package org.palpate.fracture.fit;

import org.palpate.fracture.SmoothedBits;
import org.palpate.geometry.Vec3;

/**
 * Finds where a line enters a fragment through a fracture face. One thread an instance.
 *
 * <p>Near the skin of a bone smoothed voxels are less than half solid at the very face, because
 * they are empty beside it. So the face is where the occupancy is half of that which the line meets
 * deeper, at about the same distance from the skin. A flat face then is flat up to the skin, and
 * the faces of a bone that broke without loss coincide.
 */
final class FaceLine {
  /** The standard deviation of the smoothing, voxels. */
  static final double SIGMA = 0.6;

  private static final int STEPS_PER_EDGE = 2;

  /** The depth of the occupancy that counts as full, steps. */
  private static final int DEEP_STEPS = 3;

  /** The least occupancy at that depth. */
  private static final double LEAST_DEEP = 0.35;

  private static final int MOST_STEPS = 64;

  private final double stepMm;
  private final double[] values = new double[MOST_STEPS + 1];
  private final Vec3 at = new Vec3();
  private final Vec3 deepDescent = new Vec3();
  private final Vec3 point = new Vec3();
  private final Vec3 normal = new Vec3();
  private double distanceMm;
  private double deepOccupancy;

  FaceLine(double edgeMm) {
    stepMm = edgeMm / STEPS_PER_EDGE;
  }

  /**
   * Searches a face on a line; of several it finds the nearest to the start.
   *
   * @param direction into the fragment, a unit vector in the world
   * @param lowMm where to begin, before the start if negative
   * @param highMm where to end
   * @return whether there is one
   */
  boolean find(SmoothedBits fragment, Vec3 start, Vec3 direction, double lowMm, double highMm) {
    int steps = (int) Math.min(MOST_STEPS - DEEP_STEPS, Math.ceil((highMm - lowMm) / stepMm));
    int last = steps + DEEP_STEPS;
    for (int n = 0; n <= last; n++) {
      values[n] = fragment.descent(place(start, direction, lowMm + n * stepMm), normal);
    }
    distanceMm = Double.NaN;
    double before = Double.NaN;
    for (int n = 0; n <= steps; n++) {
      double deep = values[n + DEEP_STEPS];
      double now = values[n] / Math.max(deep, LEAST_DEEP);
      if (before < 0.5 && now >= 0.5 && deep >= LEAST_DEEP) {
        double t = lowMm + (n - (now - 0.5) / (now - before)) * stepMm;
        if (!(Math.abs(t) > Math.abs(distanceMm))) {
          distanceMm = t;
        }
      }
      before = now;
    }
    return !Double.isNaN(distanceMm) && findNormal(fragment, start, direction);
  }

  /** Computes the deeper occupancy, and the gradient of the occupancy over it. */
  private boolean findNormal(SmoothedBits fragment, Vec3 start, Vec3 direction) {
    double deepMm = distanceMm + DEEP_STEPS * stepMm;
    deepOccupancy = fragment.descent(place(start, direction, deepMm), deepDescent);
    double here = fragment.descent(place(start, direction, distanceMm), normal);
    point.set(at);
    normal.mul(1 / here, normal).sub(deepDescent.mul(1 / deepOccupancy, deepDescent), normal);
    double length = normal.length();
    normal.mul(length > 0 ? 1 / length : 0, normal);
    return length > 0;
  }

  private Vec3 place(Vec3 start, Vec3 direction, double t) {
    return at.set(start.x + t * direction.x, start.y + t * direction.y, start.z + t * direction.z);
  }

  /** Returns the distance of the face from the start, mm. */
  double distanceMm() {
    return distanceMm;
  }

  /** Returns the occupancy deeper in the fragment: 1 well inside the bone, less near its skin. */
  double deepOccupancy() {
    return deepOccupancy;
  }

  /** Returns the place on the face. */
  Vec3 point() {
    return point;
  }

  /** Returns the outward normal of the face. */
  Vec3 normal() {
    return normal;
  }
}
