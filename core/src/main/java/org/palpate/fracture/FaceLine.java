package org.palpate.fracture;

import org.palpate.geometry.Vec3;

/**
 * Finds where a line enters a fragment through a face of its surface: a fracture face, or its skin.
 * One thread an instance.
 *
 * <p>Near an edge of the face smoothed voxels are less than half solid at the very face, because
 * they are empty beside it. So the face is where the occupancy is half of that which the line meets
 * deeper, at about the same distance from the edge. A flat face then is flat up to its edge, and
 * the faces of a bone that broke without loss coincide.
 */
public final class FaceLine {
  private static final int STEPS_PER_EDGE = 2;

  /** The least occupancy at that depth. */
  private static final double LEAST_DEEP = 0.35;

  private final double stepMm;

  /** The depth of the occupancy that counts as full, steps. */
  private final int deepSteps;

  private double[] values = new double[0];
  private final Vec3 at = new Vec3();
  private final Vec3 deepDescent = new Vec3();
  private final Vec3 point = new Vec3();
  private final Vec3 normal = new Vec3();
  private double distanceMm;
  private double deepOccupancy;

  /**
   * Prepares searches.
   *
   * @param edgeMm the edge of a voxel; steps are half as long
   * @param deepEdges the depth under the face of the occupancy that counts as full, voxel edges: a
   *     multiple of 0.5
   */
  public FaceLine(double edgeMm, double deepEdges) {
    stepMm = edgeMm / STEPS_PER_EDGE;
    deepSteps = (int) Math.round(deepEdges * STEPS_PER_EDGE);
  }

  /**
   * Searches a face on a line; of several it finds the nearest to the start.
   *
   * @param fragment the fragment where it stands
   * @param start a position on the line, world mm
   * @param direction into the fragment, a unit vector in the world
   * @param lowMm where to begin, before the start if negative
   * @param highMm where to end
   * @return whether there is one
   */
  public boolean find(
      SmoothedBits fragment, Vec3 start, Vec3 direction, double lowMm, double highMm) {
    int steps = (int) Math.ceil((highMm - lowMm) / stepMm);
    int last = steps + deepSteps;
    values = values.length > last ? values : new double[last + 1];
    for (int n = 0; n <= last; n++) {
      values[n] = fragment.descent(place(start, direction, lowMm + n * stepMm), normal);
    }
    distanceMm = Double.NaN;
    double before = Double.NaN;
    for (int n = 0; n <= steps; n++) {
      double deep = values[n + deepSteps];
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
    double deepMm = distanceMm + deepSteps * stepMm;
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

  /** {@return the distance of the face from the start, mm} */
  public double distanceMm() {
    return distanceMm;
  }

  /** {@return the occupancy deeper in the fragment: 1 well inside the bone, less near its edges} */
  public double deepOccupancy() {
    return deepOccupancy;
  }

  /** {@return the place on the face, world mm; changed by the next search} */
  public Vec3 point() {
    return point;
  }

  /** {@return the outward normal of the face, a unit vector in the world; changed likewise} */
  public Vec3 normal() {
    return normal;
  }
}
