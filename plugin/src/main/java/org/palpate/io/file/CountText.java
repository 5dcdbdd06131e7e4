package org.palpate.io.file;

/** Counts of things as text. */
public final class CountText {
  private CountText() {}

  /**
   * Returns a count with its noun, as in "1 point" or "1,200 points".
   *
   * @param count how many there are
   * @param singular the noun for one of them, whose plural ends in s
   */
  public static String of(long count, String singular) {
    return of(count, singular, singular + "s");
  }

  /**
   * Returns a count with its noun, as in "1 body" or "2 bodies".
   *
   * @param count how many there are
   * @param singular the noun for one of them
   * @param plural the noun for none or several
   */
  public static String of(long count, String singular, String plural) {
    return NumberText.count((double) count) + " " + (count == 1 ? singular : plural);
  }
}
