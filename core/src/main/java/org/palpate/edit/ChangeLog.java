package org.palpate.edit;

/**
 * Keeps changes of one kind, such as those of voxels, so that they can be undone and redone to the
 * bit. Changes are numbered in the order in which they were made. A log has bounded memory and
 * forgets the oldest changes. {@link UndoHistory} groups the changes of several logs into strokes.
 *
 * <p>Haptic thread only; no method allocates.
 */
public interface ChangeLog {
  /** {@return the number of the next change} */
  long end();

  /** {@return the number of the oldest change that is kept} */
  long oldest();

  /**
   * Undoes a change. The caller undoes changes from the newest to the oldest.
   *
   * @param change the number of the change
   */
  void undo(long change);

  /**
   * Does an undone change again. The caller does so from the oldest to the newest.
   *
   * @param change the number of the change
   */
  void redo(long change);

  /**
   * Forgets all changes from a number on, which have been undone; the next change gets it.
   *
   * @param change the number of the first change to forget
   */
  void forgetFrom(long change);

  /** Whether changes may be undone or done again. */
  enum Answer {
    /** They may. */
    YES,

    /** They may not now, perhaps later. */
    NO,

    /** The log has not found out yet; it goes on when it is asked again in a later frame. */
    LATER
  }

  /**
   * {@return whether changes may be undone now} Asked before a stroke is undone, once a frame until
   * the answer is not {@link Answer#LATER}. The work of each call is bounded.
   *
   * @param first the number of the first of the changes
   * @param end the number of the change after the last of them
   */
  default Answer mayUndo(long first, long end) {
    return Answer.YES;
  }

  /**
   * {@return whether changes may be done again now} Asked before a stroke is redone, as {@link
   * #mayUndo}.
   *
   * @param first the number of the first of the changes
   * @param end the number of the change after the last of them
   */
  default Answer mayRedo(long first, long end) {
    return Answer.YES;
  }

  /** {@return whether the changes of a stroke are undone and redone at once, however many} */
  default boolean isAtOnce() {
    return false;
  }

  /** Begins a stroke: changes of different strokes must not be merged into one. */
  void beginStroke();
}
