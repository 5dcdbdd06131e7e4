package org.palpate.io.table;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.palpate.elastic.RecordedUpdate;
import org.palpate.elastic.lattice.CellStiffness;
import org.palpate.geometry.Vec3;
import org.palpate.io.file.NumberText;

/**
 * Reads and writes tables of the updates of elastic segments, {@code frame,x,y,z,fx,fy,fz,cells}.
 * The frame is the one in which an update came into use, or -1. Cells are texts {@code
 * cell:solid:rest:mx:my:mz} with blanks between, one for each cell whose voxels were counted anew
 * before the update: its number, moduli in N/mm^2, and second moments. Columns are found by their
 * names, and further ones are allowed. One thread.
 */
public final class FieldsCsv implements CsvLines.Rows {
  private static final List<String> COLUMNS =
      List.of("frame", "x", "y", "z", "fx", "fy", "fz", "cells");

  private static final String HEADER = String.join(",", COLUMNS);
  private static final int CELLS = 7;

  private final CsvLines lines;
  private final List<RecordedUpdate> updates = new ArrayList<>();
  private int[] columns = {};
  private long lastFrame;

  private FieldsCsv(Path file) {
    lines = new CsvLines(file);
  }

  /** Returns a writer of rows, which has written the header; see {@link #add}. */
  public static CsvWriter writer(OutputStream stream) throws IOException {
    return new CsvWriter(stream, HEADER);
  }

  /** Writes a row. */
  public static void add(CsvWriter rows, RecordedUpdate update) throws IOException {
    rows.cell(update.frame());
    for (Vec3 vector : List.of(update.point(), update.forceNewton())) {
      rows.cell(vector.x).cell(vector.y).cell(vector.z);
    }
    rows.cell(update.refills().stream().map(FieldsCsv::text).collect(Collectors.joining(" ")));
    rows.end();
  }

  private static String text(RecordedUpdate.Refill refill) {
    CellStiffness stiffness = refill.stiffness();
    return Stream.of(
            stiffness.solidModulus(),
            stiffness.restModulus(),
            stiffness.momentX(),
            stiffness.momentY(),
            stiffness.momentZ())
        .map(number -> NumberText.text(number))
        .collect(Collectors.joining(":", refill.cell() + ":", ""));
  }

  /**
   * Reads a file to its end.
   *
   * @throws CsvFormatException if the file is missing or not understood; the message names the line
   */
  public static List<RecordedUpdate> read(Path file) throws IOException {
    FieldsCsv reader = new FieldsCsv(file);
    reader.lines.read(HEADER, reader);
    return reader.updates;
  }

  @Override
  public void header(List<String> names) throws CsvFormatException {
    columns = lines.neededColumns(names, COLUMNS);
  }

  @Override
  public void row(String[] words) throws CsvFormatException {
    List<RecordedUpdate.Refill> refills = new ArrayList<>();
    for (String word : cell(words, CELLS).split(" ", -1)) {
      if (!word.isEmpty()) {
        refills.add(refill(word));
      }
    }
    updates.add(new RecordedUpdate(frame(words), vector(words, 1), vector(words, 4), refills));
  }

  private String cell(String[] words, int column) {
    return CsvLines.word(words, columns[column]);
  }

  private long frame(String[] words) throws CsvFormatException {
    String word = cell(words, 0);
    if (word.equals(Long.toString(RecordedUpdate.UNUSED))) {
      return RecordedUpdate.UNUSED;
    }
    boolean isNumber = word.matches("[0-9]{1,18}");
    if (!isNumber || Long.parseLong(word) < lastFrame) {
      throw lines.fault(
          "frame is " + (word.isEmpty() ? "missing" : word),
          "write -1, or a whole number that is not below the last one");
    }
    lastFrame = Long.parseLong(word);
    return lastFrame;
  }

  private Vec3 vector(String[] words, int first) throws CsvFormatException {
    return new Vec3(
        finite(cell(words, first), first),
        finite(cell(words, first + 1), first + 1),
        finite(cell(words, first + 2), first + 2));
  }

  private double finite(String word, int column) throws CsvFormatException {
    double number = lines.number(word, COLUMNS.get(column));
    if (!Double.isFinite(number)) {
      throw lines.fault(COLUMNS.get(column) + " is " + word, "write a finite number");
    }
    return number;
  }

  private RecordedUpdate.Refill refill(String word) throws CsvFormatException {
    String[] parts = word.split(":", -1);
    if (parts.length != 6 || !parts[0].matches("[0-9]{1,9}")) {
      throw lines.fault("a cell is " + word, "write cell:solid:rest:mx:my:mz");
    }
    float[] numbers = new float[5];
    for (int n = 0; n < numbers.length; n++) {
      numbers[n] = (float) finite(parts[n + 1], CELLS);
      if (!(numbers[n] >= 0)) {
        throw lines.fault("a number of a cell is negative: " + word, "write numbers from 0 on");
      }
    }
    if (numbers[1] == 0) {
      throw lines.fault(
          "a cell has no modulus: " + word, "write one above 0 after the second colon");
    }
    CellStiffness stiffness =
        new CellStiffness(numbers[0], numbers[1], numbers[2], numbers[3], numbers[4]);
    return new RecordedUpdate.Refill(Integer.parseInt(parts[0]), stiffness);
  }
}
