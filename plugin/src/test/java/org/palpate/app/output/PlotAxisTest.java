package org.palpate.app.output;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class PlotAxisTest {
  private static final PlotAxis DECADES = new PlotAxis("us", 1, 1000, true);

  @ParameterizedTest
  @CsvSource({
    "10, 0 2 4 6 8 10",
    "5, 0 1 2 3 4 5",
    "1, 0 0.2 0.4 0.6 0.8 1",
    "7, 0 2 4 6",
    "26, 0 10 20",
    "0.35, 0 0.1 0.2 0.3",
    "12000, 0 5000 10000"
  })
  void ticksAreRoundValuesBetweenTheEnds(double high, String ticks) {
    assertEquals(ticks, texts(PlotAxis.fromZero("s", high)));
  }

  @Test
  void ticksBeginAtTheFirstRoundValueAboveTheLowerEnd() {
    assertEquals("-4 -2 0 2", texts(new PlotAxis("mm", -5, 3, false)));
    assertEquals("-10 -8 -6 -4 -2", texts(new PlotAxis("mm", -10, -2, false)));
  }

  @Test
  void ticksOfALogarithmicAxisArePowersOfTen() {
    assertEquals("1 10 100 1000", texts(DECADES));
    assertEquals("10 100", texts(new PlotAxis("us", 3, 300, true)));
    assertEquals("0.001 0.01", texts(new PlotAxis("N", 0.001, 0.05, true)));
  }

  @Test
  void anAxisWithoutLabelHasNoTicks() {
    assertEquals(List.of(), new PlotAxis("", 0, 10, false).ticks());
  }

  @Test
  void equalDifferencesHaveEqualLengths() {
    PlotAxis axis = new PlotAxis("mm", -2, 8, false);
    assertEquals(100, axis.place(-2, 100, 200));
    assertEquals(150, axis.place(3, 100, 200));
    assertEquals(220, axis.place(10, 100, 200), "beyond the end");
    assertEquals(20, axis.place(6, 100, 0), "downwards");
  }

  @Test
  void equalRatiosHaveEqualLengthsOnALogarithmicAxis() {
    assertEquals(100, DECADES.place(1, 100, 400));
    assertEquals(200, DECADES.place(10, 100, 400), 1e-9);
    assertEquals(400, DECADES.place(1000, 100, 400), 1e-9);
    assertEquals(100, DECADES.place(0, 100, 400), "zero stands at the lower end");
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, -3, Double.NaN, Double.POSITIVE_INFINITY})
  void anAxisWithoutAnUpperEndReachesToOne(double high) {
    assertEquals(1, PlotAxis.fromZero("N", high).high());
  }

  @Test
  void textsHaveNoRoundingNoise() {
    assertEquals("0.3", PlotAxis.text(0.1 + 0.2));
    assertEquals("100000", PlotAxis.text(1e5));
    assertEquals("0.0001", PlotAxis.text(1e-4));
    assertEquals("5E-7", PlotAxis.text(5e-7));
    assertEquals("-20", PlotAxis.text(-20));
  }

  private static String texts(PlotAxis axis) {
    Stream<String> texts = axis.ticks().stream().map(PlotAxis::text);
    return String.join(" ", texts.toList());
  }
}
