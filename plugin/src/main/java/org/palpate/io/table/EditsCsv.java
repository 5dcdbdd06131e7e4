package org.palpate.io.table;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.palpate.edit.EditSchedule;
import org.palpate.edit.VoxelChange;
import org.palpate.volume.VoxelGrid;

/**
 * Reads and writes tables of changed voxels, {@code frame,body,segment,i,j,k,solid}. Body and
 * segment are names; the body of a segment has its name. Columns are found by their names, and
 * further ones are allowed. One thread.
 */
public final class EditsCsv implements CsvLines.Rows {
  private static final List<String> COLUMNS =
      List.of("frame", "body", "segment", "i", "j", "k", "solid");

  private static final String HEADER = String.join(",", COLUMNS);

  private final CsvLines lines;
  private final List<String> segments;
  private final List<VoxelGrid> grids;
  private final List<VoxelChange> changes = new ArrayList<>();
  private int[] columns = {};

  private EditsCsv(Path file, List<String> segments, List<VoxelGrid> grids) {
    lines = new CsvLines(file);
    this.segments = segments;
    this.grids = grids;
  }

  /** Returns a writer of rows, which has written the header; see {@link #add}. */
  public static CsvWriter writer(OutputStream stream) throws IOException {
    return new CsvWriter(stream, HEADER);
  }

  /** Writes a row. */
  public static void add(
      CsvWriter rows, long frame, String segment, int i, int j, int k, boolean solid)
      throws IOException {
    rows.cell(frame).cell(segment).cell(segment);
    rows.cell((long) i).cell((long) j).cell((long) k).cell(solid ? 1L : 0L).end();
  }

  /**
   * Reads a file to its end.
   *
   * @param segments names of the segments, in the order of their indices
   * @param grids the grid of each segment, in which its voxels lie
   * @throws CsvFormatException if the file is missing or not understood; the message names the line
   */
  public static EditSchedule read(Path file, List<String> segments, List<VoxelGrid> grids)
      throws IOException {
    EditsCsv reader = new EditsCsv(file, segments, grids);
    reader.lines.read(HEADER, reader);
    return new EditSchedule(reader.changes);
  }

  @Override
  public void header(List<String> names) throws CsvFormatException {
    columns = lines.neededColumns(names, COLUMNS);
  }

  @Override
  public void row(String[] words) throws CsvFormatException {
    changes.add(change(words));
  }

  private VoxelChange change(String[] words) throws CsvFormatException {
    String name = cell(words, 2);
    int segment = segments.indexOf(name);
    if (segment < 0) {
      throw lines.fault("there is no segment " + name, "list them with palpate info");
    }
    if (!cell(words, 1).equals(name)) {
      throw lines.fault(
          "the body of segment " + name + " is not " + cell(words, 1), "name it " + name);
    }
    long frame = number(words, 0, Long.MAX_VALUE);
    VoxelGrid grid = grids.get(segment);
    int i = (int) number(words, 3, grid.sizeX() - 1L);
    int j = (int) number(words, 4, grid.sizeY() - 1L);
    int k = (int) number(words, 5, grid.sizeZ() - 1L);
    return new VoxelChange(frame, segment, i, j, k, number(words, 6, 1) == 1);
  }

  private String cell(String[] words, int column) {
    return CsvLines.word(words, columns[column]);
  }

  private long number(String[] words, int column, long most) throws CsvFormatException {
    String word = cell(words, column);
    boolean isNumber = word.matches("[0-9]{1,18}");
    if (!isNumber || Long.parseLong(word) > most) {
      throw lines.fault(
          COLUMNS.get(column) + " is " + (word.isEmpty() ? "missing" : word),
          most == Long.MAX_VALUE
              ? "write a whole number from 0 on"
              : "write a whole number from 0 to " + most);
    }
    return Long.parseLong(word);
  }
}
