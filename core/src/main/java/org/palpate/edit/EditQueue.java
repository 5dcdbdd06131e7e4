package org.palpate.edit;

import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.AtomicReferenceArray;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.volume.VoxelGrid;

/**
 * Edits on their way from any thread to the haptic thread, which alone changes bits, between
 * frames. Bounded; offering never waits, and neither does the haptic thread, which allocates
 * nothing here.
 */
public final class EditQueue {
  /** Edits that wait at most. */
  public static final int DEFAULT_CAPACITY = 1024;

  private final VoxelGrid grid;
  private final GridMetric metric;
  private final int segments;
  private final AtomicReferenceArray<Edit> slots;
  private final AtomicLong offered = new AtomicLong();
  private final AtomicLong taken = new AtomicLong();

  public EditQueue(VoxelGrid grid, int segments) {
    this(grid, segments, DEFAULT_CAPACITY);
  }

  /**
   * A queue for edits of obstacles over one grid.
   *
   * @param segments how many obstacles there are
   * @param capacity how many edits may wait, at least 1
   */
  public EditQueue(VoxelGrid grid, int segments, int capacity) {
    this.grid = grid;
    metric = GridMetric.of(grid.spacingMm());
    this.segments = segments;
    slots = new AtomicReferenceArray<>(capacity);
  }

  /**
   * Queues an edit. Any thread; edits of one thread are carried out in their order.
   *
   * @return false where the queue is full; try again later
   * @throws IllegalArgumentException where the edit does not fit the grid or the segments
   */
  public boolean offer(Edit edit) {
    if (edit.segment() < 0 || edit.segment() >= segments) {
      throw new IllegalArgumentException(
          "no such segment: segment=" + edit.segment() + " segments=" + segments);
    }
    edit.check(grid, metric);
    while (true) {
      long at = offered.get();
      if (at - taken.get() >= slots.length()) {
        return false;
      }
      if (offered.compareAndSet(at, at + 1)) {
        slots.set((int) (at % slots.length()), edit);
        return true;
      }
    }
  }

  /** Edits that were carried out wholly. Any thread. */
  public long done() {
    return taken.get();
  }

  /** Whether edits wait or are under way. Any thread. */
  public boolean isIdle() {
    return offered.get() == taken.get();
  }

  /**
   * Carries out waiting edits. Haptic thread.
   *
   * @param voxels how many voxels may be looked at
   * @return whether any bit may have changed
   */
  public boolean applyTo(CollisionScene obstacles, int voxels) {
    int left = voxels;
    while (left > 0) {
      int slot = (int) (taken.getPlain() % slots.length());
      Edit edit = slots.get(slot);
      if (edit == null) {
        break;
      }
      left -= edit.apply(obstacles, left);
      if (edit.isDone()) {
        slots.set(slot, null);
        taken.setRelease(taken.getPlain() + 1);
      }
    }
    return left < voxels;
  }
}
