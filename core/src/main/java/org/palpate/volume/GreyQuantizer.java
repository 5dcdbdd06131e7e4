package org.palpate.volume;

import java.util.Arrays;

/**
 * Quantizes grey values to levels from 0 to 255: 128 at {@code middle}, and {@code levelsPerUnit}
 * more for each unit of grey, rounded down and clamped. NaN has level 0.
 *
 * <p>Invariant: a level is at least 128 exactly if {@code value >= middle}.
 *
 * <p>Integers, which most volumes hold, are quantized in fixed point. The levels of those of two
 * bytes stand in a table, because windows of voxels read hundreds of them in a frame. Immutable;
 * any thread; allocates nothing after construction.
 */
public final class GreyQuantizer {
  private static final int MIDDLE = 128;
  private static final int TOP = 255;

  /** The bits of the fraction in fixed point. */
  private static final int FRACTION_BITS = 16;

  private static final long ONE = 1L << FRACTION_BITS;

  /** Above all integers that a volume stores. */
  private static final double MAX_INTEGER = 1 << 20;

  /** The least integer in the table. */
  private static final int LEAST = Short.MIN_VALUE;

  /** The integer behind the greatest one in the table. */
  private static final int END = 1 << Character.SIZE;

  /** At this slope one unit spans the whole range, so that a steeper one changes nothing. */
  private static final double MAX_LEVELS_PER_UNIT = 2 * TOP;

  private final double middle;
  private final double levelsPerUnit;

  /** The smallest integer of level 128. */
  private final int integerMiddle;

  /** The amount by which that integer is above 128, in fixed point. */
  private final long aboveMiddle;

  /** The levels that each unit adds, in fixed point. */
  private final long fixedLevelsPerUnit;

  /** The levels of the integers from {@link #LEAST} on. */
  private final byte[] table = new byte[END - LEAST];

  /**
   * Creates a quantizer.
   *
   * @param middle the smallest value of level 128
   * @param levelsPerUnit the slope, positive
   * @throws IllegalArgumentException if the slope is not positive
   */
  public GreyQuantizer(double middle, double levelsPerUnit) {
    if (!(levelsPerUnit > 0)) {
      throw new IllegalArgumentException(
          "levelsPerUnit must be positive: levelsPerUnit=" + levelsPerUnit);
    }
    this.middle = middle;
    this.levelsPerUnit = levelsPerUnit;
    double near = Math.max(-MAX_INTEGER, Math.min(MAX_INTEGER, middle));
    integerMiddle = (int) Math.ceil(near);
    fixedLevelsPerUnit = Math.max(1, (long) (ONE * Math.min(MAX_LEVELS_PER_UNIT, levelsPerUnit)));
    aboveMiddle =
        Math.min(fixedLevelsPerUnit - 1, (long) ((integerMiddle - near) * fixedLevelsPerUnit));
    fillTable();
  }

  /** Fills the table from the middle on both ways until levels are at their bounds. */
  private void fillTable() {
    int middleAt = Math.max(0, Math.min(table.length, integerMiddle - LEAST));
    int level = TOP;
    for (int n = middleAt - 1; n >= 0 && level > 0; n--) {
      level = ofInteger(n + LEAST);
      table[n] = (byte) level;
    }
    int end = middleAt;
    for (level = 0; end < table.length && level < TOP; end++) {
      level = ofInteger(end + LEAST);
      table[end] = (byte) level;
    }
    Arrays.fill(table, end, table.length, (byte) TOP);
  }

  /**
   * {@return the level of a value}
   *
   * @param value a grey value, in the unit of the volume
   */
  public int of(double value) {
    int integer = (int) value;
    if (integer == value && Math.abs(integer) < MAX_INTEGER) {
      return ofInteger(integer);
    }
    int level = clamp((int) ((value - middle) * levelsPerUnit + MIDDLE));
    return value >= middle ? Math.max(MIDDLE, level) : Math.min(MIDDLE - 1, level);
  }

  /** Returns the level of a signed or an unsigned integer of at most two bytes. */
  long ofStored(int value) {
    return table[value - LEAST] & TOP;
  }

  /** Returns the level of an integer of less than 2^20. */
  private int ofInteger(int value) {
    long over = (value - integerMiddle) * fixedLevelsPerUnit + aboveMiddle;
    return clamp((int) (over >> FRACTION_BITS) + MIDDLE);
  }

  private static int clamp(int level) {
    return Math.max(0, Math.min(TOP, level));
  }
}
