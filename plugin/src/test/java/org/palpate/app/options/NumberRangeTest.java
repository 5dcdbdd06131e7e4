package org.palpate.app.options;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class NumberRangeTest {
  private static final NumberRange WIDTH =
      new NumberRange("--width", "the width", 0.001, 2500, "mm", "3");

  @ParameterizedTest
  @ValueSource(doubles = {0.001, 1, 2500})
  void acceptsItsEndsAndWhatLiesBetween(double value) {
    assertEquals(value, WIDTH.check(value));
    assertEquals(OptionalDouble.of(value), WIDTH.checkGiven(value));
  }

  @Test
  void refusesTheNextNumbersBeyondItsEnds() {
    refuses(Math.nextDown(0.001), "9.999999999999998E-4");
    refuses(Math.nextUp(2500.0), "2500.0000000000005");
    refuses(Double.NaN, "NaN");
    refuses(Double.NEGATIVE_INFINITY, "-Infinity");
    refuses(-7, "-7");
  }

  private static void refuses(double value, String text) {
    Given.refuses(
        "the width must be a number from 0.001 to 2,500 mm: --width " + text + ": try --width 3",
        () -> WIDTH.checkGiven(value));
  }

  @Test
  void aNumberThatWasNotGivenIsNotChecked() {
    assertEquals(OptionalDouble.empty(), WIDTH.checkGiven(null));
  }

  @Test
  void aQuantityWithoutAUnitLeavesNoBlankBehind() {
    NumberRange friction = new NumberRange("--friction", "the friction", 0, 100, "", "0.2");
    Given.refuses(
        "the friction must be a number from 0 to 100: --friction 101: try --friction 0.2",
        () -> friction.check(101));
  }

  @Test
  void endsAreWrittenOutWithoutAnExponent() {
    assertEquals("0.000001 to 1,000,000", NumberRange.positive("--x", "x", "N").text());
    assertEquals("0.001 to 100,000,000", NumberRange.seconds().text());
  }
}
