package org.palpate.io.file;

import com.fasterxml.jackson.core.io.NumberOutput;
import java.util.Locale;

/** Formats numbers for tables and messages, alike on every JDK and in every locale. */
public final class NumberText {
  private static final String[] BYTE_UNITS = {"bytes", "kB", "MB", "GB", "TB", "PB", "EB"};
  private static final double MAX_INTEGER = 1e15;

  private NumberText() {}

  /**
   * Returns the shortest decimal that reads back as the same double, with a decimal point. A number
   * that is not finite gives {@code NaN}, {@code Infinity} or {@code -Infinity}.
   */
  public static String text(double value) {
    return NumberOutput.toString(value, true);
  }

  /** Returns the same text for a message: an integer without a fraction. */
  public static String display(double value) {
    return isInteger(value) ? Long.toString((long) value) : text(value);
  }

  /** Returns a number for a message, rounded to thousandths. */
  public static String thousandths(double value) {
    return display(Math.rint(value * 1e3) / 1e3 + 0.0);
  }

  /** Returns a count for a message, with commas between thousands: "1,000". */
  public static String count(double value) {
    return isInteger(value) ? String.format(Locale.ROOT, "%,d", (long) value) : text(value);
  }

  private static boolean isInteger(double value) {
    return value == Math.rint(value) && Math.abs(value) < MAX_INTEGER;
  }

  /** Returns a number of bytes for a message, rounded to a unit: "4.3 GB". */
  public static String bytes(double count) {
    int unit = 0;
    double rest = count;
    while (rest >= 1000 && unit < BYTE_UNITS.length - 1) {
      rest /= 1000;
      unit++;
    }
    return unit == 0
        ? (long) count + " bytes"
        : String.format(Locale.ROOT, rest < 10 ? "%.1f %s" : "%.0f %s", rest, BYTE_UNITS[unit]);
  }
}
