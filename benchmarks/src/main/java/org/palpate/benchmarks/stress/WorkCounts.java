package org.palpate.benchmarks.stress;

import java.util.Arrays;
import java.util.List;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.exact.GuardedSolver;
import org.palpate.proxy.smooth.SmoothSolver;
import org.palpate.volume.BitCube;

/**
 * Counts the work of frames in units that are the same on every machine: a word of voxels read (64
 * voxels or 64 bricks), a path tried, a step up tested, a value of the smooth field, a column that
 * it interpolated. One thread.
 */
final class WorkCounts {
  private final CountingCube bits;
  private final CollisionScene scene;
  private final GuardedSolver guarded;
  private final SmoothSolver smooth;
  private final InteractionPoint point = new InteractionPoint();
  private long[] counts = new long[1024];
  private int frames;
  private int mostWindows;

  /** The voxel that was edited last. */
  private final IntBox edited = new IntBox();

  /** Creates counts of a solver in a scene, from a free start. */
  WorkCounts(
      StressSession.Attacked attacked,
      BitCube solids,
      GridMetric metric,
      double maxStepMm,
      Vec3 start) {
    bits = new CountingCube(solids);
    scene = new CollisionScene(List.of(bits));
    guarded =
        attacked == StressSession.Attacked.GUARDED ? new GuardedSolver(metric, maxStepMm) : null;
    smooth = attacked == StressSession.Attacked.SMOOTH ? new SmoothSolver(metric, maxStepMm) : null;
    point.position.set(start);
  }

  /** Returns the position of the interaction point. */
  Vec3 position() {
    return point.position;
  }

  /** Makes a voxel empty; the next frame feels it. */
  void clear(int i, int j, int k) {
    bits.clear(i, j, k);
    if (guarded != null) {
      guarded.reset();
    } else {
      edited.clear();
      edited.include(i, j, k);
      smooth.resetAfterEdit(edited);
    }
  }

  /** Runs one frame and counts its work. */
  void follow(Vec3 device) {
    long before = bits.words();
    long steps;
    if (guarded != null) {
      guarded.follow(scene, device, point);
      steps = guarded.steps();
    } else {
      smooth.follow(scene, device, point);
      steps = smooth.steps();
      mostWindows = Math.max(mostWindows, smooth.windows());
    }
    add(steps + bits.words() - before);
  }

  private void add(long steps) {
    if (frames == counts.length) {
      counts = Arrays.copyOf(counts, 2 * frames);
    }
    counts[frames++] = steps;
  }

  /** Returns the counts so far, without the solver and its caches. */
  Result result() {
    return new Result(Arrays.copyOf(counts, frames), mostWindows);
  }

  /**
   * The counts of some frames.
   *
   * @param counts the work of each frame, in order
   * @param mostWindows the most windows of voxels that a frame of {@code smooth} read; 0 for others
   */
  @SuppressWarnings("ArrayRecordComponent") // nobody compares results
  record Result(long[] counts, int mostWindows) {}
}
