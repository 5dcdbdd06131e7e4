package org.palpate.edit;

/**
 * Keeps changes of voxels: for each changed brick its bits before and after. Changes of one brick
 * that follow each other closely in one stroke are kept as one.
 *
 * <p>Haptic thread only; allocates nothing after it was made.
 */
final class VoxelLog implements ChangeLog {
  /** The number of changes among which the last one of the same brick is looked for. */
  private static final int MERGED = 32;

  private static final int WORDS_OF_PLACE = 4;

  private final VoxelWriter writer;
  private final long[] before;
  private final long[] after;

  /** Segment and brick coordinates of each change. */
  private final int[] place;

  private long end;
  private long oldest;
  private long strokeBegin;

  /**
   * Creates an empty log.
   *
   * @param writer writes the bricks of changes that are undone or done again
   * @param capacity the most changes that are kept, 32 bytes each
   */
  VoxelLog(VoxelWriter writer, int capacity) {
    this.writer = writer;
    before = new long[capacity];
    after = new long[capacity];
    place = new int[WORDS_OF_PLACE * capacity];
  }

  /** Notes that a brick of a segment changed. */
  void note(int segment, int brickX, int brickY, int brickZ, long wordBefore, long wordAfter) {
    for (long change = end - 1; change >= Math.max(strokeBegin, end - MERGED); change--) {
      if (isAt(slot(change), segment, brickX, brickY, brickZ)) {
        after[slot(change)] = wordAfter;
        return;
      }
    }
    int slot = slot(end++);
    oldest = Math.max(oldest, end - before.length);
    before[slot] = wordBefore;
    after[slot] = wordAfter;
    int at = WORDS_OF_PLACE * slot;
    place[at] = segment;
    place[at + 1] = brickX;
    place[at + 2] = brickY;
    place[at + 3] = brickZ;
  }

  private boolean isAt(int slot, int segment, int brickX, int brickY, int brickZ) {
    int at = WORDS_OF_PLACE * slot;
    return place[at + 1] == brickX
        && place[at + 2] == brickY
        && place[at + 3] == brickZ
        && place[at] == segment;
  }

  private int slot(long change) {
    return (int) (change % before.length);
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
    restore(slot(change), before[slot(change)]);
  }

  @Override
  public void redo(long change) {
    restore(slot(change), after[slot(change)]);
  }

  private void restore(int slot, long word) {
    int at = WORDS_OF_PLACE * slot;
    writer.restoreBrick(place[at], place[at + 1], place[at + 2], place[at + 3], word);
  }

  @Override
  public void forgetFrom(long change) {
    end = change;
    strokeBegin = change;
  }

  @Override
  public void beginStroke() {
    strokeBegin = end;
  }
}
