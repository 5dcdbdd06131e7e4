package org.palpate.io.table;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.palpate.body.BodyEvent;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.io.file.NumberText;
import org.palpate.rigid.ReferencePose;

/**
 * Reads and writes poses of bodies: a header that names {@code frame,body,x,y,z,qw,qx,qy,qz} in any
 * order, then a row for each pose. A pose leads from rest to present, world mm. Frames count from 0
 * and do not run backward. Quaternions are scaled to the norm 1.
 *
 * <p>A recorded table has the columns {@code event} and {@code hx,hy,hz,hqw,hqx,hqy,hqz} as well,
 * see {@link BodyPose}. Further columns are allowed. One thread.
 */
public final class PosesCsv implements CsvLines.Rows {
  private static final List<String> COLUMNS =
      List.of("frame", "body", "x", "y", "z", "qw", "qx", "qy", "qz");

  private static final List<String> RECORDED =
      List.of("event", "hx", "hy", "hz", "hqw", "hqx", "hqy", "hqz");

  private static final String HEADER = String.join(",", COLUMNS);
  private static final double LARGEST_FRAME = 1e15;

  private final CsvLines lines;
  private final List<String> bodies;
  private final List<BodyPose> poses = new ArrayList<>();
  private int[] columns = {};
  private int[] recordedColumns = {};
  private double lastFrame;

  private PosesCsv(Path file, List<String> bodies) {
    lines = new CsvLines(file);
    this.bodies = bodies;
  }

  /** Returns a writer of recorded rows, which has written the header; see {@link #add}. */
  public static CsvWriter writer(OutputStream stream) throws IOException {
    return new CsvWriter(stream, HEADER + "," + String.join(",", RECORDED));
  }

  /** Writes a row of a recorded table. */
  public static void add(
      CsvWriter rows, long frame, String body, BodyEvent event, Pose pose, Pose inHand)
      throws IOException {
    rows.cell(frame).cell(body);
    add(rows, pose);
    rows.cell(event.name().toLowerCase(Locale.ROOT));
    if (event == BodyEvent.TAKEN) {
      add(rows, inHand);
    } else {
      for (int n = 1; n < RECORDED.size(); n++) {
        rows.cell("");
      }
    }
    rows.end();
  }

  private static void add(CsvWriter rows, Pose pose) {
    Quaternion q = pose.rotation;
    rows.cell(pose.translation.x).cell(pose.translation.y).cell(pose.translation.z);
    rows.cell(q.w).cell(q.x).cell(q.y).cell(q.z);
  }

  /**
   * Reads a file to its end.
   *
   * @param bodies the names of all bodies in the order of the scene
   * @return the poses in the order of their frames
   * @throws CsvFormatException if the file is missing or not understood, or names a body that does
   *     not exist; the message names the line
   */
  public static List<BodyPose> read(Path file, List<String> bodies) throws IOException {
    PosesCsv reader = new PosesCsv(file, bodies);
    reader.lines.read(HEADER, reader);
    return reader.poses;
  }

  @Override
  public void header(List<String> names) throws CsvFormatException {
    columns = lines.neededColumns(names, COLUMNS);
    recordedColumns = CsvLines.columns(names, RECORDED);
  }

  @Override
  public void row(String[] words) throws CsvFormatException {
    long frame = frame(words);
    int body = body(CsvLines.word(words, columns[1]));
    Pose pose = pose(words, columns, COLUMNS, 2);
    requireNear(pose);
    BodyEvent event = event(words);
    Pose inHand = event == BodyEvent.TAKEN ? pose(words, recordedColumns, RECORDED, 1) : new Pose();
    poses.add(new BodyPose(frame, body, event, pose, inHand));
  }

  private Pose pose(String[] words, int[] at, List<String> names, int first)
      throws CsvFormatException {
    double[] values = new double[7];
    for (int n = 0; n < values.length; n++) {
      values[n] = number(words, at[first + n], names.get(first + n));
    }
    Pose pose = new Pose();
    pose.translation.set(values[0], values[1], values[2]);
    pose.rotation.set(values[3], values[4], values[5], values[6]);
    if (!pose.rotation.isNearUnit()) {
      throw lines.fault(
          "the quaternion "
              + String.join(",", names.subList(first + 3, first + 7))
              + " has the norm "
              + NumberText.text(pose.rotation.norm())
              + " instead of 1",
          "normalize it");
    }
    pose.rotation.normalize();
    return pose;
  }

  private void requireNear(Pose pose) throws CsvFormatException {
    for (int axis = 0; axis < 3; axis++) {
      double mm = pose.translation.get(axis);
      if (Math.abs(mm) > ReferencePose.LARGEST_MM) {
        throw lines.fault(
            COLUMNS.get(2 + axis) + " is " + NumberText.text(mm),
            "no body moves farther than 1048576 mm along an axis");
      }
    }
  }

  private double number(String[] words, int column, String name) throws CsvFormatException {
    String word = column < 0 ? "" : CsvLines.word(words, column);
    double value = lines.number(word, name);
    if (!Double.isFinite(value)) {
      throw lines.fault(name + " is " + word, "correct the row");
    }
    return value;
  }

  private BodyEvent event(String[] words) throws CsvFormatException {
    String word = recordedColumns[0] < 0 ? "" : CsvLines.word(words, recordedColumns[0]);
    if (word.isEmpty()) {
      return BodyEvent.MOVED;
    }
    for (BodyEvent event : BodyEvent.values()) {
      if (event.name().toLowerCase(Locale.ROOT).equals(word)) {
        return event;
      }
    }
    throw lines.fault(
        "event is " + word, "write moved, taken, joined, held, released or placed, or nothing");
  }

  private int body(String name) throws CsvFormatException {
    int body = bodies.indexOf(name);
    if (body < 0) {
      throw lines.fault("there is no body " + name, "name a segment of the volume");
    }
    return body;
  }

  private long frame(String[] words) throws CsvFormatException {
    double frame = number(words, columns[0], COLUMNS.get(0));
    if (frame != Math.rint(frame) || frame < 0 || frame > LARGEST_FRAME) {
      throw lines.fault("frame is " + NumberText.text(frame), "count frames from 0");
    }
    if (frame < lastFrame) {
      throw lines.fault(
          "frames run backward, from "
              + NumberText.text(lastFrame)
              + " to "
              + NumberText.text(frame),
          "sort the rows");
    }
    lastFrame = frame;
    return (long) frame;
  }
}
