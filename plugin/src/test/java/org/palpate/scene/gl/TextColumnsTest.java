package org.palpate.scene.gl;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class TextColumnsTest {
  private static final List<String> TEN_LINES =
      IntStream.range(0, 10).mapToObj(n -> "line " + n).toList();

  @Test
  void oneColumnIsUsedIfItFits() {
    TextColumns columns = TextColumns.of(TEN_LINES, String::length, 1, 2, 100, 10);
    assertEquals(new TextColumns(10, List.of(6), true), columns);
  }

  @Test
  void aLowPictureHasMoreColumns() {
    TextColumns columns = TextColumns.of(TEN_LINES, String::length, 1, 2, 100, 4);
    assertEquals(new TextColumns(4, List.of(6, 6, 6), true), columns);
    assertEquals(22, columns.totalWidth(2));
  }

  @Test
  void aPictureThatIsTooLowAndNarrowHasAsManyColumnsAsItsWidthPermits() {
    TextColumns columns = TextColumns.of(TEN_LINES, String::length, 1, 2, 15, 4);
    assertFalse(columns.fits());
    assertEquals(List.of(6, 6), columns.widths());
    assertTrue(columns.totalWidth(2) <= 15);
  }

  @Test
  void aLongLineIsBrokenBetweenWords() {
    List<String> wrapped = TextColumns.wrap(List.of("one two three", "four"), String::length, 8);
    assertEquals(List.of("one two", "three", "four"), wrapped);
  }

  @Test
  void aWordThatIsTooLongKeepsItsLine() {
    assertEquals(
        List.of("a", "verylongword", "b"),
        TextColumns.wrap(List.of("a verylongword b"), String::length, 4));
    assertEquals(List.of(""), TextColumns.wrap(List.of(""), String::length, 4));
  }
}
