package org.palpate.fracture;

import java.util.ArrayList;
import java.util.List;
import org.palpate.geometry.Vec3;
import org.palpate.volume.fracture.PosedBits;

/**
 * Measures the step-off of a fracture: the displacement of one fragment's skin against the other's,
 * fitted by least squares. One thread an instance.
 *
 * <p>Each pair has a skin point p of the one fragment and a skin point q of the other. Both lie
 * equally far from the fracture, and near it, so that a bone that bends looks like a step as little
 * as can be. There the fracture changes the smoothed skin. So a skin lies where the occupancy is
 * half of that deeper in the bone, see {@link FaceLine}, which the fracture lowers alike. Let n be
 * the direction half way between their normals. On a straight skin, and on a circular one, (p - q)
 * n is the component of the displacement along n. The step-off is the length of the displacement
 * that fits the pairs best; it is 0 for skins that continue each other. A direction is left out if
 * the normals hardly point along it.
 *
 * <p>Some pairs do not belong to one skin: walls of marrow spaces, and where a bone ends or
 * branches. Skins with a solid close above them are left out, and pairs that contradict the others
 * lose their weight.
 *
 * <p>Reference: Rusinkiewicz, A symmetric objective function for ICP, 2019, for the pairs.
 */
final class StepOff {
  /** The distance of skin points from the fracture, voxel edges. */
  private static final double NEAREST_EDGES = 1.5;

  private static final double FARTHEST_EDGES = 6;

  /** The standard deviation of the smoothing, voxels. */
  private static final double SIGMA = 1;

  /** The depth under a skin of the occupancy that counts as full, voxel edges. */
  private static final double DEEP_EDGES = 1;

  /** The largest distance of a skin from the centre of its rim voxel, voxel edges. */
  private static final double RIM_EDGES = 2;

  /** The largest step that is found, mm. */
  private static final double MOST_MM = 4;

  /** The skin's normal lies across that of the fracture: the largest cosine between them. */
  private static final double SKIN_COSINE = 0.5;

  /** The least cosine between normals of the two skins. */
  private static final double SAME_SKIN_COSINE = 0.7;

  /** A direction counts if its share of the squared normals is at least this. */
  private static final double LEAST_SHARE = 0.05;

  /** The depth under a skin at which the other fragment may follow, voxel edges. */
  private static final int UNDER_SKIN_EDGES = 3;

  /** The height above a skin within which nothing lies, voxel edges, and where it begins. */
  private static final double OPEN_EDGES = 10;

  private static final double ABOVE_EDGES = 1.5;
  private static final double RISE_EDGES = 0.5;

  /** Pairs that are farther off than this count less, voxel edges: at first and at last. */
  private static final double WIDE_EDGES = 1.5;

  private static final double NARROW_EDGES = 0.3;
  private static final double NARROWING = 0.8;
  private static final int ROUNDS = 12;

  private static final double WALK_EDGES = 0.25;
  private static final int LEAST_PAIRS = 20;

  private final PosedBits one;
  private final SmoothedBits own;
  private final SmoothedBits facing;
  private final Vec3 across;
  private final double gapMm;
  private final double edgeMm;
  private final FaceLine line;
  private final Vec3 u = new Vec3();
  private final Vec3 v = new Vec3();
  private final List<Pair> pairs = new ArrayList<>();

  /** The displacement along u and v that fits so far. */
  private double alongU;

  private double alongV;

  /**
   * A pair of skin points.
   *
   * @param u the component of the direction half way between the normals along u
   * @param v the same along v
   * @param offMm the distance of the points along that direction
   */
  private record Pair(double u, double v, double offMm) {}

  /**
   * Prepares a measurement.
   *
   * @param across the normal of the fracture from the one fragment to the other, world
   * @param gapMm the mean gap
   */
  StepOff(PosedBits one, PosedBits other, Vec3 across, double gapMm) {
    this.one = one;
    this.across = across;
    this.gapMm = gapMm;
    own = new SmoothedBits(one, SIGMA);
    facing = new SmoothedBits(other, SIGMA);
    Vec3 s = one.grid().spacingMm();
    edgeMm = Math.max(s.x, Math.max(s.y, s.z));
    line = new FaceLine(edgeMm, DEEP_EDGES);
    Vec3 least = Math.abs(across.x) < 0.6 ? new Vec3(1, 0, 0) : new Vec3(0, 1, 0);
    across.cross(least, u);
    u.mul(1 / u.length(), u);
    across.cross(u, v);
  }

  /** Returns the step-off, mm; NaN if too little skin lies on both sides of the fracture. */
  double measure() {
    Vec3 p = new Vec3();
    one.bits()
        .forEachRimVoxel(
            (i, j, k) -> {
              one.grid().gridToWorld(p.set(i + 0.5, j + 0.5, k + 0.5), p);
              add(one.pose().transform(p, p));
            });
    return pairs.size() < LEAST_PAIRS ? Double.NaN : solve();
  }

  private void add(Vec3 rim) {
    double depth = depthMm(rim);
    if (!(depth >= NEAREST_EDGES * edgeMm && depth <= FARTHEST_EDGES * edgeMm)) {
      return;
    }
    Vec3 normal = new Vec3();
    own.occupancy(rim, normal);
    if (isOpen(rim, normal) && isFollowed(rim, depth, normal) && findSkin(rim, normal)) {
      Vec3 p = new Vec3().set(line.point());
      Vec3 start = along(p, 2 * depth + gapMm, new Vec3());
      if (findFace(facing, start, normal, MOST_MM)
          && normal.dot(line.normal()) >= SAME_SKIN_COSINE
          && isDeep(line.point(), line.normal())) {
        addPair(p, line.point(), normal, line.normal());
      }
    }
  }

