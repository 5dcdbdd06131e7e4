package org.palpate.volume;

/**
 * Quantizes grey values to levels from 0 to 255: 128 at {@code middle}, and {@code levelsPerUnit}
 * more for each unit of grey, rounded down and clamped. NaN has level 0.
 *
 * <p>Invariant: a level is at least 128 exactly if {@code value >= middle}.
 *
 * <p>Integers, which most volumes hold, are quantized in fixed point, which is twice as fast.
 * Immutable; any thread; allocates nothing.
 */
public final class GreyQuantizer {
  private static final int MIDDLE = 128;
  private static final int TOP = 255;

  /** The bits of the fraction in fixed point. */
  private static final int FRACTION_BITS = 16;

  private static final long ONE = 1L << FRACTION_BITS;

  /** Above all integers that a volume stores. */
  private static final double MAX_INTEGER = 1 << 20;

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

  /** Returns the level of an integer of less than 2^20. */
  int ofInteger(int value) {
    long over = (value - integerMiddle) * fixedLevelsPerUnit + aboveMiddle;
    return clamp((int) (over >> FRACTION_BITS) + MIDDLE);
  }

  private static int clamp(int level) {
    return Math.max(0, Math.min(TOP, level));
  }
}
