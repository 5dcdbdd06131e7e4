package org.palpate.io.table;

import java.io.IOException;
import java.io.OutputStream;
import org.palpate.geometry.Vec3;

/** Writes a table with a row for each leg of each point of a tool and each body. One thread. */
public final class ToolLegsCsvWriter {
  private static final String HEADER = "frame,leg,body,point,x0,y0,z0,x1,y1,z1";

  private final CsvWriter rows;

  /** Writes the header into a stream that the caller closes. */
  public ToolLegsCsvWriter(OutputStream stream) throws IOException {
    rows = new CsvWriter(stream, HEADER);
  }

  /**
   * Adds a leg.
   *
   * @param frame from 0
   * @param leg from 0 for each frame, body and point; -1 where the tool was set free
   * @param start grid coordinates of the body
   * @param end grid coordinates of the body
   */
  public void add(long frame, int leg, int body, int point, Vec3 start, Vec3 end)
      throws IOException {
    rows.cell(frame).cell(leg).cell(body).cell(point);
    rows.cell(start.x).cell(start.y).cell(start.z).cell(end.x).cell(end.y).cell(end.z).end();
  }
}
