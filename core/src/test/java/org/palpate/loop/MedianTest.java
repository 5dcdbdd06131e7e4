package org.palpate.loop;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;

class MedianTest {
  @Test
  void isTheMiddleOfAnOddNumberOfValues() {
    assertEquals(3, Median.of(9, 1, 3));
    assertEquals(7, Median.of(7));
  }

  @Test
  void isTheMeanOfTheTwoMiddleOnesOfAnEvenNumber() {
    assertEquals(2.5, Median.of(4, 1, 2, 3));
  }

  @Test
  void leavesItsArgumentAsItWas() {
    double[] values = {3, 1, 2};
    Median.of(values);
    assertArrayEquals(new double[] {3, 1, 2}, values);
  }

  @Test
  void refusesToGuessWithoutValues() {
    assertThrows(IllegalArgumentException.class, Median::of);
  }
}
