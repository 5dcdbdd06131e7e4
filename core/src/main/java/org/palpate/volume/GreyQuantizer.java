package org.palpate.volume;

/**
 * Grey values as levels of 0 to 255: 128 at {@code middle}, {@code levelsAUnit} more for each unit
 * of grey, rounded down and held to that range. From 128 on means {@code value >= middle}, exactly;
 * what is no number has level 0.
 *
 * <p>Whole numbers, which most volumes hold, are weighed as such; that is twice as fast.
 */
public final class GreyQuantizer {
  private static final int MIDDLE = 128;
  private static final int TOP = 255;

  /** Bits behind the point. */
  private static final int FRACTION_BITS = 16;

  private static final long ONE = 1L << FRACTION_BITS;

  /** Beyond all whole values that a volume stores. */
  private static final double FAR = 1 << 20;

  /** A step of one unit leads from one end to the other: more of them change nothing. */
  private static final double MOST_A_UNIT = 2 * TOP;

  private final double middle;
  private final double levelsAUnit;

  /** The least whole value of level 128, how far above 128 it is, and what each unit adds. */
  private final int wholeMiddle;

  private final long beyondMiddle;
  private final long perUnit;

  /**
   * Levels for one surface.
   *
   * @param middle the least value of level 128
   * @param levelsAUnit positive
   */
  public GreyQuantizer(double middle, double levelsAUnit) {
    if (!(levelsAUnit > 0)) {
      throw new IllegalArgumentException(
          "levelsAUnit must be positive: levelsAUnit=" + levelsAUnit);
    }
    this.middle = middle;
    this.levelsAUnit = levelsAUnit;
    double near = Math.max(-FAR, Math.min(FAR, middle));
    wholeMiddle = (int) Math.ceil(near);
    perUnit = Math.max(1, (long) (ONE * Math.min(MOST_A_UNIT, levelsAUnit)));
    beyondMiddle = Math.min(perUnit - 1, (long) ((wholeMiddle - near) * perUnit));
  }

  /** The level of a value. */
  public int of(double value) {
    int whole = (int) value;
    if (whole == value && Math.abs(whole) < FAR) {
      return ofWhole(whole);
    }
    int level = hold((int) ((value - middle) * levelsAUnit + MIDDLE));
    return value >= middle ? Math.max(MIDDLE, level) : Math.min(MIDDLE - 1, level);
  }

  /** The level of a whole value of less than 2^20. */
  int ofWhole(int value) {
    long over = (value - wholeMiddle) * perUnit + beyondMiddle;
    return hold((int) (over >> FRACTION_BITS) + MIDDLE);
  }

  private static int hold(int level) {
    return Math.max(0, Math.min(TOP, level));
  }
}
