package org.palpate.edit;

import org.palpate.geometry.Pose;

/**
 * Keeps placements of bodies, so that they can be undone and redone to the bit. Those of bodies
 * that moved together are one stroke.
 *
 * <p>A body may <em>stray</em>: it moves without a placement. A placement is refused if it would
 * put a body near one that has strayed since the placement began. All others stand bit for bit
 * where they stood then, so nothing comes nearer to them than it was.
 *
 * <p>Haptic thread only; allocates nothing after it was made.
 */
public final class PlacementLog implements ChangeLog {
  /** The most placements that are kept. */
  private static final int CAPACITY = 1024;

  private final Placer placer;
  private final int[] body = new int[CAPACITY];
  private final Pose[] from = new Pose[CAPACITY];
  private final Pose[] to = new Pose[CAPACITY];

  /** For each placement, the strays that had been noted when it began. */
  private final long[] begin = new long[CAPACITY];

  /** For each body the number of its last stray; 0 for none. */
  private final long[] lastStray;

  private long strays;
  private UndoHistory history;
  private long end;
  private long oldest;

  /** Puts bodies where they were. */
  public interface Placer {
    /** {@return the number of bodies in the scene} */
    int count();

    /**
     * {@return the pose of a body, from rest to present, world mm; not to be written}
     *
     * @param body the index of the body in the scene
     */
    Pose pose(int body);

    /**
     * {@return whether a body would keep its whole clearance from another one}
     *
     * @param body the index of the body in the scene
     * @param pose the pose of that body, from rest to present, world mm
     * @param other the index of the other body, which stays where it is
     */
    boolean keepsClear(int body, Pose pose, int other);

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
    lastStray = new long[placer.count()];
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
   * @param since what {@link #strays} was when it began
   */
  public void note(int index, Pose before, Pose after, long since) {
    history.beforeChange();
    int at = (int) (end++ % CAPACITY);
    body[at] = index;
    from[at].set(before);
    to[at].set(after);
    begin[at] = since;
    oldest = Math.max(oldest, end - CAPACITY);
  }

  /** {@return the number of strays that were noted so far} */
  public long strays() {
    return strays;
  }

  /**
   * Notes that a body moved without a placement.
   *
   * @param index the index of the body in the scene
   */
  public void noteStray(int index) {
    lastStray[index] = ++strays;
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
    place(change, to, from);
  }

  @Override
  public void redo(long change) {
    place(change, from, to);
  }

  /** Puts a body from one of its poses to the other. One that is not there has strayed. */
  private void place(long change, Pose[] expected, Pose[] target) {
    int at = (int) (change % CAPACITY);
    if (!placer.pose(body[at]).sameBits(expected[at])) {
      noteStray(body[at]);
    }
    placer.place(body[at], target[at]);
  }

  @Override
  public boolean mayUndo(long first, long end) {
    return mayPlace(first, end, from);
  }

  @Override
  public boolean mayRedo(long first, long end) {
    return mayPlace(first, end, to);
  }

  @Override
  public boolean isAtOnce() {
    return true;
  }

  /** Whether bodies that moved together would keep clear of all bodies that have strayed since. */
  private boolean mayPlace(long first, long end, Pose[] target) {
    for (long change = first; change < end; change++) {
      int at = (int) (change % CAPACITY);
      for (int other = 0; other < lastStray.length; other++) {
        if (lastStray[other] > begin[at]
            && !isPlaced(other, first, end)
            && !placer.keepsClear(body[at], target[at], other)) {
          return false;
        }
      }
    }
    return true;
  }

  /** Whether one of some placements is that of a body. */
  private boolean isPlaced(int index, long first, long end) {
    for (long change = first; change < end; change++) {
      if (body[(int) (change % CAPACITY)] == index) {
        return true;
      }
    }
    return false;
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
