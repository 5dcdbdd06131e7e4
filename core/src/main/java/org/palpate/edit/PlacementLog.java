package org.palpate.edit;

import org.palpate.geometry.Pose;

/**
 * Keeps placements of bodies, so that they can be undone and redone to the bit. Those of bodies
 * that moved together are one stroke. Haptic thread only; allocates nothing after it was made.
 */
public final class PlacementLog implements ChangeLog {
  /** The most placements that are kept. */
  private static final int CAPACITY = 1024;

  private final Placer placer;
  private final int[] body = new int[CAPACITY];
  private final Pose[] from = new Pose[CAPACITY];
  private final Pose[] to = new Pose[CAPACITY];
  private UndoHistory history;
  private long end;
  private long oldest;

  /** Puts bodies where they were. */
  @FunctionalInterface
  public interface Placer {
    /**
     * Sets the pose of a body.
     *
     * @param body the index of the body in the scene
     * @param pose from rest to present, world mm; not to be kept
     */
    void place(int body, Pose pose);
  }

  /**
   * Creates an empty log.
   *
   * @param placer puts bodies where they were, for undo and redo
   */
  public PlacementLog(Placer placer) {
    this.placer = placer;
    for (int n = 0; n < CAPACITY; n++) {
      from[n] = new Pose();
      to[n] = new Pose();
    }
  }

  /** Sets the history that groups the placements; before the first. */
  void keepIn(UndoHistory newHistory) {
    history = newHistory;
  }

  /** Separates placements: those that are noted before and after are undone one by one. */
  public void separate() {
    history.endStroke();
  }

  /**
   * Notes that a body was moved from one pose to another.
   *
   * @param index the index of the body in the scene
   * @param before its pose before, from rest to present, world mm; copied
   * @param after its pose after, likewise
   */
  public void note(int index, Pose before, Pose after) {
    history.beforeChange();
    int at = (int) (end++ % CAPACITY);
    body[at] = index;
    from[at].set(before);
    to[at].set(after);
    oldest = Math.max(oldest, end - CAPACITY);
  }

  @Override
  public long end() {
    return end;
  }

  @Override
  public long oldest() {
    return oldest;
  }

  @Override
  public void undo(long change) {
    placer.place(body[(int) (change % CAPACITY)], from[(int) (change % CAPACITY)]);
  }

  @Override
  public void redo(long change) {
    placer.place(body[(int) (change % CAPACITY)], to[(int) (change % CAPACITY)]);
  }

  @Override
  public void forgetFrom(long change) {
    end = change;
  }

  @Override
  public void beginStroke() {
    // Nothing is kept for a stroke.
  }
}
