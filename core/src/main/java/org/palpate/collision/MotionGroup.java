package org.palpate.collision;

import org.palpate.geometry.AffineMap;

/**
 * Motions of the same points from one start to several ends, for example a step and fractions of
 * it. A motion leads from the image of each point under one map to its image under another. One
 * thread; allocates nothing after construction.
 */
public final class MotionGroup {
  /** The most motions. */
  public static final int CAPACITY = 5;

  /** The index of a motion that the group does not have. */
  public static final int NONE = -1;

  private final AffineMap from = new AffineMap();
  private final AffineMap[] to = new AffineMap[CAPACITY];
  private int count;

  /** Creates a group without motions. */
  public MotionGroup() {
    for (int n = 0; n < CAPACITY; n++) {
      to[n] = new AffineMap();
    }
  }

  /**
   * Begins anew, without motions.
   *
   * @param newFrom the map at the start of all motions; copied
   */
  public void begin(AffineMap newFrom) {
    from.set(newFrom);
    count = 0;
  }

  /**
   * Adds a motion. There must be room.
   *
   * @param newTo the map at its end; copied
   */
  public void add(AffineMap newTo) {
    to[count++].set(newTo);
  }

  /** {@return the number of motions} */
  public int count() {
    return count;
  }

  /** {@return the map at the start of all motions; not to be written} */
  public AffineMap from() {
    return from;
  }

  /**
   * {@return the map at the end of a motion; not to be written}
   *
   * @param motion the index of the motion, from 0
   */
  public AffineMap to(int motion) {
    return to[motion];
  }

  /**
   * {@return the index of the motion between two maps; {@link #NONE} if none}
   *
   * @param ofFrom the map at its start, compared bit for bit
   * @param ofTo the map at its end, likewise
   */
  public int indexOf(AffineMap ofFrom, AffineMap ofTo) {
    for (int n = 0; n < count && from.sameBits(ofFrom); n++) {
      if (to[n].sameBits(ofTo)) {
        return n;
      }
    }
    return NONE;
  }

  /**
   * Copies another group.
   *
   * @param other the group to copy
   */
  public void set(MotionGroup other) {
    begin(other.from);
    for (int n = 0; n < other.count; n++) {
      add(other.to[n]);
    }
  }
}
