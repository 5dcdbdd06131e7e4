package org.palpate.benchmarks.report;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Function;
import org.palpate.io.file.AtomicFile;
import org.palpate.io.table.CsvWriter;

/** Writes the table of a study as a CSV file. */
public final class TableFile {
  private TableFile() {}

  /**
   * Writes a header and a row for each result, and replaces an earlier file.
   *
   * @param cells returns the cells of a result: floating-point numbers, integers or texts
   * @throws IllegalArgumentException if a row has more or fewer cells than the table has columns;
   *     the target is then unchanged
   */
  public static <R> void write(
      Path file, List<String> columns, Iterable<R> results, Function<R, List<Object>> cells)
      throws IOException {
    try (AtomicFile out = new AtomicFile(file)) {
      CsvWriter table = new CsvWriter(out.stream(), String.join(",", columns));
      for (R result : results) {
        List<Object> row = cells.apply(result);
        if (row.size() != columns.size()) {
          throw new IllegalArgumentException(
              file + ": a row has " + row.size() + " cells for " + columns.size() + " columns");
        }
        row.forEach(cell -> add(table, cell));
        table.end();
      }
      out.commit();
    }
  }

  private static void add(CsvWriter table, Object cell) {
    if (cell instanceof Double number) {
      table.cell(number.doubleValue());
    } else if (cell instanceof Number integer) {
      table.cell(integer.longValue());
    } else {
      table.cell((String) cell);
    }
  }
}
