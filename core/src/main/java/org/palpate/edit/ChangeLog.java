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

  /** Begins a stroke: changes of different strokes must not be merged into one. */
  void beginStroke();
}
