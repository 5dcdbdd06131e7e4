package org.palpate.io.table;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import org.palpate.geometry.Quaternion;
import org.palpate.io.file.NumberText;

/**
 * Reads a trajectory: a header that names {@code t_ms,x,y,z} in any order, optionally {@code
 * qw,qx,qy,qz}, {@code flags} and other columns, then a line for each sample. Empty lines and lines
 * that start with # are skipped. Quaternions are scaled to the norm 1.
 *
 * <p>A table of frames, which has {@code dx,dy,dz} and perhaps {@code dqw,dqx,dqy,dqz} instead, is
 * read as the trajectory of its device poses.
 */
public final class TrajectoryCsvReader implements CsvLines.Rows {
  private static final List<String> NEEDED = List.of("t_ms", "x", "y", "z");
  private static final List<String> ROTATION = List.of("qw", "qx", "qy", "qz");

  /** The device pose in a table of frames. */
  private static final List<String> NEEDED_OF_FRAMES = List.of("t_ms", "dx", "dy", "dz");

  private static final List<String> ROTATION_OF_FRAMES = List.of("dqw", "dqx", "dqy", "dqz");
  private static final double[] NO_ROTATION = {1, 0, 0, 0};

  private static final String FLAGS = "flags";

  /** The flag of a sample at which the device jumped. */
  private static final int RELOCATED_FLAG = 4;

  /** Receives samples in order. */
  @FunctionalInterface
  public interface SampleSink {
    /**
     * Receives a sample: time in ms, position, and orientation, the identity if there is none. In
     * an unchecked file the quaternion may be anything.
     */
    void add(
        double timeMs, double x, double y, double z, double qw, double qx, double qy, double qz);

    /** Reports that the device jumped at the sample that was added last. */
    default void markRelocated() {}
  }

  private final Path file;
  private final boolean checked;
  private final SampleSink sink;
  private final CsvLines lines;
  private final double[] needed = new double[NEEDED.size()];
  private final double[] rotation = new double[ROTATION.size()];
  private final Quaternion quaternion = new Quaternion();
  private List<String> neededNames = NEEDED;
  private int[] neededColumns = {};
  private int[] rotationColumns = {};
  private int flagsColumn = -1;
  private double lastMs = Double.NEGATIVE_INFINITY;
  private long samples;

  private TrajectoryCsvReader(Path file, boolean checked, SampleSink sink) {
    this.file = file;
    this.checked = checked;
    this.sink = sink;
    lines = new CsvLines(file);
  }

  /**
   * Reads a file to its end.
   *
   * @param checked whether NaN, infinity, times that run backward and quaternions whose norm is not
   *     1 are refused
   * @return the number of samples, at least 1
   * @throws CsvFormatException if the file is missing or not understood; the message names the line
   */
  public static long read(Path file, boolean checked, SampleSink sink) throws IOException {
    return new TrajectoryCsvReader(file, checked, sink).read();
  }

  private long read() throws IOException {
    lines.read("t_ms,x,y,z", this);
    if (samples == 0) {
      throw new CsvFormatException(
          "the file has no sample", file, "give a header t_ms,x,y,z and rows");
    }
    return samples;
  }

  @Override
  public void header(List<String> names) throws CsvFormatException {
    boolean ofFrames = names.containsAll(NEEDED_OF_FRAMES) && !names.containsAll(NEEDED);
    neededNames = ofFrames ? NEEDED_OF_FRAMES : NEEDED;
    neededColumns = lines.neededColumns(names, neededNames);
    int[] found = CsvLines.columns(names, ofFrames ? ROTATION_OF_FRAMES : ROTATION);
    rotationColumns = Arrays.stream(found).allMatch(n -> n >= 0) ? found : new int[0];
    flagsColumn = names.indexOf(FLAGS);
  }

  @Override
  public void row(String[] words) throws CsvFormatException {
    read(words, neededColumns, neededNames, needed);
    if (rotationColumns.length > 0) {
      read(words, rotationColumns, ROTATION, rotation);
      normalizeRotation();
    } else {
      System.arraycopy(NO_ROTATION, 0, rotation, 0, NO_ROTATION.length);
    }
    if (checked && needed[0] < lastMs) {
      throw lines.fault(
          "time runs backward, from "
              + NumberText.text(lastMs)
              + " to "
              + NumberText.text(needed[0]),
          "sort the rows, or accept it with --raw-device");
    }
    lastMs = needed[0];
    samples++;
    sink.add(
        needed[0],
        needed[1],
        needed[2],
        needed[3],
        rotation[0],
        rotation[1],
        rotation[2],
        rotation[3]);
    if (isRelocated(words)) {
      sink.markRelocated();
    }
  }

  /** Whether the flags say that the device jumped; a column of other programs says nothing. */
  private boolean isRelocated(String[] words) {
    if (flagsColumn < 0 || flagsColumn >= words.length) {
      return false;
    }
    String word = words[flagsColumn].strip();
    return word.matches("[0-7]") && (Integer.parseInt(word) & RELOCATED_FLAG) != 0;
  }

  private void normalizeRotation() throws CsvFormatException {
    quaternion.set(rotation[0], rotation[1], rotation[2], rotation[3]);
    if (quaternion.isNearUnit()) {
      quaternion.normalize();
      rotation[0] = quaternion.w;
      rotation[1] = quaternion.x;
      rotation[2] = quaternion.y;
      rotation[3] = quaternion.z;
    } else if (checked) {
      throw lines.fault(
          "the quaternion qw,qx,qy,qz has the norm "
              + NumberText.text(quaternion.norm())
              + " instead of 1",
          "normalize it, or accept it with --raw-device");
    }
  }

  private void read(String[] words, int[] columns, List<String> names, double[] dest)
      throws CsvFormatException {
    for (int n = 0; n < columns.length; n++) {
      String word = CsvLines.word(words, columns[n]);
      dest[n] = lines.number(word, names.get(n));
      if (checked && !Double.isFinite(dest[n])) {
        throw lines.fault(
            names.get(n) + " is " + word, "correct the row, or accept it with --raw-device");
      }
    }
  }
}
