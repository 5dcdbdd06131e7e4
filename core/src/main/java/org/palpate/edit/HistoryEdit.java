package org.palpate.edit;

/** Undoes the last stroke, or redoes the stroke that was undone last. */
public final class HistoryEdit extends Edit {
  /** The number of voxels as which a changed brick counts in the work of an edit. */
  static final int VOXELS_A_BRICK = 64;

  private final boolean isUndo;
  private boolean isRefused;

  private HistoryEdit(boolean isUndo) {
    super(0);
    this.isUndo = isUndo;
  }

  /**
   * {@return an edit that undoes the last stroke; it does nothing if there is none, or if a log
   * refuses}
   */
  public static HistoryEdit undo() {
    return new HistoryEdit(true);
  }

  /**
   * {@return an edit that redoes the stroke that was undone last; it does nothing if there is none,
   * or if a log refuses}
   */
  public static HistoryEdit redo() {
    return new HistoryEdit(false);
  }

  /** {@return whether this undoes a stroke; otherwise it redoes one} Any thread. */
  public boolean isUndo() {
    return isUndo;
  }

  /** {@return whether a log refused, so that nothing changed} Any thread, once it is done. */
  public boolean isRefused() {
    return isRefused;
  }

  @Override
  void prepare(SegmentGrids grids) {
    // Fits every scene.
  }

  @Override
  int apply(VoxelWriter out, int maxVoxels) {
    int bricks = Math.max(1, maxVoxels / VOXELS_A_BRICK);
    UndoHistory history = out.history();
    long refusedBefore = history.refused();
    if (isUndo ? history.undo(bricks) : history.redo(bricks)) {
      isRefused = history.refused() > refusedBefore;
      finish();
    } else if (!history.isMoving()) {
      return maxVoxels; // A log has not found out yet whether it may; it goes on in the next frame.
    }
    return Math.max(1, Math.min(maxVoxels, bricks * VOXELS_A_BRICK));
  }
}
