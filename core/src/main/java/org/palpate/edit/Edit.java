package org.palpate.edit;

import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.volume.VoxelGrid;

/**
 * A change of a segment's voxels, made by any thread, put into an {@link EditQueue}, carried out by
 * the haptic thread between frames. An instance is queued once.
 */
public abstract sealed class Edit permits VoxelEdit, BrushEdit, SwapEdit, GreyEdit {
  private final int segment;
  private volatile boolean done;

  Edit(int segment) {
    this.segment = segment;
  }

  /** Which of the obstacles it changes, in the order in which they were given. */
  public final int segment() {
    return segment;
  }

  /** Whether all of it has been carried out; what was written before is then seen. Any thread. */
  public final boolean isDone() {
    return done;
  }

  /**
   * Carries out some of it. Haptic thread.
   *
   * @param voxels how many voxels it may look at, at least 1
   * @return how many it looked at, at least 1
   */
  abstract int apply(CollisionScene obstacles, int voxels);

  /**
   * Refuses what does not fit the grid, in the thread that queues.
   *
   * @throws IllegalArgumentException with the values
   */
  abstract void check(VoxelGrid grid, GridMetric gridMetric);

  final void finish() {
    done = true;
  }
}
