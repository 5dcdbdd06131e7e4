package org.palpate.io.file;

import java.util.Locale;
import java.util.regex.Pattern;

/** Parses numbers as file headers write them. */
public final class NumberParser {
  private static final Pattern DECIMAL =
      Pattern.compile("[-+]?([0-9]+\\.?[0-9]*|\\.[0-9]+)([eE][-+]?[0-9]+)?");

  private NumberParser() {}

  /** Returns an integer from 1 to 2^31-1, or 0 if the text is not one. */
  public static int positiveInt(String text) {
    try {
      return Math.max(0, Integer.parseInt(text.strip()));
    } catch (NumberFormatException e) {
      return 0;
    }
  }

  /** Returns a number with a decimal point, or NaN if the text is not one. */
  public static double number(String text) {
    String word = text.strip();
    // Double.parseDouble also accepts 1d, 1f and hexadecimal, which no header means
    return DECIMAL.matcher(word).matches() ? Double.parseDouble(word) : specialNumber(word);
  }

  private static double specialNumber(String word) {
    return switch (word.toLowerCase(Locale.ROOT)) {
      case "inf", "+inf", "infinity" -> Double.POSITIVE_INFINITY;
      case "-inf", "-infinity" -> Double.NEGATIVE_INFINITY;
      default -> Double.NaN;
    };
  }
}
