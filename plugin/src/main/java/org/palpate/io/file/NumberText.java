package org.palpate.io.file;

import com.fasterxml.jackson.core.io.NumberOutput;

/** Formats numbers for tables and messages. */
public final class NumberText {
  private NumberText() {}

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
    return NumberParser.bytes(count);
  }
}
