package org.palpate.io.table;

import java.io.IOException;
import java.io.OutputStream;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;

/**
 * Writes a table with a row for each frame of a rigid tool: the columns of a point, then both
 * orientations and the torque. For one thread.
 */
public final class ToolFramesCsvWriter {
  private static final String HEADER =
      FramesCsvWriter.HEADER + ",dqw,dqx,dqy,dqz,pqw,pqx,pqy,pqz,tx,ty,tz";

  private final CsvWriter rows;

  /** Writes the header into a stream that the caller closes. */
  public ToolFramesCsvWriter(OutputStream stream) throws IOException {
    rows = new CsvWriter(stream, HEADER);
  }

  /**
   * Adds a row.
   *
   * @param frame from 0
   * @param device the device pose, as the trajectory gives it, world mm
   * @param tool the tool pose, world mm
   * @param forceNewton the force on the hand, world axes
   * @param torqueNewtonMm the torque on the hand about the reference point, world axes
   * @param pathMm the longest path of a point in this frame
   */
  public void add(
      long frame,
      double timeMs,
      Pose device,
      Pose tool,
      Vec3 forceNewton,
      Vec3 torqueNewtonMm,
      boolean contact,
      double pathMm)
      throws IOException {
    rows.cell(frame).cell(timeMs);
    cells(device.translation);
    cells(tool.translation);
    cells(forceNewton);
    rows.cell(contact ? 1 : 0).cell(pathMm);
    cells(device.rotation);
    cells(tool.rotation);
    cells(torqueNewtonMm);
    rows.end();
  }

  private void cells(Vec3 v) {
    rows.cell(v.x).cell(v.y).cell(v.z);
  }

  private void cells(Quaternion q) {
    rows.cell(q.w).cell(q.x).cell(q.y).cell(q.z);
  }
}
