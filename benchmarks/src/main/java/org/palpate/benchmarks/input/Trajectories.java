package org.palpate.benchmarks.input;

import java.util.SplittableRandom;
import java.util.function.ToDoubleFunction;
import org.palpate.device.Trajectory;
import org.palpate.geometry.Vec3;
import org.palpate.volume.phantom.AnalyticSurface;

/**
 * Seeded trajectories of a hand that all comparisons share, bit-identical on every JDK. Positions
 * are in grid coordinates, speeds in voxels per frame, depths in voxels below the true surface.
 */
public final class Trajectories {
  /** The height above the surface at which a pressing hand starts. */
  private static final double CLEARANCE_VOXELS = 6;

  /** The speed at which it comes down. */
  private static final double APPROACH_SPEED = 0.5;

  /** The sideways drift as a fraction of the motion. */
  private static final double DRIFT = 0.05;

  /** A sliding hand turns back at this fraction of the edge before a face of the grid. */
  private static final double MARGIN_FRACTION = 0.06;

  /** Number of projections to a surface that leave only rounding and curvature errors. */
  private static final int PROJECTIONS = 3;

  /** The period at which these trajectories are followed. */
  private static final double FRAME_MS = 1;

  private Trajectories() {}

  /** Comes down to a depth and slides at that depth over the surface, with a drift. */
  public static Trajectory slide(
      AnalyticSurface truth, int edge, double depth, double speed, int frames, long seed) {
    Hand hand = new Hand(truth, edge, seed);
    hand.startAbove(CLEARANCE_VOXELS);
    double above = CLEARANCE_VOXELS;
    double[] xyz = new double[3 * frames];
    for (int frame = 0; frame < frames; frame++) {
      if (above > -depth) {
        above = Math.max(-depth, above - APPROACH_SPEED);
        hand.keepAt(above);
      } else {
        hand.slide(speed, -depth);
      }
      hand.write(xyz, frame);
    }
    return Trajectory.ofPositions(xyz, FRAME_MS);
  }

  /** Presses straight in to a depth and out again, repeatedly and each time elsewhere. */
  public static Trajectory approach(
      AnalyticSurface truth, int edge, double depth, double speed, int frames, long seed) {
    Hand hand = new Hand(truth, edge, seed);
    double travel = CLEARANCE_VOXELS + depth;
    double along = 2 * travel;
    double[] xyz = new double[3 * frames];
    for (int frame = 0; frame < frames; frame++) {
      along += speed;
      if (along >= 2 * travel) {
        along = 0;
        hand.startAbove(CLEARANCE_VOXELS);
      }
      hand.keepAt(Math.abs(along - travel) - depth);
      hand.write(xyz, frame);
    }
    return Trajectory.ofPositions(xyz, FRAME_MS);
  }

  /** Rakes at a depth back and forth over the same twenty voxels, along the voxel steps. */
  public static Trajectory grooves(
      AnalyticSurface truth, int edge, double depth, double speed, int frames, long seed) {
    Hand hand = new Hand(truth, edge, seed);
    hand.startAbove(-depth);
    double[] xyz = new double[3 * frames];
    double along = 0;
    double direction = 1;
    for (int frame = 0; frame < frames; frame++) {
      along += speed;
      if (along > 20) {
        along = 0;
        direction = -direction;
      }
      hand.rake(direction * speed, -depth);
      hand.write(xyz, frame);
    }
    return Trajectory.ofPositions(xyz, FRAME_MS);
  }

  /** Slides above the surface and touches nothing. */
  public static Trajectory free(
      AnalyticSurface truth, int edge, double above, double speed, int frames, long seed) {
    return slide(truth, edge, -above, speed, frames, seed);
  }

  /** Jumps 5 to 50 voxels per frame, anywhere in the grid and slightly outside. */
  public static Trajectory jumps(int sizeX, int sizeY, int sizeZ, int frames, long seed) {
    return travel(sizeX, sizeY, sizeZ, frames, seed, random -> 5 + 45 * random.nextDouble());
  }

  /** Moves between random positions at a constant speed, through solids as well. */
  public static Trajectory wander(
      int sizeX, int sizeY, int sizeZ, double speed, int frames, long seed) {
    return travel(sizeX, sizeY, sizeZ, frames, seed, random -> speed);
  }

