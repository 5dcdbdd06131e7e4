package org.palpate.io.file;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Locale;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class NumbersTest {
  private static final long SEED = Long.getLong("palpate.seed", 20261128);

  @ParameterizedTest
  @CsvSource({
    "1, 1",
    "+1.5, 1.5",
    "-.5, -0.5",
    "5., 5",
    "' 2e-3 ', 0.002",
    "1E+2, 100",
    "inf, Infinity",
    "+Inf, Infinity",
    "-INFINITY, -Infinity"
  })
  void aDecimalIsReadAsHeadersWriteIt(String text, double value) {
    assertEquals(value, NumberParser.number(text));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"", "1d", "1f", "0x1p3", "1,5", "1e", "e5", ".", "--1", "1 2", "nan", "x"})
  void whatNoHeaderMeansIsNotANumber(String text) {
    assertEquals(Double.NaN, NumberParser.number(text));
  }

  @ParameterizedTest
  @CsvSource({
    "1, 1",
    "' 2147483647 ', 2147483647",
    "2147483648, 0",
    "0, 0",
    "-3, 0",
    "1.0, 0",
    "'', 0",
    "x, 0"
  })
  void aSizeIsAPositiveInteger(String text, int value) {
    assertEquals(value, NumberParser.positiveInt(text));
  }

  @Test
  void everyTextIsReadBackToTheSameBits() {
    SplittableRandom random = new SplittableRandom(SEED);
    for (int n = 0; n < 20_000; n++) {
      double value = Double.longBitsToDouble(random.nextLong());
      double again = Double.parseDouble(NumberText.text(value));
      if (!Double.isNaN(value)) {
        assertEquals(value, again, "seed=" + SEED + " n=" + n);
      }
    }
  }

  @ParameterizedTest
  @CsvSource({
    "3, 3.0, 3, 3",
    "-0.5, -0.5, -0.5, -0.5",
    "1234567, 1234567.0, 1234567, '1,234,567'",
    "1e15, 1.0E15, 1.0E15, 1.0E15",
    "999999999999999, 9.99999999999999E14, 999999999999999, '999,999,999,999,999'",
    "NaN, NaN, NaN, NaN",
    "-Infinity, -Infinity, -Infinity, -Infinity"
  })
  void aNumberHasATextForTablesOneForMessagesAndOneForCounts(
      double value, String text, String display, String count) {
    assertEquals(text, NumberText.text(value));
    assertEquals(display, NumberText.display(value));
    assertEquals(count, NumberText.count(value));
  }

  @Test
  void theLocaleChangesNothing() {
    Locale before = Locale.getDefault();
    Locale.setDefault(Locale.GERMANY);
    try {
      assertEquals("1.5", NumberText.text(1.5));
      assertEquals("1,234,567", NumberText.count(1234567));
      assertEquals("1.5 kB", NumberText.bytes(1500));
    } finally {
      Locale.setDefault(before);
    }
  }

  @ParameterizedTest
  @CsvSource({"0.0004, 0", "-0.0004, 0", "0.0005, 0", "0.0006, 0.001", "2.34567, 2.346", "7, 7"})
  void aRoundedNumberHasThousandthsAtMost(double value, String text) {
    assertEquals(text, NumberText.thousandths(value));
  }

  @ParameterizedTest
  @CsvSource({
    "0, 0 bytes",
    "999, 999 bytes",
    "1000, 1.0 kB",
    "9949, 9.9 kB",
    "12345, 12 kB",
    "4300000000, 4.3 GB",
    "2e18, 2.0 EB",
    "5e21, 5000 EB"
  })
  void bytesAreRoundedToAUnit(double count, String text) {
    assertEquals(text, NumberText.bytes(count));
  }
}
