package org.palpate.proxy.smooth;

import org.palpate.geometry.Vec3;
import org.palpate.proxy.smooth.field.FieldSample;
import org.palpate.proxy.smooth.field.OccupancyField;
import org.palpate.proxy.smooth.field.SeedCell;

/**
 * Intersects a straight segment with the isosurface. Searches backwards from a position inside, by
 * Newton steps. Bisects if a Newton step leaves the bracket or if the steps converge slowly. Most
 * evaluations therefore lie in one window.
 */
final class IsosurfaceIntersection {
  /** The greatest height of the result above the isosurface, in shortest voxel edges. */
  static final double TOLERANCE_EDGES = 0.02;

  /** The height above the isosurface at which Newton steps aim. */
  private static final double AIM_EDGES = 0.01;

  private static final int MAX_ITERATIONS = 60;

  /** The number of Newton steps after which every other iteration bisects. */
  private static final int NEWTON_ITERATIONS = 3;

  private final OccupancyField field;
  private final FieldSample sample;
  private final EdgeUnits units;
  private final WindowBudget budget;
  private final SeedCell seed = new SeedCell();
  private final Vec3 at = new Vec3();
  private final Vec3 vector = new Vec3();
  private Vec3 from;
  private Vec3 to;

  IsosurfaceIntersection(OccupancyField field, EdgeUnits units, WindowBudget budget) {
    this.field = field;
    this.units = units;
    this.budget = budget;
    sample = field.sample();
  }

  /**
   * Returns the fraction of a straight segment at which it meets the isosurface, or a little less.
   * If the work budget is overdrawn, returns the greatest fraction that is known to lie above the
   * isosurface.
   *
   * @param last the fraction at which the search begins; nothing beyond it is visited
   * @return NaN if the segment is not inside at {@code last}
   */
  double find(Vec3 start, Vec3 end, double last) {
    from = start;
    to = end;
    units.vector(from, to, vector);
    double length = vector.length();
    double low = 0;
    double high = last;
    if (!(heightAt(high) < 0)) {
      return Double.NaN;
    }
    double next = last + newtonStepEdges() / length;
    for (int n = 0; (high - low) * length > TOLERANCE_EDGES && isWorthwhile(n); n++) {
      boolean newton = n < NEWTON_ITERATIONS || (n & 1) != 0;
      double fraction = newton && next > low && next < high ? next : 0.5 * (low + high);
      double height = heightAt(fraction);
      if (height < 0) {
        high = fraction;
      } else if (height <= TOLERANCE_EDGES) {
        return fraction;
      } else {
        low = fraction;
      }
      next = fraction + newtonStepEdges() / length;
    }
    return low;
  }

  private boolean isWorthwhile(int iteration) {
    return iteration < MAX_ITERATIONS && !budget.isOverdrawn();
  }

  /** Returns the height above the isosurface at a fraction; infinite where the field is flat. */
  private double heightAt(double fraction) {
    VerifiedMotion.between(from, to, fraction, at);
    field.evaluate(seed.set(at), at);
    return sample.hasNormal() ? sample.heightEdges() : Double.POSITIVE_INFINITY;
  }

  /** Returns the distance along the segment to the height that is aimed at; NaN if unknown. */
  private double newtonStepEdges() {
    if (!sample.hasNormal()) {
      return Double.NaN;
    }
    double fallPerEdge = -vector.dot(sample.normal()) / vector.length();
    return sample.heightEdges() / fallPerEdge - AIM_EDGES;
  }
}