  private static Trajectory travel(
      int sizeX,
      int sizeY,
      int sizeZ,
      int frames,
      long seed,
      ToDoubleFunction<SplittableRandom> speed) {
    SplittableRandom random = new SplittableRandom(seed);
    double[] xyz = new double[3 * frames];
    Vec3 at = anywhere(random, sizeX, sizeY, sizeZ);
    Vec3 goal = anywhere(random, sizeX, sizeY, sizeZ);
    Vec3 way = new Vec3();
    for (int frame = 0; frame < frames; frame++) {
      if (step(at, goal, way, speed.applyAsDouble(random))) {
        goal = anywhere(random, sizeX, sizeY, sizeZ);
      }
      put(xyz, frame, at);
    }
    return Trajectory.ofPositions(xyz, FRAME_MS);
  }

  /** Returns the same surface touched from within, behind a wall of one voxel. */
  public static AnalyticSurface fromWithin(AnalyticSurface outside) {
    return new AnalyticSurface() {
      @Override
      public double signedDistance(Vec3 grid) {
        return -(outside.signedDistance(grid) + 1);
      }

      @Override
      public Vec3 normal(Vec3 grid, Vec3 dest) {
        outside.normal(grid, dest);
        return dest.mul(-1, dest);
      }
    };
  }

  /** Steps towards the goal and returns whether it is reached. */
  private static boolean step(Vec3 at, Vec3 goal, Vec3 way, double speed) {
    goal.sub(at, way);
    double left = way.length();
    if (left <= speed) {
      at.set(goal);
      return true;
    }
    at.add(way.mul(speed / left, way), at);
    return false;
  }

  private static Vec3 anywhere(SplittableRandom random, int sizeX, int sizeY, int sizeZ) {
    return new Vec3(
        sizeX * (random.nextDouble() * 1.1 - 0.05),
        sizeY * (random.nextDouble() * 1.1 - 0.05),
        sizeZ * (random.nextDouble() * 1.1 - 0.05));
  }

  private static void put(double[] xyz, int frame, Vec3 at) {
    xyz[3 * frame] = at.x;
    xyz[3 * frame + 1] = at.y;
    xyz[3 * frame + 2] = at.z;
  }

  /** A hand on a surface. */
  private static final class Hand {
    private final AnalyticSurface truth;
    private final int edge;
    private final SplittableRandom random;
    private final Vec3 at = new Vec3();
    private final Vec3 heading = new Vec3();
    private final Vec3 normal = new Vec3();

    Hand(AnalyticSurface truth, int edge, long seed) {
      this.truth = truth;
      this.edge = edge;
      random = new SplittableRandom(seed);
    }

    void startAbove(double above) {
      do {
        at.set(place(), place(), place());
      } while (Math.abs(truth.signedDistance(at)) > 0.1 * edge);
      heading.set(random.nextDouble() - 0.5, random.nextDouble() - 0.5, random.nextDouble() - 0.5);
      keepAt(above);
    }

    private double place() {
      return edge * (0.15 + 0.7 * random.nextDouble());
    }

    void keepAt(double above) {
      for (int n = 0; n < PROJECTIONS; n++) {
        double offset = above - truth.signedDistance(at);
        truth.normal(at, normal);
        at.add(normal.mul(offset, normal), at);
      }
    }

    void slide(double speed, double above) {
      heading.x += DRIFT * speed * (random.nextDouble() - 0.5);
      heading.y += DRIFT * speed * (random.nextDouble() - 0.5);
      heading.z += DRIFT * speed * (random.nextDouble() - 0.5);
      turnBackAtTheMargin();
      alignHeading();
      at.add(heading.mul(speed, normal), at);
      keepAt(above);
    }

    void rake(double step, double above) {
      alignHeading();
      at.add(heading.mul(step, normal), at);
      keepAt(above);
    }

    private void alignHeading() {
      truth.normal(at, normal);
      heading.sub(normal.mul(heading.dot(normal), normal), heading);
      heading.mul(1 / heading.length(), heading);
    }

    private void turnBackAtTheMargin() {
      for (int axis = 0; axis < 3; axis++) {
        double margin = MARGIN_FRACTION * edge;
        if (at.get(axis) < margin) {
          heading.set(axis, Math.abs(heading.get(axis)));
        } else if (at.get(axis) > edge - margin) {
          heading.set(axis, -Math.abs(heading.get(axis)));
        }
      }
    }

    void write(double[] xyz, int frame) {
      put(xyz, frame, at);
    }
  }
}
