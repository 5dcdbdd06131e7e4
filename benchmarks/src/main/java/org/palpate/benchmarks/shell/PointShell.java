package org.palpate.benchmarks.shell;

import org.palpate.geometry.GridMetric;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;

/**
 * The points of a tool, with their present and previous positions in the grid.
 *
 * <p>Allocates nothing after construction. {@link #place(RigidTransform, GridMetric)} is for one
 * thread; several threads may place ranges that do not overlap.
 */
public final class PointShell {
  private final double[] toolMm;
  private double[] now;
  private double[] before;

  /**
   * Creates a shell at rest at the grid's origin.
   *
   * @param toolMm x, y, z of each point in the tool's frame, millimetres; copied
   */
  public PointShell(double[] toolMm) {
    if (toolMm.length == 0 || toolMm.length % 3 != 0) {
      throw new IllegalArgumentException(
          "points must be three doubles each, one at least: doubles=" + toolMm.length);
    }
    this.toolMm = toolMm.clone();
    now = new double[toolMm.length];
    before = new double[toolMm.length];
  }

  /** Returns the number of points. */
  public int count() {
    return toolMm.length / 3;
  }

  /** Moves all points to the tool's pose; their last positions become the previous ones. */
  public void place(RigidTransform toolToGridMm, GridMetric spacing) {
    turn();
    place(toolToGridMm, spacing, 0, count());
  }

  /** Makes the present positions the previous ones; then every point must be placed once. */
  public void turn() {
    double[] old = before;
    before = now;
    now = old;
  }

  /**
   * Places a range of points by the tool's pose.
   *
   * @param toolToGridMm from the tool's frame to grid millimetres; the caller may reuse one whose
   *     vectors it changes each frame
   * @param spacing edges of a voxel, mm
   * @param from the first point
   * @param to one past the last point
   */
  public void place(RigidTransform toolToGridMm, GridMetric spacing, int from, int to) {
    Vec3 x = toolToGridMm.axisX();
    Vec3 y = toolToGridMm.axisY();
    Vec3 z = toolToGridMm.axisZ();
    Vec3 o = toolToGridMm.origin();
    for (int at = 3 * from; at < 3 * to; at += 3) {
      double a = toolMm[at];
      double b = toolMm[at + 1];
      double c = toolMm[at + 2];
      now[at] = (x.x * a + y.x * b + z.x * c + o.x) / spacing.spacingX();
      now[at + 1] = (x.y * a + y.y * b + z.y * c + o.y) / spacing.spacingY();
      now[at + 2] = (x.z * a + y.z * b + z.z * c + o.z) / spacing.spacingZ();
    }
  }

  /** Writes the present position of a point, grid coordinates, to {@code dest}. */
  public Vec3 now(int point, Vec3 dest) {
    return dest.set(now[3 * point], now[3 * point + 1], now[3 * point + 2]);
  }

  /** Writes the position of a point before the last turn, grid coordinates, to {@code dest}. */
  public Vec3 before(int point, Vec3 dest) {
    return dest.set(before[3 * point], before[3 * point + 1], before[3 * point + 2]);
  }
}
