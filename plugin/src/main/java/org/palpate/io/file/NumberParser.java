package org.palpate.io.file;

import java.util.Locale;

/** Parses numbers as file headers write them, and formats them for messages. */
public final class NumberParser {
  private NumberParser() {}

  /** A whole number from 1 to 2^31-1, or 0 where the text is none. */
  public static int positiveInt(String text) {
    try {
      return Math.max(0, Integer.parseInt(text.strip()));
    } catch (NumberFormatException e) {
      return 0;
    }
  }

  /** A number with a dot; NaN where the text is none. */
  public static double number(String text) {
    String word = text.strip();
    // Java takes 1d, 1f and hexadecimal too; no header means those
    if (word.isEmpty() || !word.matches("[-+]?([0-9]+\\.?[0-9]*|\\.[0-9]+)([eE][-+]?[0-9]+)?")) {
      return specialNumber(word);
    }
    return Double.parseDouble(word);
  }

  private static double specialNumber(String word) {
    return switch (word.toLowerCase(Locale.ROOT)) {
      case "inf", "+inf", "infinity" -> Double.POSITIVE_INFINITY;
      case "-inf", "-infinity" -> Double.NEGATIVE_INFINITY;
      default -> Double.NaN;
    };
  }

  /** For a person: whole numbers without a dot, others as short as they can be. */
  public static String text(double value) {
    return NumberText.people(value);
  }

  /** Bytes in words, as in "4.3 GB". */
  public static String bytes(double count) {
    String[] units = {"bytes", "kB", "MB", "GB", "TB", "PB", "EB"};
    int unit = 0;
    double rest = count;
    while (rest >= 1000 && unit < units.length - 1) {
      rest /= 1000;
      unit++;
    }
    return unit == 0
        ? (long) count + " bytes"
        : String.format(Locale.ROOT, rest < 10 ? "%.1f %s" : "%.0f %s", rest, units[unit]);
  }
}
