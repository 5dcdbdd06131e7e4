package org.palpate.io.table;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.palpate.geometry.Pose;
import org.palpate.io.file.NumberText;

/**
 * Reads poses of bodies: a header that names {@code frame,body,x,y,z,qw,qx,qy,qz} in any order,
 * then a row for each pose. A pose leads from rest to present, world mm. Frames count from 0 and do
 * not run backward. Quaternions are scaled to the norm 1.
 */
public final class PosesCsvReader implements CsvLines.Rows {
  private static final List<String> COLUMNS =
      List.of("frame", "body", "x", "y", "z", "qw", "qx", "qy", "qz");

  private static final String HEADER = String.join(",", COLUMNS);
  private static final double LARGEST_FRAME = 1e15;

  private final CsvLines lines;
  private final List<String> bodies;
  private final List<BodyPose> poses = new ArrayList<>();
  private final double[] values = new double[COLUMNS.size()];
  private int[] columns = {};
  private double lastFrame;

  private PosesCsvReader(Path file, List<String> bodies) {
    lines = new CsvLines(file);
    this.bodies = bodies;
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
    PosesCsvReader reader = new PosesCsvReader(file, bodies);
    reader.lines.read(HEADER, reader);
    return reader.poses;
  }

  @Override
  public void header(List<String> names) throws CsvFormatException {
    columns = lines.neededColumns(names, COLUMNS);
  }

  @Override
  public void row(String[] words) throws CsvFormatException {
    for (int n = 0; n < columns.length; n++) {
      if (n != 1) {
        String word = CsvLines.word(words, columns[n]);
        values[n] = lines.number(word, COLUMNS.get(n));
        if (!Double.isFinite(values[n])) {
          throw lines.fault(COLUMNS.get(n) + " is " + word, "correct the row");
        }
      }
    }
    checkFrame();
    Pose pose = new Pose();
    pose.translation.set(values[2], values[3], values[4]);
    pose.rotation.set(values[5], values[6], values[7], values[8]);
    if (!pose.rotation.isNearUnit()) {
      throw lines.fault(
          "the quaternion qw,qx,qy,qz has the norm "
              + NumberText.text(pose.rotation.norm())
              + " instead of 1",
          "normalize it");
    }
    pose.rotation.normalize();
    poses.add(new BodyPose((long) values[0], body(CsvLines.word(words, columns[1])), pose));
  }

  private int body(String name) throws CsvFormatException {
    int body = bodies.indexOf(name);
    if (body < 0) {
      throw lines.fault("there is no body " + name, "name a segment of the volume");
    }
    return body;
  }

  private void checkFrame() throws CsvFormatException {
    double frame = values[0];
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
  }
}
