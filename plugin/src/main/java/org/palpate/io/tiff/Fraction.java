package org.palpate.io.tiff;

/** Finds fractions for the resolutions of a TIFF. */
final class Fraction {
  private static final long MAX_PART = Integer.MAX_VALUE;

  private Fraction() {}

  /**
   * Returns numerator and denominator of a fraction near {@code 1 / size}: the simplest one that
   * reads back as exactly this size, else the nearest one.
   *
   * <p>Source: continued fractions, whose convergents are the best approximations.
   */
  static int[] reciprocalOf(double size) {
    long[] before = {0, 1};
    long[] now = {1, 0};
    double rest = size;
    for (int step = 0; step < 64; step++) {
      double whole = Math.floor(rest);
      double top = whole * now[0] + before[0];
      double bottom = whole * now[1] + before[1];
      if (top > MAX_PART || bottom > MAX_PART) {
        break;
      }
      before = now;
      now = new long[] {(long) top, (long) bottom};
      if (rest == whole || (now[0] > 0 && 1 / ((double) now[1] / now[0]) == size)) {
        break;
      }
      rest = 1 / (rest - whole);
    }
    // now is size = top / bottom; its reciprocal is what a TIFF stores
    return new int[] {(int) Math.max(1, now[1]), (int) Math.max(1, now[0])};
  }
}
