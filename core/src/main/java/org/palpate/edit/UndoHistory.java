package org.palpate.edit;

import java.util.List;

/**
 * Groups changes into strokes, and undoes and redoes the last strokes. Changes of several kinds
 * share one history; each kind has a {@link ChangeLog}.
 *
 * <p>Memory is bounded: the oldest strokes are forgotten, and so is a stroke of which a log has
 * forgotten a part. Haptic thread only; allocates nothing after it was made.
 */
public final class UndoHistory {
  /** The most strokes that are kept. */
  public static final int MOST_STROKES = 4096;

  private final ChangeLog[] logs;

  /** For each kept stroke and log, the number of the first change after the stroke. */
  private final long[] ends;

  /** For each log, the number of the first change of the stroke that is open. */
  private final long[] begins;

  /** The number of strokes that were ever ended, without those that were undone. */
  private long done;

  /** The number of the stroke after the last one that can be done again. */
  private long known;

  /** Strokes before this one cannot be undone. */
  private long forgottenBefore;

  /** The position of each log on the way from one end of a stroke to the other. */
  private final long[] positions;

  private boolean isMoving;
  private long refused;

  /**
   * Creates an empty history over logs.
   *
   * @param logs one for each kind of change
   */
  public UndoHistory(List<? extends ChangeLog> logs) {
    this.logs = logs.toArray(new ChangeLog[0]);
    ends = new long[MOST_STROKES * this.logs.length];
    begins = new long[this.logs.length];
    positions = new long[this.logs.length];
    for (int log = 0; log < begins.length; log++) {
      begins[log] = this.logs[log].end();
      positions[log] = begins[log];
    }
    rememberEnds();
  }

  /** {@return whether a stroke is undone or done again in part, so that nothing else may change} */
  public boolean isMoving() {
    return isMoving;
  }

  /** {@return how often undo or redo was refused, and left the stroke as it was} */
  public long refused() {
    return refused;
  }

  /** Forgets the strokes that were undone. Call it before each change. */
  void beforeChange() {
    assert !isMoving : "a stroke is undone in part";
    if (known == done) {
      return;
    }
    for (int log = 0; log < logs.length; log++) {
      logs[log].forgetFrom(begins[log]);
    }
    known = done;
  }

  /** Ends the open stroke, so that the next change begins another. Nothing happens without one. */
  public void endStroke() {
    if (!isOpen()) {
      return;
    }
    done++;
    known = done;
    for (int log = 0; log < logs.length; log++) {
      begins[log] = logs[log].end();
      positions[log] = begins[log];
      logs[log].beginStroke();
    }
    rememberEnds();
  }

  /**
   * Takes up the last stroke again, so that the next changes belong to it. Nothing happens if there
   * is none, if one is open, or if strokes were undone.
   */
  void reopenStroke() {
    if (!isMoving && known == done && !isOpen() && canUndo(0)) {
      done--;
      known = done;
      System.arraycopy(ends, at(done), begins, 0, logs.length);
    }
  }

  /** Returns the number of strokes that were ever ended, without those that were undone. */
  long strokes() {
    return done;
  }

  private void rememberEnds() {
    System.arraycopy(begins, 0, ends, at(done), logs.length);
  }

  private boolean isOpen() {
    if (known != done) {
      return false;
    }
    for (int log = 0; log < logs.length; log++) {
      if (logs[log].end() != begins[log]) {
        return true;
      }
    }
    return false;
  }

  private int at(long stroke) {
    return (int) (stroke % MOST_STROKES) * logs.length;
  }

  /** Forgets all strokes, because something changed that no log knows. */
  void forget() {
    beforeChange();
    endStroke();
    for (ChangeLog log : logs) {
      log.forgetFrom(log.end());
    }
    forgottenBefore = done;
    known = done;
  }

  /** {@return the number of strokes that can be undone; the open one counts} */
  public int undoable() {
    return undoableEnded() + (isOpen() ? 1 : 0);
  }

  private int undoableEnded() {
    int count = 0;
    while (canUndo(count)) {
      count++;
    }
    return count;
  }

  /** Whether a stroke can be undone after {@code count} others were. */
  private boolean canUndo(int count) {
    return known - done + count < MOST_STROKES - 1
        && done - count > forgottenBefore
        && isKept(done - count - 1);
  }

  /** Whether every log still holds the changes after the end of a stroke. */
  private boolean isKept(long stroke) {
    for (int log = 0; log < logs.length; log++) {
      if (ends[at(stroke) + log] < logs[log].oldest()) {
        return false;
      }
    }
    return true;
  }

  /** {@return the number of strokes that can be done again} */
  public int redoable() {
    return (int) (known - done);
  }

  /**
   * Undoes the last stroke or a part of it. As long as a log does not know whether it may, nothing
   * is undone, and other changes may come between two calls.
   *
   * @param mostChanges the most changes to undo, at least 1
   * @return whether the stroke is undone; true as well if there is none, or if it is refused
   */
  public boolean undo(int mostChanges) {
    if (!isMoving) {
      endStroke();
      if (!canUndo(0)) {
        return true;
      }
      ChangeLog.Answer answer = mayMove(true);
      if (answer != ChangeLog.Answer.YES) {
        return answer == ChangeLog.Answer.NO;
      }
      isMoving = true;
    }
    int left = mostChanges;
    for (int log = logs.length - 1; log >= 0; log--) {
      long target = ends[at(done - 1) + log];
      while (positions[log] > target && (logs[log].isAtOnce() || left-- > 0)) {
        logs[log].undo(--positions[log]);
      }
      if (positions[log] > target) {
        return false;
      }
    }
    arriveAt(done - 1);
    return true;
  }

  /**
   * Redoes the stroke that was undone last, or a part of it; see {@link #undo}.
   *
   * @param mostChanges the most changes to do, at least 1
   * @return whether the stroke is done again; true as well if there is none, or if it is refused
   */
  public boolean redo(int mostChanges) {
    if (!isMoving) {
      if (known == done) {
        return true;
      }
      ChangeLog.Answer answer = mayMove(false);
      if (answer != ChangeLog.Answer.YES) {
        return answer == ChangeLog.Answer.NO;
      }
      isMoving = true;
    }
    int left = mostChanges;
    for (int log = 0; log < logs.length; log++) {
      long target = ends[at(done + 1) + log];
      while (positions[log] < target && (logs[log].isAtOnce() || left-- > 0)) {
        logs[log].redo(positions[log]++);
      }
      if (positions[log] < target) {
        return false;
      }
    }
    arriveAt(done + 1);
    return true;
  }

  /** Returns whether all logs let the next stroke be undone, or be done again; counts a refusal. */
  private ChangeLog.Answer mayMove(boolean isUndo) {
    int target = at(isUndo ? done - 1 : done + 1);
    for (int log = 0; log < logs.length; log++) {
      long next = ends[target + log];
      ChangeLog.Answer answer =
          isUndo
              ? logs[log].mayUndo(next, positions[log])
              : logs[log].mayRedo(positions[log], next);
      if (answer != ChangeLog.Answer.YES) {
        refused += answer == ChangeLog.Answer.NO ? 1 : 0;
        return answer;
      }
    }
    return ChangeLog.Answer.YES;
  }

  private void arriveAt(long stroke) {
    isMoving = false;
    done = stroke;
    System.arraycopy(ends, at(stroke), begins, 0, logs.length);
  }
}
