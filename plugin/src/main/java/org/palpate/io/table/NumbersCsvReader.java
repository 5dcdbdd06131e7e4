package org.palpate.io.table;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * Reads numbers: a header that names the wanted columns in any order and perhaps others, then rows.
 * A NaN or an infinity is refused.
 */
public final class NumbersCsvReader implements CsvLines.Rows {
  private final List<String> wanted;
  private final CsvLines lines;
  private final List<double[]> rows = new ArrayList<>();
  private int[] columns = {};

  private NumbersCsvReader(Path file, List<String> wanted) {
    lines = new CsvLines(file);
    this.wanted = wanted;
  }

  /**
   * Reads a file to its end.
   *
   * @param wanted the names of the columns
   * @return the numbers of each row, in the order of {@code wanted}
   * @throws CsvFormatException if the file is missing or not understood; the message names the line
   */
  public static List<double[]> read(Path file, List<String> wanted) throws IOException {
    NumbersCsvReader reader = new NumbersCsvReader(file, wanted);
    reader.lines.read(String.join(",", wanted), reader);
    return reader.rows;
  }

  @Override
  public void header(List<String> names) throws CsvFormatException {
    columns = lines.neededColumns(names, wanted);
  }

  @Override
  public void row(String[] words) throws CsvFormatException {
    double[] row = new double[columns.length];
    for (int n = 0; n < columns.length; n++) {
      String word = CsvLines.word(words, columns[n]);
      row[n] = lines.number(word, wanted.get(n));
      if (!Double.isFinite(row[n])) {
        throw lines.fault(wanted.get(n) + " is " + word, "correct the row");
      }
    }
    rows.add(row);
  }
}
