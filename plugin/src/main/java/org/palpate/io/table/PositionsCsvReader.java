package org.palpate.io.table;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.palpate.geometry.Vec3;

/**
 * Reads positions: a header that names {@code x,y,z} in any order and perhaps other columns, then a
 * row for each position. Tables of landmarks and trajectories are such tables.
 */
public final class PositionsCsvReader implements CsvLines.Rows {
  private static final List<String> COLUMNS = List.of("x", "y", "z");

  private final CsvLines lines;
  private final List<Vec3> positions = new ArrayList<>();
  private int[] columns = {};

  private PositionsCsvReader(Path file) {
    lines = new CsvLines(file);
  }

  /**
   * Reads a file to its end.
   *
   * @return the positions in the order of the rows
   * @throws CsvFormatException if the file is missing or not understood; the message names the line
   */
  public static List<Vec3> read(Path file) throws IOException {
    PositionsCsvReader reader = new PositionsCsvReader(file);
    reader.lines.read("x,y,z", reader);
    return reader.positions;
  }

  @Override
  public void header(List<String> names) throws CsvFormatException {
    columns = lines.neededColumns(names, COLUMNS);
  }

  @Override
  public void row(String[] words) throws CsvFormatException {
    Vec3 position = new Vec3();
    for (int axis = 0; axis < columns.length; axis++) {
      String word = CsvLines.word(words, columns[axis]);
      double value = lines.number(word, COLUMNS.get(axis));
      if (!Double.isFinite(value)) {
        throw lines.fault(COLUMNS.get(axis) + " is " + word, "correct the row");
      }
      position.set(axis, value);
    }
    positions.add(position);
  }
}
