package org.palpate.fracture;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.palpate.geometry.AffineMap;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;
import org.palpate.volume.fracture.PosedBits;

/**
 * The voxel faces of a fragment that face another fragment, and the gap at each. One thread an
 * instance.
 *
 * <p>A straight line along the normal decides whether a face of a rim voxel faces the other
 * fragment. The line must meet that fragment within a reach, and no voxel of its own fragment
 * before. The sum of the area vectors of these faces gives the normal of the fracture. The gap at a
 * face is the distance along that normal from its centre to the other fragment, negative if the
 * centre lies inside it. So a fragment that moves along the normal by d widens the mean gap by d,
 * however rough the surface is.
 */
final class FacingFaces {
  /** The longest gap between facing surfaces, mm. */
  private static final double REACH_MM = 4;

  /** The same in voxels, longest voxel edges; the larger of both counts. */
  private static final double REACH_EDGES = 3;

  /** Steps along a line, shortest voxel edges. */
  private static final double STEP_EDGES = 0.1;

  /** Gaps that exceed the median by more than this belong to cavities, mm. */
  private static final double OUTLIER_MM = 1.5;

  private final PosedBits one;
  private final PosedBits other;
  private final AffineMap oneToOther;
  private final double reachMm;
  private final double stepMm;

  /** The centre of each facing face in grid coordinates, its axis, its sign, and its area. */
  private final List<double[]> faces = new ArrayList<>();

  private final Vec3 normal = new Vec3();
  private double[] gapsMm = new double[0];
  private double[] weightsMm2 = new double[0];

  FacingFaces(PosedBits one, PosedBits other) {
    this.one = one;
    this.other = other;
    oneToOther = other.gridFrom(one.grid(), one.pose());
    GridMetric metric = one.grid().metric();
    Vec3 s = one.grid().spacingMm();
    reachMm = Math.max(REACH_MM, REACH_EDGES * Math.max(s.x, Math.max(s.y, s.z)));
    stepMm = STEP_EDGES * metric.shortestEdgeMm();
    one.bits().forEachRimVoxel(this::addFacesOf);
    if (!faces.isEmpty()) {
      measureGaps();
    }
  }

  /** Whether any face faces the other fragment. */
  boolean isEmpty() {
    return gapsMm.length == 0;
  }

  /** Returns the normal of the fracture towards the other fragment, a unit vector in the world. */
  Vec3 normalWorld() {
    Vec3 world = one.grid().gridMmToWorld().rotate(normal, new Vec3());
    return one.pose().rotation.rotate(world, world);
  }

  /** Returns the mean gap, weighted by the area of the faces across the normal, mm. */
  double meanGapMm() {
    double sum = 0;
    for (int n = 0; n < gapsMm.length; n++) {
      sum += weightsMm2[n] * gapsMm[n];
    }
    return sum / areaMm2(Double.POSITIVE_INFINITY);
  }

  /** Returns the largest gap, mm. */
  double largestGapMm() {
    return Arrays.stream(gapsMm).max().orElse(Double.NaN);
  }

  /** Returns the area across the normal of the faces whose gap is at most a limit, mm^2. */
  double areaMm2(double mostMm) {
    double sum = 0;
    for (int n = 0; n < gapsMm.length; n++) {
      sum += gapsMm[n] <= mostMm ? weightsMm2[n] : 0;
    }
    return sum;
  }

  private void addFacesOf(int i, int j, int k) {
    for (int side = 0; side < 6; side++) {
      int axis = side / 2;
      int sign = side % 2 == 0 ? 1 : -1;
      boolean isCovered =
          one.bits()
              .get(
                  i + (axis == 0 ? sign : 0),
                  j + (axis == 1 ? sign : 0),
                  k + (axis == 2 ? sign : 0));
      if (!isCovered) {
        Vec3 centre = new Vec3(i + 0.5, j + 0.5, k + 0.5);
        Vec3 along = new Vec3();
        along.set(axis, sign / one.grid().spacingMm().get(axis));
        centre.set(axis, centre.get(axis) + 0.5 * sign);
        if (Double.isFinite(distanceMm(centre, along))) {
          add(centre, axis, sign);
        }
      }
    }
  }

  private void add(Vec3 centre, int axis, int sign) {
    Vec3 s = one.grid().spacingMm();
    double area = s.x * s.y * s.z / s.get(axis);
    faces.add(new double[] {centre.x, centre.y, centre.z, axis, sign, area});
    normal.set(axis, normal.get(axis) + sign * area);
  }

  /**
   * Returns the distance from a point on the rim to the other fragment along a line, mm: negative
   * if the point lies inside it, infinite if the line meets the own fragment or nothing in reach.
   *
   * @param along grid coordinates for each mm
   */
  private double distanceMm(Vec3 start, Vec3 along) {
    Vec3 p = new Vec3();
    double first = 0.5 * stepMm;
    boolean isInside = isOther(at(start, along, first, p));
    for (int n = 1; n * stepMm <= reachMm; n++) {
      if (isInside) {
        if (!isOther(at(start, along, first - n * stepMm, p))) {
          return first - (n - 0.5) * stepMm;
        }
      } else if (isOther(at(start, along, first + n * stepMm, p))) {
        return first + (n - 0.5) * stepMm;
      } else if (isSolid(one.bits(), at(start, along, first + (n - 1) * stepMm, p))) {
        return Double.POSITIVE_INFINITY;
      }
    }
    return Double.POSITIVE_INFINITY;
  }

  private static Vec3 at(Vec3 start, Vec3 along, double t, Vec3 dest) {
    return dest.set(start.x + t * along.x, start.y + t * along.y, start.z + t * along.z);
  }

  private boolean isOther(Vec3 p) {
    return isSolid(other.bits(), oneToOther.transform(p, new Vec3()));
  }

  private static boolean isSolid(BitCube bits, Vec3 p) {
    return bits.get((int) Math.floor(p.x), (int) Math.floor(p.y), (int) Math.floor(p.z));
  }

  private void measureGaps() {
    normal.mul(1 / Math.max(Double.MIN_NORMAL, normal.length()), normal);
    Vec3 s = one.grid().spacingMm();
    Vec3 along = new Vec3(normal.x / s.x, normal.y / s.y, normal.z / s.z);
    double[] gaps = new double[faces.size()];
    double[] weights = new double[faces.size()];
    int count = 0;
    for (double[] face : faces) {
      double weight = face[4] * normal.get((int) face[3]) * face[5];
      double gap = distanceMm(new Vec3(face[0], face[1], face[2]), along);
      if (weight > 0 && Double.isFinite(gap)) {
        gaps[count] = gap;
        weights[count++] = weight;
      }
    }
    keepUsual(Arrays.copyOf(gaps, count), weights);
  }

  private void keepUsual(double[] gaps, double[] weights) {
    double[] sorted = gaps.clone();
    Arrays.sort(sorted);
    double mostMm = sorted.length == 0 ? 0 : sorted[sorted.length / 2] + OUTLIER_MM;
    int count = 0;
    for (int n = 0; n < gaps.length; n++) {
      if (gaps[n] <= mostMm) {
        gaps[count] = gaps[n];
        weights[count++] = weights[n];
      }
    }
    gapsMm = Arrays.copyOf(gaps, count);
    weightsMm2 = Arrays.copyOf(weights, count);
  }
}
