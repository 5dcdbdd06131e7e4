package org.palpate.benchmarks.input;

import java.util.SplittableRandom;
import org.palpate.device.Trajectory;
import org.palpate.geometry.Vec3;
import org.palpate.raycast.Ray;
import org.palpate.raycast.RayCaster;
import org.palpate.raycast.RayHit;
import org.palpate.volume.BitCube;
import org.palpate.volume.phantom.AnalyticSurface;

/** Rays that all comparisons of ray casts share: seeded, in grid coordinates. One thread. */
public final class RaySet {
  private static final int DOUBLES_A_RAY = 6;

  /** How far a hand that slides goes from ray to ray, voxels. */
  private static final double SLIDE_SPEED = 0.12;

  private final double[] ends;
  private final Ray ray = new Ray();
  private final RayHit hit = new RayHit();

  private RaySet(double[] ends) {
    this.ends = ends;
  }

  /**
   * Rays round a surface.
   *
   * @param place {@code free}: too far above the surface to meet it; {@code near}: from one voxel
   *     above it in any direction; {@code hit}: straight down from half the length above it; {@code
   *     anywhere}: from up to thirty voxels above it in any direction; {@code slide}: where a hand
   *     is that slides along one voxel above the surface, the way that it goes
   * @param length of each, voxels
   */
  public static RaySet of(
      AnalyticSurface truth, int edge, String place, double length, int rays, long seed) {
    double[] ends = new double[DOUBLES_A_RAY * rays];
    if (place.equals("slide")) {
      aimAlongTrajectory(
          Trajectories.free(truth, edge, 1, SLIDE_SPEED, rays + 1, seed), length, ends);
    } else {
      new Aim(truth, edge, place, length, seed).aimAll(ends);
    }
    return new RaySet(ends);
  }

  private static void aimAlongTrajectory(Trajectory hand, double length, double[] ends) {
    Vec3 start = new Vec3();
    Vec3 way = new Vec3();
    for (int n = 0; n < ends.length / DOUBLES_A_RAY; n++) {
      hand.position(n + 1, way).sub(hand.position(n, start), way);
      put(ends, n, start, way.mul(length / way.length(), way));
    }
  }

  private static void put(double[] ends, int n, Vec3 start, Vec3 way) {
    for (int axis = 0; axis < 3; axis++) {
      ends[DOUBLES_A_RAY * n + axis] = start.get(axis);
      ends[DOUBLES_A_RAY * n + 3 + axis] = start.get(axis) + way.get(axis);
    }
  }

  public int count() {
    return ends.length / DOUBLES_A_RAY;
  }

  /** Writes ray {@code n} into {@code dest}. */
  public Ray at(int n, Ray dest) {
    int at = DOUBLES_A_RAY * n;
    return dest.from(ends[at], ends[at + 1], ends[at + 2])
        .to(ends[at + 3], ends[at + 4], ends[at + 5]);
  }

  /** Casts all. */
  public int hits(RayCaster caster, BitCube bits) {
    int hits = 0;
    for (int n = 0; n < count(); n++) {
      hits += caster.cast(bits, at(n, ray), hit) ? 1 : 0;
    }
    return hits;
  }

  /** Where a ray starts and which way it goes. */
  private static final class Aim {
    private final AnalyticSurface truth;
    private final int edge;
    private final String place;
    private final double length;
    private final SplittableRandom random;
    private final Vec3 start = new Vec3();
    private final Vec3 way = new Vec3();
    private final Vec3 normal = new Vec3();

    Aim(AnalyticSurface truth, int edge, String place, double length, long seed) {
      this.truth = truth;
      this.edge = edge;
      this.place = place;
      this.length = length;
      random = new SplittableRandom(seed);
    }

    void aimAll(double[] ends) {
      for (int n = 0; n < ends.length / DOUBLES_A_RAY; n++) {
        aim();
        put(ends, n, start, way);
      }
    }

    private void aim() {
      start.set(edge * random.nextDouble(), edge * random.nextDouble(), edge * random.nextDouble());
      lift(
          switch (place) {
            case "free" -> length + 4;
            case "hit" -> length / 2;
            case "anywhere" -> 30 * random.nextDouble();
            case "near" -> 1;
            default -> throw new IllegalArgumentException("no such place: " + place);
          });
      direct();
    }

    /** Puts the start so far above the surface. */
    private void lift(double above) {
      truth.normal(start, normal);
      start.add(normal.mul(above - truth.signedDistance(start), normal), start);
      truth.normal(start, normal);
    }

    private void direct() {
      if (place.equals("hit")) {
        normal.mul(-length, way);
        return;
      }
      do {
        way.set(random.nextDouble() - 0.5, random.nextDouble() - 0.5, random.nextDouble() - 0.5);
      } while (way.length() < 0.05);
      way.mul(length / way.length(), way);
    }
  }
}
