package org.palpate.carve;

import org.palpate.edit.VoxelWriter;
import org.palpate.geometry.IntBox;

/**
 * Removes voxels within a budget of volume that force and time fill. Removals that follow each
 * other within {@link #STROKE_NANOS} are one stroke of the history.
 *
 * <p>Haptic thread only; allocates nothing.
 */
final class VoxelCutter {
  /** The most voxels of a frame, so that its work is bounded. */
  static final int MOST_VOXELS = 16;

  /** A stroke ends after this time without a cut. */
  static final long STROKE_NANOS = 250_000_000;

  /** The longest time that fills the budget of one frame, so that a late frame cuts no hole. */
  private static final long LONGEST_NANOS = 10_000_000;

  private static final double NANOS_PER_SECOND = 1e9;

  private final CarveSettings settings;
  private final double[] voxelMm3;
  private final double largestMm3;
  private final double smallestMm3;
  private final VoxelWriter out;
  private final IntBox voxel = new IntBox();
  private double budgetMm3;
  private double newton;
  private int removed;
  private long sinceCutNanos = STROKE_NANOS;

  /**
   * Creates a cutter with an empty budget.
   *
   * @param voxelMm3 the volume of a voxel of each segment, mm^3
   * @param out removes the voxels
   */
  VoxelCutter(CarveSettings settings, double[] voxelMm3, VoxelWriter out) {
    this.settings = settings;
    this.voxelMm3 = voxelMm3;
    double largest = 0;
    double smallest = Double.POSITIVE_INFINITY;
    for (double mm3 : voxelMm3) {
      largest = Math.max(largest, mm3);
      smallest = Math.min(smallest, mm3);
    }
    largestMm3 = largest;
    smallestMm3 = smallest;
    this.out = out;
  }

  /**
   * Begins a frame. From earlier frames, at most the volume of the largest voxel is carried over.
   *
   * @param forceNewton the force on the hand, N, at least 0
   * @param nanos the time since the last frame
   * @return whether a voxel may be removed in this frame
   */
  boolean begin(double forceNewton, long nanos) {
    double seconds = Math.max(0, Math.min(LONGEST_NANOS, nanos)) / NANOS_PER_SECOND;
    budgetMm3 = Math.min(budgetMm3, largestMm3);
    budgetMm3 += settings.rateMm3PerNewtonSecond() * forceNewton * seconds;
    newton = forceNewton;
    removed = 0;
    sinceCutNanos += Math.max(0, nanos);
    if (sinceCutNanos >= STROKE_NANOS && !out.history().isMoving()) {
      out.history().endStroke();
    }
    return newton > 0 && budgetMm3 >= smallestMm3 && !out.history().isMoving();
  }

  /**
   * Removes a solid voxel if the force suffices, the voxel is not protected, and the budget covers
   * its volume.
   *
   * @param segment the segment; any number for a voxel that is protected
   * @return whether the frame may remove more
   */
  boolean cut(int segment, int i, int j, int k) {
    if (settings.keeps(i, j, k) || newton < settings.leastNewton(segment)) {
      return true;
    }
    if (removed == MOST_VOXELS || budgetMm3 < voxelMm3[segment]) {
      return false;
    }
    if (out.write(segment, i, j, k, false)) {
      voxel.clear();
      voxel.include(i, j, k);
      out.applied(segment, voxel);
      budgetMm3 -= voxelMm3[segment];
      removed++;
      sinceCutNanos = 0;
    }
    return true;
  }

  /** Returns the number of voxels that the frame has removed. */
  int removed() {
    return removed;
  }
}
