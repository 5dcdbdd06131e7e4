package org.palpate.io.dicom;

import java.math.BigDecimal;
import java.math.MathContext;
import org.palpate.io.file.NumberText;

/** Formats numbers as the decimal strings of DICOM, of at most 16 characters. */
final class DecimalString {
  private static final int MAX_CHARACTERS = 16;
  private static final int MAX_DIGITS = 17;

  private DecimalString() {}

  /** Returns the nearest decimal that fits. */
  static String of(double number) {
    String shortest = NumberText.display(number + 0.0);
    if (shortest.length() <= MAX_CHARACTERS) {
      return shortest;
    }
    for (int digits = MAX_DIGITS; digits > 1; digits--) {
      BigDecimal rounded = new BigDecimal(number).round(new MathContext(digits));
      String plain = rounded.stripTrailingZeros().toPlainString();
      String text = plain.length() <= MAX_CHARACTERS ? plain : rounded.toString();
      if (text.length() <= MAX_CHARACTERS) {
        return text;
      }
    }
    throw new IllegalArgumentException("no decimal string for number=" + number);
  }
}
