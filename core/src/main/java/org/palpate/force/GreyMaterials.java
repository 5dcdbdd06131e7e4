package org.palpate.force;

import java.util.List;
import java.util.function.ToDoubleFunction;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.volume.ScalarVolume;
import org.palpate.volume.VoxelGrid;

/**
 * Materials that follow from grey values: stiffness, friction and damping as functions of the value
 * under the contact. Between the rows of a table they are interpolated linearly, and beyond its
 * ends they stay.
 *
 * <p>Nobody changes the values while frames run. Immutable; any thread.
 */
public final class GreyMaterials {
  /**
   * Materials for Hounsfield units: fat near -100, muscle near 50, cancellous bone from 300 and
   * cortical bone from 700 on (Buzug, Computed Tomography, 2008). That bone grows stiffer with the
   * CT number follows Rho, Hobatho and Ashman 1995. True stiffnesses differ by far more than a hand
   * can feel; these factors keep their order.
   */
  public static final List<Row> CT =
      List.of(
          new Row(-200, 0.1, 0.1, 0.0004),
          new Row(-100, 0.15, 0.1, 0.0004),
          new Row(50, 0.3, 0.15, 0.0004),
          new Row(300, 0.6, 0.2, 0.0002),
          new Row(700, 1, 0.2, 0));

  private final ScalarVolume values;
  private final List<Row> rows;

  /**
   * The material at a grey value.
   *
   * @param grey the value
   * @param stiffness the stiffness over that of contact, at least 0
   * @param friction the friction coefficient, at least 0
   * @param dampingNewtonSecondPerMm the damping, at least 0
   */
  public record Row(
      double grey, double stiffness, double friction, double dampingNewtonSecondPerMm) {}

  /**
   * Creates materials.
   *
   * @param values the grey values under the contact; kept
   * @param rows at least one, with values that rise
   * @throws IllegalArgumentException if there is no row or the values do not rise
   */
  public GreyMaterials(ScalarVolume values, List<Row> rows) {
    this.values = values;
    this.rows = List.copyOf(rows);
    for (int n = 1; n < rows.size(); n++) {
      if (!(rows.get(n).grey() > rows.get(n - 1).grey())) {
        throw new IllegalArgumentException(
            "grey values must rise: " + rows.get(n - 1).grey() + ", " + rows.get(n).grey());
      }
    }
    if (rows.isEmpty()) {
      throw new IllegalArgumentException("there must be a row");
    }
  }

  /** {@return the grid of the values} */
  public VoxelGrid grid() {
    return values.grid();
  }

  /** {@return the largest stiffness over that of contact} */
  public double stiffest() {
    double most = 0;
    for (int n = 0; n < rows.size(); n++) {
      most = Math.max(most, rows.get(n).stiffness());
    }
    return most;
  }

  /** Whether any material has damping. */
  boolean damps() {
    boolean damps = false;
    for (int n = 0; n < rows.size(); n++) {
      damps |= rows.get(n).dampingNewtonSecondPerMm() > 0;
    }
    return damps;
  }

  /** Returns the value at a position in grid coordinates, interpolated between voxels. */
  double greyAt(Vec3 gridPosition) {
    return values.interpolated(gridPosition.x, gridPosition.y, gridPosition.z);
  }

  /**
   * Returns the value under a point: an edge of a voxel below the surface, towards the device, but
   * not beyond it.
   *
   * @param device the position that the solver followed, grid coordinates
   */
  double greyUnder(InteractionPoint point, Vec3 device, GridMetric metric) {
    Vec3 p = point.position;
    double distanceMm = metric.distance(p.x, p.y, p.z, device.x, device.y, device.z);
    double reachMm = Math.max(0, point.surfaceHeightMm) + metric.shortestEdgeMm();
    double fraction = distanceMm > reachMm ? reachMm / distanceMm : 1;
    return values.interpolated(
        p.x + fraction * (device.x - p.x),
        p.y + fraction * (device.y - p.y),
        p.z + fraction * (device.z - p.z));
  }

  /** Returns the index of the last row that begins at or below a value; 0 below all. */
  private int rowOf(double grey) {
    int row = 0;
    while (row + 1 < rows.size() && rows.get(row + 1).grey() <= grey) {
      row++;
    }
    return row;
  }

  /** Returns a figure of the rows at a grey value. */
  private double interpolated(double grey, ToDoubleFunction<Row> figure) {
    int index = rowOf(grey);
    Row row = rows.get(index);
    double from = figure.applyAsDouble(row);
    if (index + 1 == rows.size() || grey <= row.grey()) {
      return from;
    }
    Row next = rows.get(index + 1);
    double fraction = (grey - row.grey()) / (next.grey() - row.grey());
    return from + fraction * (figure.applyAsDouble(next) - from);
  }

  /** Returns the stiffness over that of contact at a grey value. */
  double stiffness(double grey) {
    return interpolated(grey, Row::stiffness);
  }

  /** Returns the friction coefficient at a grey value. */
  double friction(double grey) {
    return interpolated(grey, Row::friction);
  }

  /** Returns the damping at a grey value, N s/mm. */
  double damping(double grey) {
    return interpolated(grey, Row::dampingNewtonSecondPerMm);
  }
}
