package org.palpate.benchmarks.report;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Pairs the cells of a row with the columns of its table. */
public final class Row {
  private Row() {}

  /** Returns the cells by column, and fails if their numbers differ. */
  public static Map<String, Object> of(List<String> columns, List<Object> cells) {
    assertEquals(columns.size(), cells.size(), columns + " " + cells);
    Map<String, Object> row = new LinkedHashMap<>();
    for (int n = 0; n < cells.size(); n++) {
      row.put(columns.get(n), cells.get(n));
    }
    assertEquals(columns.size(), row.size(), "two columns share a name: " + columns);
    return row;
  }

  /** Returns the cells of a study's row by column. */
  public static Map<String, Object> of(StudyTable table, List<Object> cells) {
    return of(table.columns(), cells);
  }
}
