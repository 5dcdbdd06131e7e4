package org.palpate.edit;

import java.util.List;
import org.palpate.geometry.Pose;

/**
 * Keeps placements of bodies, so that they can be undone and redone to the bit. Those of bodies
 * that moved together are one stroke.
 *
 * <p>A body may also move without a placement. Undo is refused if it would put a body near one that
 * does not stand where it stood when the placement began. All others stand there bit for bit, so
 * nothing comes nearer to them than it was. Redo compares with where bodies stood when the
 * placement ended.
 *
 * <p>Haptic thread only; allocates nothing after it was made.
 */
public final class PlacementLog implements ChangeLog {
  /** The most placements that are kept; fewer among many bodies. */
  private static final int MOST_PLACEMENTS = 1024;

  /** The most poses that are kept of the beginnings of placements, and of their ends, 3.7 MB. */
  private static final int MOST_POSES = 1 << 16;

  private final Placer placer;
  private final int bodies;
  private final int capacity;
  private final int[] body;

  /** For each placement the poses of all bodies when it began. */
  private final PoseTable begins;

  /** The same when it ended. */
  private final PoseTable ends;

  private final Pose target = new Pose();
  private final PlacementCheck check;
  private UndoHistory history;
  private long end;
  private long oldest;

  /** Puts bodies where they were, and checks whether there is room. */
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
     * {@return the number of times that the pose of a body was set}
     *
     * @param body the index of the body in the scene
     */
    long motions(int body);

    /** {@return the number of edits of all bodies} */
    long edits();

    /**
     * {@return whether a body may be near another one; false only if the two are far apart}
     *
     * @param body the index of the body in the scene
     * @param pose the pose of that body, from rest to present, world mm
     * @param other the index of the other body, which stays where it is
     */
    boolean isNear(int body, Pose pose, int other);

    /**
     * Begins to check whether a body would keep its whole clearance from another one. The last such
     * check is forgotten.
     *
     * @param body the index of the body in the scene
     * @param pose the pose of that body, from rest to present, world mm
     * @param other the index of the other body, which stays where it is
     */
    void beginCheck(int body, Pose pose, int other);

    /**
     * Goes on with the check.
     *
     * @param most about the most points to look at
     * @return the number of points that it looked at, or as many as other work is worth
     */
    int continueCheck(int most);

    /** {@return whether the body would keep its clearance; later if points are left} */
    Answer checked();

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
    bodies = placer.count();
    capacity = Math.min(MOST_PLACEMENTS, Math.max(1, MOST_POSES / Math.max(1, bodies)));
    body = new int[capacity];
    begins = new PoseTable(capacity, bodies);
    ends = new PoseTable(capacity, bodies);
    check = new PlacementCheck(placer, body);
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
   * Notes that a body was placed where it is now.
   *
   * @param index the index of the body in the scene
   * @param before the poses of all bodies when the placement began, from rest to present, world mm;
   *     copied
   */
  public void note(int index, List<Pose> before) {
    history.beforeChange();
    int slot = slot(end++);
    body[slot] = index;
    for (int n = 0; n < bodies; n++) {
      begins.set(slot, n, before.get(n));
      ends.set(slot, n, placer.pose(n));
    }
    oldest = Math.max(oldest, end - capacity);
    check.drop();
  }

  private int slot(long change) {
    return (int) (change % capacity);
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
    place(slot(change), begins);
  }

  @Override
  public void redo(long change) {
    place(slot(change), ends);
  }

  private void place(int slot, PoseTable poses) {
    placer.place(body[slot], poses.get(slot, body[slot], target));
  }

  @Override
  public Answer mayUndo(long first, long end) {
    return mayPlace(first, end, begins);
  }

  @Override
  public Answer mayRedo(long first, long end) {
    return mayPlace(first, end, ends);
  }

  private Answer mayPlace(long first, long last, PoseTable poses) {
    if (!check.isOf(first, last, poses)) {
      check.begin(first, last, poses);
    }
    return check.goOn();
  }

  @Override
  public boolean isAtOnce() {
    return true;
  }

  @Override
  public void forgetFrom(long change) {
    end = change;
    check.drop();
  }

  @Override
  public void beginStroke() {
    // Nothing is kept for a stroke.
  }
}
