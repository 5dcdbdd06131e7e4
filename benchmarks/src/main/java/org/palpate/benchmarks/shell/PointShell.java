package org.palpate.benchmarks.shell;

import org.palpate.geometry.GridMetric;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;

/**
 * The points of a tool, and where they are in the grid now and were before.
 *
 * <p>Allocates nothing after construction. {@link #place(RigidTransform, GridMetric)} is for one
 * thread; several may place ranges that do not overlap.
 */
public final class PointShell {
  private final double[] toolMm;
  private double[] now;
  private double[] before;

  /**
   * A shell at rest at the grid's origin.
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

  /** The number of points. */
  public int count() {
    return toolMm.length / 3;
  }

  /** Puts all points where the tool is; where they were stays known as before. */
  public void place(RigidTransform toolToGridMm, GridMetric spacing) {
    turn();
    place(toolToGridMm, spacing, 0, count());
  }

  /** Makes now before; then every point is to be placed once. */
  public void turn() {
    double[] old = before;
    before = now;
    now = old;
  }

  /**
   * Puts a range of points where the tool is.
   *
   * @param toolToGridMm from the tool's frame to grid millimetres; the caller may use one whose
   *     vectors it sets anew each frame
   * @param spacing edges of a voxel, mm
   * @param from the first point
   * @param to one past the last
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

  /** Writes where a point is, grid coordinates. */
  public Vec3 now(int point, Vec3 dest) {
    return dest.set(now[3 * point], now[3 * point + 1], now[3 * point + 2]);
  }

  /** Writes where a point was before the last turn, grid coordinates. */
  public Vec3 before(int point, Vec3 dest) {
    return dest.set(before[3 * point], before[3 * point + 1], before[3 * point + 2]);
  }
}