  /**
   * Finds the skin at a rim voxel: along the normal there, and then along the normal of what was
   * found.
   *
   * @param normal the outward normal at the voxel; receives that of the skin
   */
  private boolean findSkin(Vec3 rim, Vec3 normal) {
    for (int round = 0; round < 2; round++) {
      if (!findFace(own, rim, normal, RIM_EDGES * edgeMm)) {
        return false;
      }
      normal.set(line.normal());
    }
    return Math.abs(normal.dot(across)) <= SKIN_COSINE;
  }

  /** Searches the face of a fragment on a line against an outward direction. */
  private boolean findFace(SmoothedBits fragment, Vec3 start, Vec3 outward, double mostMm) {
    return line.find(fragment, start, outward.mul(-1, new Vec3()), -mostMm, mostMm);
  }

  /** Returns the distance from a rim voxel to the fracture along its normal, mm; NaN if far. */
  private double depthMm(Vec3 rim) {
    Vec3 p = new Vec3();
    double step = WALK_EDGES * edgeMm;
    for (double depth = 0; depth <= FARTHEST_EDGES * edgeMm; depth += step) {
      if (!own.isSolid(along(rim, depth, p))) {
        return depth;
      }
    }
    return Double.NaN;
  }

  /** Whether nothing lies close above a point of the rim, as in a marrow space. */
  private boolean isOpen(Vec3 rim, Vec3 outward) {
    Vec3 p = new Vec3();
    for (double h = ABOVE_EDGES; h <= OPEN_EDGES; h += RISE_EDGES) {
      shifted(rim, outward, h * edgeMm, p);
      if (own.isSolid(p) || facing.isSolid(p)) {
        return false;
      }
    }
    return true;
  }

  /** Whether the other fragment follows after the gap, under the skin too if not behind it. */
  private boolean isFollowed(Vec3 rim, double depth, Vec3 outward) {
    double most = depth + Math.max(0, gapMm) + MOST_MM;
    Vec3 start = new Vec3();
    Vec3 p = new Vec3();
    for (int under = 0; under <= UNDER_SKIN_EDGES; under++) {
      shifted(rim, outward, -under * edgeMm, start);
      for (double t = depth; t <= most; t += WALK_EDGES * edgeMm) {
        if (facing.isSolid(along(start, t, p))) {
          return true;
        }
      }
    }
    return false;
  }

  /**
   * Whether a point of the other skin is as far from the fracture as points of this skin must be.
   */
  private boolean isDeep(Vec3 skin, Vec3 outward) {
    Vec3 start = shifted(skin, outward, -edgeMm, new Vec3());
    Vec3 p = new Vec3();
    for (double t = 0; t <= NEAREST_EDGES * edgeMm; t += WALK_EDGES * edgeMm) {
      if (!facing.isSolid(along(start, -t, p))) {
        return false;
      }
    }
    return true;
  }

  private Vec3 along(Vec3 start, double t, Vec3 dest) {
    return dest.set(start.x + t * across.x, start.y + t * across.y, start.z + t * across.z);
  }

  private static Vec3 shifted(Vec3 start, Vec3 normal, double h, Vec3 dest) {
    return dest.set(start.x + h * normal.x, start.y + h * normal.y, start.z + h * normal.z);
  }

  private void addPair(Vec3 p, Vec3 q, Vec3 normal, Vec3 otherNormal) {
    Vec3 n = normal.add(otherNormal, new Vec3());
    n.mul(1 / n.length(), n);
    pairs.add(new Pair(n.dot(u), n.dot(v), p.sub(q, new Vec3()).dot(n)));
  }

  /** Returns the length of the displacement in the directions that the skins determine. */
  private double solve() {
    double edges = Double.POSITIVE_INFINITY;
    for (int round = 0; round < ROUNDS; round++) {
      fit(edges * edgeMm);
      edges = Math.max(NARROW_EDGES, Math.min(WIDE_EDGES, edges * NARROWING));
    }
    return Math.sqrt(alongU * alongU + alongV * alongV);
  }

  /** Fits the displacement, with weights that fall with the distance from the last one. */
  private void fit(double widthMm) {
    double uu = 0;
    double uv = 0;
    double vv = 0;
    double ur = 0;
    double vr = 0;
    for (Pair pair : pairs) {
      double off = (pair.offMm - alongU * pair.u - alongV * pair.v) / widthMm;
      double weight = 1 / ((1 + off * off) * (1 + off * off));
      uu += weight * pair.u * pair.u;
      uv += weight * pair.u * pair.v;
      vv += weight * pair.v * pair.v;
      ur += weight * pair.u * pair.offMm;
      vr += weight * pair.v * pair.offMm;
    }
    double mean = (uu + vv) / 2;
    double half = Math.sqrt((uu - vv) * (uu - vv) / 4 + uv * uv);
    double angle = 0.5 * StrictMath.atan2(2 * uv, uu - vv);
    double c = StrictMath.cos(angle);
    double s = StrictMath.sin(angle);
    double along = (c * ur + s * vr) / (mean + half);
    double beside = mean - half < LEAST_SHARE * 2 * mean ? 0 : (c * vr - s * ur) / (mean - half);
    alongU = c * along - s * beside;
    alongV = s * along + c * beside;
  }
}
