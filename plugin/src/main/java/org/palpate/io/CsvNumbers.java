package org.palpate.io;

import com.fasterxml.jackson.core.io.NumberOutput;

/** Numbers as tables hold them. */
public final class CsvNumbers {
  private CsvNumbers() {}

  /**
   * The shortest decimal that reads back as the same double, with a dot, alike on every JDK and in
   * every locale; {@code NaN}, {@code Infinity} or {@code -Infinity} where it is not finite.
   */
  public static String text(double value) {
    return NumberOutput.toString(value, true);
  }

  /** The same for a person: whole numbers without a fraction. */
  public static String people(double value) {
    return value == Math.rint(value) && Math.abs(value) < 1e15
        ? Long.toString((long) value)
        : text(value);
  }

  /** Bytes for a person, as in "4.3 GB". */
  public static String bytes(double count) {
    return Numbers.bytes(count);
  }
}
