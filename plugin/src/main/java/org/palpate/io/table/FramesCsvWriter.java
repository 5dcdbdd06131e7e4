package org.palpate.io.table;

import java.io.IOException;
import java.io.OutputStream;
import org.palpate.geometry.Vec3;

/**
 * Writes a table with a row for each frame: device, interaction point, force, contact and path. For
 * one thread.
 */
public final class FramesCsvWriter {
  static final String HEADER = "frame,t_ms,dx,dy,dz,px,py,pz,fx,fy,fz,contact,path";

  private final CsvWriter rows;

  /** Writes the header into a stream that the caller closes. */
  public FramesCsvWriter(OutputStream stream) throws IOException {
    rows = new CsvWriter(stream, HEADER);
  }

  /**
   * Adds a row.
   *
   * @param frame from 0
   * @param device the device position in the trajectory's coordinates
   * @param point the interaction point in the trajectory's coordinates
   * @param forceNewton the force on the hand, along the same axes
   * @param pathMm path of the interaction point in this frame
   */
  public void add(
      long frame,
      double timeMs,
      Vec3 device,
      Vec3 point,
      Vec3 forceNewton,
      boolean contact,
      double pathMm)
      throws IOException {
    rows.cell(frame).cell(timeMs);
    cells(device);
    cells(point);
    cells(forceNewton);
    rows.cell(contact ? 1 : 0).cell(pathMm).end();
  }

  private void cells(Vec3 v) {
    rows.cell(v.x).cell(v.y).cell(v.z);
  }
}
