package org.palpate.io.table;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.MalformedInputException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.palpate.edit.EditSchedule;
import org.palpate.edit.VoxelChange;
import org.palpate.volume.VoxelGrid;

/**
 * Reads and writes tables of changed voxels, {@code frame,body,segment,i,j,k,solid}. Body and
 * segment are names; the body of a segment has its name. Columns are found by their names, and
 * further ones are allowed. One thread.
 */
public final class EditsCsv {
  private static final List<String> COLUMNS =
      List.of("frame", "body", "segment", "i", "j", "k", "solid");

  private final Path file;
  private final List<String> segments;
  private final VoxelGrid grid;
  private final List<VoxelChange> changes = new ArrayList<>();
  private int[] columns = {};
  private long lineNumber;

  private EditsCsv(Path file, List<String> segments, VoxelGrid grid) {
    this.file = file;
    this.segments = segments;
    this.grid = grid;
  }

  /** Returns a writer of rows, which has written the header; see {@link #add}. */
  public static CsvWriter writer(OutputStream stream) throws IOException {
    return new CsvWriter(stream, String.join(",", COLUMNS));
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
   * @param grid the grid in which the voxels lie
   * @throws CsvFormatException if the file is missing or not understood; the message names the line
   */
  public static EditSchedule read(Path file, List<String> segments, VoxelGrid grid)
      throws IOException {
    if (Files.isDirectory(file)) {
      throw new CsvFormatException("the path is a folder", file, "give a table of edits");
    }
    try (BufferedReader reader = Files.newBufferedReader(file, StandardCharsets.UTF_8)) {
      return new EditsCsv(file, segments, grid).read(reader);
    } catch (NoSuchFileException e) {
      throw new CsvFormatException("no such file", file, "check the path");
    } catch (MalformedInputException e) {
      throw new CsvFormatException("the file is no text", file, "give a table of edits");
    } catch (FileSystemException e) {
      throw new CsvFormatException("the file cannot be read", file, "check that you may read it");
    }
  }

  private EditSchedule read(BufferedReader reader) throws IOException {
    for (String line = reader.readLine(); line != null; line = reader.readLine()) {
      lineNumber++;
      if (line.isBlank() || line.startsWith("#")) {
        continue;
      }
      List<String> cells = cells(line.replace("\ufeff", ""));
      if (columns.length == 0) {
        readHeader(cells);
      } else {
        changes.add(change(cells));
      }
    }
    return new EditSchedule(changes);
  }

  /** Splits a row as RFC 4180 does. */
  private static List<String> cells(String line) {
    List<String> cells = new ArrayList<>();
    StringBuilder cell = new StringBuilder();
    boolean quoted = false;
    for (int n = 0; n < line.length(); n++) {
      char c = line.charAt(n);
      if (c == '"' && quoted && n + 1 < line.length() && line.charAt(n + 1) == '"') {
        cell.append(c);
        n++;
      } else if (c == '"') {
        quoted = !quoted;
      } else if (c == ',' && !quoted) {
        cells.add(cell.toString().strip());
        cell.setLength(0);
      } else {
        cell.append(c);
      }
    }
    cells.add(cell.toString().strip());
    return cells;
  }

  private void readHeader(List<String> names) throws CsvFormatException {
    columns = COLUMNS.stream().mapToInt(names::indexOf).toArray();
    int missing = Arrays.stream(columns).boxed().toList().indexOf(-1);
    if (missing >= 0) {
      throw wrong(
          "there is no column " + COLUMNS.get(missing), "begin with " + String.join(",", COLUMNS));
    }
  }

  private VoxelChange change(List<String> cells) throws CsvFormatException {
    String name = cell(cells, 2);
    int segment = segments.indexOf(name);
    if (segment < 0) {
      throw wrong("there is no segment " + name, "list them with palpate info");
    }
    if (!cell(cells, 1).equals(name)) {
      throw wrong("the body of segment " + name + " is not " + cell(cells, 1), "name it " + name);
    }
    long frame = number(cells, 0, Long.MAX_VALUE);
    int i = (int) number(cells, 3, grid.sizeX() - 1L);
    int j = (int) number(cells, 4, grid.sizeY() - 1L);
    int k = (int) number(cells, 5, grid.sizeZ() - 1L);
    return new VoxelChange(frame, segment, i, j, k, number(cells, 6, 1) == 1);
  }

  private String cell(List<String> cells, int column) {
    return columns[column] < cells.size() ? cells.get(columns[column]) : "";
  }

  private long number(List<String> cells, int column, long most) throws CsvFormatException {
    String word = cell(cells, column);
    boolean isNumber = word.matches("[0-9]{1,18}");
    if (!isNumber || Long.parseLong(word) > most) {
      throw wrong(
          COLUMNS.get(column) + " is " + (word.isEmpty() ? "missing" : word),
          most == Long.MAX_VALUE
              ? "write a whole number from 0 on"
              : "write a whole number from 0 to " + most);
    }
    return Long.parseLong(word);
  }

  private CsvFormatException wrong(String what, String remedy) {
    return new CsvFormatException(what, file, lineNumber, remedy);
  }
}
