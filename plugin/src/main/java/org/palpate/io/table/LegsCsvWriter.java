package org.palpate.io.table;

import java.io.IOException;
import java.io.OutputStream;
import org.palpate.geometry.Vec3;

/** Writes a table with a row for each leg of the interaction point, in order. For one thread. */
public final class LegsCsvWriter {
  /** The number of a leg at which the interaction point is set free and a new chain begins. */
  private static final int RELEASED = -1;

  private static final String HEADER = "frame,leg,x0,y0,z0,x1,y1,z1";

  private final CsvWriter rows;

  /** Writes the header into a stream that the caller closes. */
  public LegsCsvWriter(OutputStream stream) throws IOException {
    rows = new CsvWriter(stream, HEADER);
  }

  /** Adds a leg of a frame, both counted from 0, in grid coordinates. */
  public void add(
      long frame, int leg, double x0, double y0, double z0, double x1, double y1, double z1)
      throws IOException {
    rows.cell(frame).cell(leg).cell(x0).cell(y0).cell(z0).cell(x1).cell(y1).cell(z1).end();
  }

  /** Adds a release of the interaction point at {@code position}, in grid coordinates. */
  public void addRelease(long frame, Vec3 position) throws IOException {
    add(frame, RELEASED, position.x, position.y, position.z, position.x, position.y, position.z);
  }
}
