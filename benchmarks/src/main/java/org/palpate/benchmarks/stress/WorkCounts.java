package org.palpate.benchmarks.stress;

import java.util.Arrays;
import java.util.List;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.exact.GuardedSolver;
import org.palpate.proxy.smooth.SmoothSolver;
import org.palpate.volume.BitCube;

/**
 * The work of frames in steps, the same on every machine: a step is a word of voxels that is read
 * (of 64 voxels or of 64 bricks), a way that is tried, a stair that is looked at, a value of the
 * smooth surface. One thread.
 */
final class WorkCounts {
  private final CountingCube bits;
  private final CollisionScene obstacles;
  private final GuardedSolver guarded;
  private final SmoothSolver smooth;
  private final InteractionPoint point = new InteractionPoint();
  private long[] counts = new long[1024];
  private int frames;

  /** Counts what a solver does in a scene, from a free start. */
  WorkCounts(
      StressSession.Attacked who, BitCube solids, GridMetric metric, double maxStepMm, Vec3 start) {
    bits = new CountingCube(solids);
    obstacles = new CollisionScene(List.of(bits));
    guarded = who == StressSession.Attacked.GUARDED ? new GuardedSolver(metric, maxStepMm) : null;
    smooth = who == StressSession.Attacked.SMOOTH ? new SmoothSolver(metric, maxStepMm) : null;
    point.position.set(start);
  }

  /** Where the point is. */
  Vec3 position() {
    return point.position;
  }

  /** One frame. */
  void follow(Vec3 device) {
    long before = bits.words();
    long steps;
    if (guarded != null) {
      guarded.follow(obstacles, device, point);
      steps = guarded.steps();
    } else {
      smooth.follow(obstacles, device, point);
      steps = smooth.steps();
    }
    add(steps + bits.words() - before);
  }

  private void add(long steps) {
    if (frames == counts.length) {
      counts = Arrays.copyOf(counts, 2 * frames);
    }
    counts[frames++] = steps;
  }

  /** What each frame took, in order. */
  long[] counts() {
    return Arrays.copyOf(counts, frames);
  }
}
