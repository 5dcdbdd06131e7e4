package org.palpate.edit;

/**
 * A change of voxels, of grey values, or of the history. Any thread makes an edit and puts it into
 * an {@link EditQueue} once. The haptic thread applies it between frames.
 */
public abstract sealed class Edit
    permits VoxelEdit, VoxelListEdit, BoxEdit, DifferenceEdit, SwapEdit, GreyEdit, HistoryEdit {
  private final int segment;
  private boolean continuesStroke;
  private volatile boolean done;

  Edit(int segment) {
    this.segment = segment;
  }

  /**
   * {@return the index of the changed segment in the scene; for a list of voxels that of the first
   * one, for undo and redo 0}
   */
  public final int segment() {
    return segment;
  }

  /**
   * Makes the edit a part of the stroke of the last edit, if nothing else changed since then, so
   * that one undo takes back both. Call it before the edit is queued.
   */
  public final void continueStroke() {
    continuesStroke = true;
  }

  final boolean continuesStroke() {
    return continuesStroke;
  }

  /**
   * {@return whether the edit is complete} Then all its writes are visible to the calling thread.
   * Any thread.
   */
  public final boolean isDone() {
    return done;
  }

  /**
   * Checks that the edit fits, and prepares it. Runs in the thread that queues the edit.
   *
   * @param grids those of the segments of the scene
   * @throws IllegalArgumentException with the values, if it does not fit
   */
  abstract void prepare(SegmentGrids grids);

  /**
   * Applies the edit or a part of it, and reports what may have changed. Haptic thread.
   *
   * @param out changes the voxels
   * @param maxVoxels number of voxels that it may visit, at least 1
   * @return number of visited voxels, at least 1
   */
  abstract int apply(VoxelWriter out, int maxVoxels);

  /** Marks the edit as complete. Haptic thread, after its last write. */
  final void finish() {
    done = true;
  }
}
