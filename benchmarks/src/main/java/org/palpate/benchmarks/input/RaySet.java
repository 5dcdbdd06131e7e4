package org.palpate.benchmarks.input;

import java.util.SplittableRandom;
import org.palpate.device.Trajectory;
import org.palpate.geometry.Vec3;
import org.palpate.raycast.Ray;
import org.palpate.raycast.RayCaster;
import org.palpate.raycast.RayHit;
import org.palpate.volume.BitCube;
import org.palpate.volume.phantom.AnalyticSurface;

/** Seeded rays in grid coordinates that all comparisons of ray casts share. One thread. */
public final class RaySet {
  private static final int DOUBLES_PER_RAY = 6;

  /** The distance that a sliding hand moves from ray to ray, voxels. */
  private static final double SLIDE_SPEED = 0.12;

  private final double[] ends;
  private final Ray ray = new Ray();
  private final RayHit hit = new RayHit();

  private RaySet(double[] ends) {
    this.ends = ends;
  }

  /**
   * Returns rays around a surface.
   *
   * @param kind {@code free}: starts too far above the surface to meet it; {@code near}: starts one
   *     voxel above it, in any direction; {@code hit}: goes straight down from half its length
   *     above it; {@code anywhere}: starts up to thirty voxels above it, in any direction; {@code
   *     slide}: starts at a hand that slides one voxel above the surface, in its direction
   * @param length the length of each ray, voxels
   */
  public static RaySet of(
      AnalyticSurface truth, int edge, String kind, double length, int rays, long seed) {
    double[] ends = new double[DOUBLES_PER_RAY * rays];
    if (kind.equals("slide")) {
      aimAlongTrajectory(
          Trajectories.free(truth, edge, 1, SLIDE_SPEED, rays + 1, seed), length, ends);
    } else {
      new Aim(truth, edge, kind, length, seed).aimAll(ends);
    }
    return new RaySet(ends);
  }

  private static void aimAlongTrajectory(Trajectory hand, double length, double[] ends) {
    Vec3 start = new Vec3();
    Vec3 direction = new Vec3();
    for (int n = 0; n < ends.length / DOUBLES_PER_RAY; n++) {
      hand.position(n + 1, direction).sub(hand.position(n, start), direction);
      put(ends, n, start, direction.mul(length / direction.length(), direction));
    }
  }

  private static void put(double[] ends, int n, Vec3 start, Vec3 direction) {
    for (int axis = 0; axis < 3; axis++) {
      ends[DOUBLES_PER_RAY * n + axis] = start.get(axis);
      ends[DOUBLES_PER_RAY * n + 3 + axis] = start.get(axis) + direction.get(axis);
    }
  }

  /** Returns the number of rays. */
  public int count() {
    return ends.length / DOUBLES_PER_RAY;
  }

  /** Writes ray {@code n} into {@code dest}. */
  public Ray at(int n, Ray dest) {
    int at = DOUBLES_PER_RAY * n;
    return dest.from(ends[at], ends[at + 1], ends[at + 2])
        .to(ends[at + 3], ends[at + 4], ends[at + 5]);
  }

  /** Casts all rays and returns the number of hits. */
  public int hits(RayCaster caster, BitCube bits) {
    int hits = 0;
    for (int n = 0; n < count(); n++) {
      hits += caster.cast(bits, at(n, ray), hit) ? 1 : 0;
    }
    return hits;
  }

  /** Chooses the start and the direction of each ray. */
  private static final class Aim {
    private final AnalyticSurface truth;
    private final int edge;
    private final String kind;
    private final double length;
    private final SplittableRandom random;
    private final Vec3 start = new Vec3();
    private final Vec3 direction = new Vec3();
    private final Vec3 normal = new Vec3();

    Aim(AnalyticSurface truth, int edge, String kind, double length, long seed) {
      this.truth = truth;
      this.edge = edge;
      this.kind = kind;
      this.length = length;
      random = new SplittableRandom(seed);
    }

    void aimAll(double[] ends) {
      for (int n = 0; n < ends.length / DOUBLES_PER_RAY; n++) {
        aim();
        put(ends, n, start, direction);
      }
    }

    private void aim() {
      start.set(edge * random.nextDouble(), edge * random.nextDouble(), edge * random.nextDouble());
      lift(
          switch (kind) {
            case "free" -> length + 4;
            case "hit" -> length / 2;
            case "anywhere" -> 30 * random.nextDouble();
            case "near" -> 1;
            default -> throw new IllegalArgumentException("no such kind of ray: " + kind);
          });
      direct();
    }

    /** Moves the start to a height above the surface. */
    private void lift(double above) {
      truth.normal(start, normal);
      start.add(normal.mul(above - truth.signedDistance(start), normal), start);
      truth.normal(start, normal);
    }

    private void direct() {
      if (kind.equals("hit")) {
        normal.mul(-length, direction);
        return;
      }
      do {
        direction.set(
            random.nextDouble() - 0.5, random.nextDouble() - 0.5, random.nextDouble() - 0.5);
      } while (direction.length() < 0.05);
      direction.mul(length / direction.length(), direction);
    }
  }
}
