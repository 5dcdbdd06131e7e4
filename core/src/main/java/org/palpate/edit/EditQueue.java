package org.palpate.edit;

import java.util.Collections;
import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.AtomicReferenceArray;
import org.palpate.volume.VoxelGrid;

/**
 * A bounded queue of edits from any thread to the haptic thread, which alone changes voxels and
 * does so between frames. No thread waits. The haptic thread allocates nothing here.
 */
public final class EditQueue {
  /** The default number of edits that may wait. */
  public static final int DEFAULT_CAPACITY = 1024;

  /** The largest number of edits that one frame applies, because even a small edit takes time. */
  static final int MOST_EDITS_A_FRAME = 32;

  private static final long NO_STROKE = -1;

  private final SegmentGrids grids;
  private final boolean swaps;
  private final AtomicReferenceArray<Edit> slots;
  private final AtomicLong offered = new AtomicLong();
  private final AtomicLong taken = new AtomicLong();

  /** Whether the oldest edit is applied in part; haptic thread. */
  private boolean inProgress;

  /** The number of ended strokes before and after the last edit that made one; haptic thread. */
  private long strokesBefore;

  private long strokesAfter = NO_STROKE;

  /**
   * Makes a queue of the usual capacity.
   *
   * @param grid the grid of every segment
   * @param segments number of segments in the scene
   */
  public EditQueue(VoxelGrid grid, int segments) {
    this(grid, segments, DEFAULT_CAPACITY);
  }

  /**
   * Makes a queue for edits of a scene over one grid.
   *
   * @param grid the grid of every segment
   * @param segments number of segments in the scene
   * @param capacity number of edits that may wait, at least 1
   */
  public EditQueue(VoxelGrid grid, int segments, int capacity) {
    this(Collections.nCopies(segments, grid), capacity, true);
  }

  /**
   * {@return a queue for bodies} It refuses a {@link SwapEdit}, because a body never changes its
   * cube.
   *
   * @param grids the grid of each body, whose index is that of the segment
   */
  public static EditQueue ofBodies(List<VoxelGrid> grids) {
    return new EditQueue(grids, DEFAULT_CAPACITY, false);
  }

  private EditQueue(List<VoxelGrid> grids, int capacity, boolean swaps) {
    this.grids = new SegmentGrids(grids);
    this.swaps = swaps;
    slots = new AtomicReferenceArray<>(capacity);
  }

  /**
   * Queues an edit. Any thread. The edits of one thread keep their order.
   *
   * @param edit a new edit, which nobody changes from now on
   * @return false if the queue is full; the caller may try again later
   * @throws IllegalArgumentException if there is no such segment, or the edit does not fit its grid
   */
  public boolean offer(Edit edit) {
    if (!swaps && edit instanceof SwapEdit) {
      throw new IllegalArgumentException(
          "a body keeps its cube; change its voxels instead: segment=" + edit.segment());
    }
    edit.prepare(grids);
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

  /** {@return the number of segments in the scene} */
  public int segments() {
    return grids.count();
  }

  /** {@return the number of complete edits} Any thread. */
  public long completed() {
    return taken.get();
  }

  /** {@return whether no edit waits and none is in progress} Any thread. */
  public boolean isIdle() {
    return offered.get() == taken.get();
  }

  /**
   * Applies up to 32 waiting edits. Each is a stroke of its own in the history, unless it continues
   * the last stroke. Haptic thread.
   *
   * @param out changes the voxels and keeps the history
   * @param maxVoxels number of voxels that the edits may visit
   */
  public void applyTo(VoxelWriter out, int maxVoxels) {
    int left = maxVoxels;
    for (int n = 0; n < MOST_EDITS_A_FRAME && left > 0; n++) {
      int slot = (int) (taken.getPlain() % slots.length());
      Edit edit = slots.get(slot);
      if (edit == null) {
        break;
      }
      if (!inProgress) {
        beginStroke(edit, out.history());
      }
      left -= edit.apply(out, left);
      inProgress = !edit.isDone();
      if (edit.isDone()) {
        endStroke(edit, out.history());
        slots.set(slot, null);
        taken.setRelease(taken.getPlain() + 1);
      }
    }
  }

  private void beginStroke(Edit edit, UndoHistory history) {
    history.endStroke();
    if (edit.continuesStroke() && history.strokes() == strokesAfter) {
      history.reopenStroke();
    }
    strokesBefore = history.strokes();
  }

  private void endStroke(Edit edit, UndoHistory history) {
    history.endStroke();
    boolean madeOne = history.strokes() > strokesBefore;
    if (madeOne || !edit.continuesStroke()) {
      strokesAfter = madeOne ? history.strokes() : NO_STROKE;
    }
  }
}
