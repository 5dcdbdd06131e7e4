package org.palpate.app.options;

import java.math.BigDecimal;
import java.util.OptionalDouble;
import org.palpate.app.process.PalpateException;
import org.palpate.io.file.NumberText;

/**
 * The numbers that an option takes. Immutable.
 *
 * @param option the name of the option, as in {@code --rate}
 * @param quantity the quantity with its article, as in "the rate"
 * @param low the smallest number
 * @param high the largest number
 * @param unit the unit, or nothing
 * @param example a number that suits most uses
 */
public record NumberRange(
    String option, String quantity, double low, double high, String unit, String example) {
  /** The smallest positive force, path or stiffness. */
  public static final double LEAST = 1e-6;

  /** The largest force, path or stiffness. */
  public static final double MOST = 1e6;

  /** The longest time that a command may be given, s: more than three years. */
  public static final double MOST_SECONDS = 1e8;

  /** Returns the range of a time in seconds. */
  public static NumberRange seconds() {
    return new NumberRange("--seconds", "the time", 0.001, MOST_SECONDS, "s", "10");
  }

  /** Returns a range of positive numbers, from a millionth to a million. */
  public static NumberRange positive(String option, String quantity, String unit) {
    return new NumberRange(option, quantity, LEAST, MOST, unit, "1");
  }

  /** Returns the range in words, as in "0.001 to 1,000". */
  public String text() {
    return plain(low) + " to " + plain(high);
  }

  private static String plain(double end) {
    return end == Math.rint(end)
        ? NumberText.count(end)
        : BigDecimal.valueOf(end).stripTrailingZeros().toPlainString();
  }

  /**
   * Returns the number after checking it.
   *
   * @throws PalpateException exit code 2, if it is not in the range; the line states the range
   */
  public double check(double value) {
    if (!(value >= low && value <= high)) {
      throw PalpateException.wrongUse(
          (quantity + " must be a number from " + text() + " " + unit).strip(),
          option + " " + NumberText.display(value),
          "try " + option + " " + example);
    }
    return value;
  }

  /**
   * Returns the number, if there is one, after checking it.
   *
   * @throws PalpateException exit code 2, if it is not in the range
   */
  public OptionalDouble checkGiven(Number value) {
    return value == null ? OptionalDouble.empty() : OptionalDouble.of(check(value.doubleValue()));
  }
}
