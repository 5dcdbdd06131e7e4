package org.palpate.io;

import java.util.Locale;

/** Numbers as headers write them, and as people read them. */
final class Numbers {
  private Numbers() {}

  /** A whole number from 1 to 2^31-1, or 0 where the text is none. */
  static int positiveInt(String text) {
    try {
      return Math.max(0, Integer.parseInt(text.strip()));
    } catch (NumberFormatException e) {
      return 0;
    }
  }

  /** A number with a dot; NaN where the text is none. */
  static double number(String text) {
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
  static String text(double value) {
    return CsvNumbers.people(value);
  }

  /** Bytes in words, as in "4.3 GB". */
  static String bytes(double count) {
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
