package org.palpate.edit;

import org.palpate.edit.ChangeLog.Answer;
import org.palpate.edit.PlacementLog.Placer;
import org.palpate.geometry.Pose;

/**
 * Checks whether bodies that were placed together may return to poses of a {@link PlacementLog}:
 * each of them must be clear of every other body that does not stand where it stood then. The check
 * takes several frames, and begins anew if something that matters to it changes meanwhile.
 *
 * <p>Haptic thread only; allocates nothing after it was made.
 */
final class PlacementCheck {
  /** The points that a frame looks at; about 0.3 ms if none of them is cached. */
  static final int POINTS_A_FRAME = 500;

  /** The times that a check begins before it gives up, because a body goes on moving nearby. */
  static final int MOST_BEGINNINGS = 2000;

  /** The frames that a check which began anew takes before it gives up as well. */
  static final int MOST_FRAMES = 10_000;

  private final Placer placer;

  /** The body of each placement, by slot. */
  private final int[] placed;

  private final Pose target = new Pose();
  private final Pose stood = new Pose();

  /** The number of motions of each body that the check has seen. */
  private final long[] motionsSeen;

  private long editsSeen;

  /** The placements, from the first to the one after the last. */
  private long first;

  private long end;

  /** The poses of all bodies at the time to which the placements return; null without a check. */
  private PoseTable poses;

  /** The pair of a placement and another body with which the check goes on. */
  private long change;

  private int other;
  private boolean isPairOpen;
  private int beginnings;
  private int frames;

  /**
   * Creates a check that has not begun.
   *
   * @param bodyOf the body of each placement, by slot; kept
   */
  PlacementCheck(Placer placer, int[] bodyOf) {
    this.placer = placer;
    placed = bodyOf;
    motionsSeen = new long[placer.count()];
  }

  /** Whether the present check is that of some placements. */
  boolean isOf(long firstChange, long endChange, PoseTable wanted) {
    return poses == wanted && first == firstChange && end == endChange;
  }

  /** Ends the check, because the placements have changed. */
  void drop() {
    poses = null;
  }

  /**
   * Begins the check of some placements.
   *
   * @param wanted where bodies are to be, by slot
   */
  void begin(long firstChange, long endChange, PoseTable wanted) {
    first = firstChange;
    end = endChange;
    poses = wanted;
    isPairOpen = false;
    beginnings = 0;
    frames = 0;
    hasChanged(); // From now on.
    beginAnew();
  }

  private void beginAnew() {
    change = first;
    other = 0;
    isPairOpen = false;
    beginnings++;
  }

  /** Goes on with the check, and ends it unless the answer is {@link Answer#LATER}. */
  Answer goOn() {
    if (hasChanged()) {
      beginAnew();
    }
    frames++;
    Answer answer = givesUp() ? Answer.NO : look();
    if (answer != Answer.LATER) {
      drop();
    }
    return answer;
  }

  private boolean givesUp() {
    return beginnings > MOST_BEGINNINGS || (beginnings > 1 && frames > MOST_FRAMES);
  }

  /** Whether voxels, or a body that is near or is looked at, have changed since the last call. */
  private boolean hasChanged() {
    long edits = placer.edits();
    boolean changed = edits != editsSeen;
    editsSeen = edits;
    for (int n = 0; n < motionsSeen.length; n++) {
      long motions = placer.motions(n);
      boolean isLookedAt = isPairOpen && n == other;
      changed |= motions != motionsSeen[n] && (isLookedAt || isNearAny(n));
      motionsSeen[n] = motions;
    }
    return changed;
  }

  private boolean isNearAny(int body) {
    if (isPlaced(body)) {
      return false; // Where it is now does not matter.
    }
    for (long n = first; n < end; n++) {
      int slot = slot(n);
      if (placer.isNear(placed[slot], poses.get(slot, placed[slot], target), body)) {
        return true;
      }
    }
    return false;
  }

  private Answer look() {
    int left = POINTS_A_FRAME;
    while (left > 0 && change < end) {
      if (!isPairOpen && mustLookAtPair()) {
        openPair();
      }
      left -= isPairOpen ? placer.continueCheck(left) : 1;
      if (isPairOpen && placer.checked() == Answer.NO) {
        return Answer.NO;
      }
      if (!isPairOpen || placer.checked() == Answer.YES) {
        goToNextPair();
      }
    }
    return change == end ? Answer.YES : Answer.LATER;
  }

  /** Whether the other body of the present pair does not stand where it stood, and is near. */
  private boolean mustLookAtPair() {
    int slot = slot(change);
    return !poses.get(slot, other, stood).sameBits(placer.pose(other))
        && !isPlaced(other)
        && placer.isNear(placed[slot], poses.get(slot, placed[slot], target), other);
  }

  private void openPair() {
    int slot = slot(change);
    placer.beginCheck(placed[slot], poses.get(slot, placed[slot], target), other);
    isPairOpen = true;
  }

  private void goToNextPair() {
    isPairOpen = false;
    other++;
    if (other == motionsSeen.length) {
      other = 0;
      change++;
    }
  }

  /** Whether a body is one of those that are placed together. */
  private boolean isPlaced(int body) {
    for (long n = first; n < end; n++) {
      if (placed[slot(n)] == body) {
        return true;
      }
    }
    return false;
  }

  private int slot(long n) {
    return (int) (n % placed.length);
  }
}
