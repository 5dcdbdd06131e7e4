package org.palpate.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;
import org.palpate.raycast.Ray;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.testing.FilteredOracle;
import org.palpate.volume.SegmentedVolume;

/**
 * Judges the files LEGS.csv and FRAMES.csv of a rigid tool. No leg touches a voxel, in exact
 * arithmetic. Each leg starts bit for bit where the last one of its point ended. After each frame
 * every point is where the tool pose puts it, within 1e-9 voxel.
 */
final class ToolLegsFile {
  private static final double TOLERANCE_VOXELS = 1e-9;

  private final SegmentedVolume volume;
  private final List<Pose> poses;
  private final RigidTool tool;
  private final int every;
  private final FilteredOracle oracle = new FilteredOracle();
  private final Ray ray = new Ray();
  private final double[][][] last;
  private final Quaternion q = new Quaternion();
  private final Vec3 p = new Vec3();
  private double[] row;
  private long legs;
  private long releases;

  ToolLegsFile(SegmentedVolume volume, RigidTool tool, int every) {
    this(volume, Collections.nCopies(volume.segments().size(), new Pose()), tool, every);
  }

  /**
   * Creates a judge of legs among bodies that stand still.
   *
   * @param poses the pose of each body, from rest to present, world mm
   */
  ToolLegsFile(SegmentedVolume volume, List<Pose> poses, RigidTool tool, int every) {
    this.volume = volume;
    this.poses = poses;
    this.tool = tool;
    this.every = every;
    last = new double[volume.segments().size()][tool.count()][];
  }

  long legs() {
    return legs;
  }

  long releases() {
    return releases;
  }

  /** Judges all rows. */
  void judge(Path framesFile, Path legsFile) throws IOException {
    try (BufferedReader frames = Files.newBufferedReader(framesFile);
        BufferedReader rows = Files.newBufferedReader(legsFile)) {
      assertEquals(
          "frame,t_ms,dx,dy,dz,px,py,pz,fx,fy,fz,contact,path"
              + ",dqw,dqx,dqy,dqz,pqw,pqx,pqy,pqz,tx,ty,tz",
          frames.readLine());
      assertEquals("frame,leg,body,point,x0,y0,z0,x1,y1,z1", rows.readLine());
      next(rows);
      int count = 0;
      for (String line = frames.readLine(); line != null; line = frames.readLine()) {
        judgeFrame(numbers(line), rows, count++);
      }
      assertTrue(row == null, "a row after the last frame");
    }
  }

  private void judgeFrame(double[] frame, BufferedReader rows, int number) throws IOException {
    assertEquals(number, (int) frame[0]);
    int[][] legsOfFrame = new int[last.length][tool.count()];
    while (row != null && row[0] == number) {
      judgeRow(legsOfFrame[(int) row[2]], "frame " + number + " " + Arrays.toString(row));
      next(rows);
    }
    q.set(frame[17], frame[18], frame[19], frame[20]);
    for (int body = 0; body < last.length; body++) {
      for (int point = 0; point < tool.count(); point += every) {
        position(frame, body, point);
        double[] at = last[body][point];
        last[body][point] = at == null ? new double[] {p.x, p.y, p.z, Double.NaN} : at;
        String where = "frame " + number + " body " + body + " point " + point;
        assertNear(last[body][point], p.x, p.y, p.z, where);
      }
    }
  }

  private void position(double[] frame, int body, int point) {
    q.rotate(tool.point(point, p), p);
    p.set(p.x + frame[5], p.y + frame[6], p.z + frame[7]);
    volume.grid(body).worldToGrid(poses.get(body).inverseTransform(p, p), p);
  }

  private static void assertNear(double[] at, double x, double y, double z, String where) {
    double off = Math.max(Math.abs(at[0] - x), Math.max(Math.abs(at[1] - y), Math.abs(at[2] - z)));
    assertTrue(off <= TOLERANCE_VOXELS, () -> where + " is off by " + off);
  }

  private void judgeRow(int[] legsOfFrame, String where) {
    int body = (int) row[2];
    int point = (int) row[3];
    assertEquals(0, point % every, where);
    ray.from(row[4], row[5], row[6]).to(row[7], row[8], row[9]);
    assertFalse(oracle.touchesAny(volume.segments().get(body).bits(), ray), where);
    boolean moves = row[4] != row[7] || row[5] != row[8] || row[6] != row[9];
    if (row[1] == -1) {
      assertFalse(moves, where);
      assertEquals(0, legsOfFrame[point], where);
      releases++;
    } else {
      legs++;
      assertTrue(moves, where);
      assertEquals(legsOfFrame[point]++, (int) row[1], where);
      judgeStart(last[body][point], where);
    }
    last[body][point] = new double[] {row[7], row[8], row[9]};
  }

  private void judgeStart(double[] end, String where) {
    if (end == null || end.length == 4) { // the first place of a chain is in no row
      if (end != null) {
        assertNear(end, row[4], row[5], row[6], where);
      }
      return;
    }
    assertTrue(row[4] == end[0] && row[5] == end[1] && row[6] == end[2], () -> where + " breaks");
  }

  private void next(BufferedReader rows) throws IOException {
    String line = rows.readLine();
    row = line == null ? null : numbers(line);
  }

  static double[] numbers(String line) {
    return Arrays.stream(line.split(",")).mapToDouble(Double::parseDouble).toArray();
  }
}
