package org.palpate.geometry;

/**
 * The metric of a voxel grid: distances in mm between points in grid coordinates.
 *
 * @param spacingX the edge of a voxel along x, mm, valid by {@link #isValidSpacing}
 * @param spacingY the edge of a voxel along y, mm, likewise
 * @param spacingZ the edge of a voxel along z, mm, likewise
 */
public record GridMetric(double spacingX, double spacingY, double spacingZ) {

  /** The shortest valid voxel edge, mm: squared distances stay far from subnormal numbers. */
  public static final double MIN_SPACING_MM = 1e-12;

  /** The longest valid voxel edge, mm: squared distances stay far from infinity. */
  public static final double MAX_SPACING_MM = 1e12;

  /**
   * Checks the spacing.
   *
   * @throws IllegalArgumentException if a spacing is not valid
   */
  public GridMetric {
    if (!isValidSpacing(spacingX) || !isValidSpacing(spacingY) || !isValidSpacing(spacingZ)) {
      throw new IllegalArgumentException(
          "spacing must be from 1e-12 to 1e12 mm: "
              + "spacingX="
              + spacingX
              + " spacingY="
              + spacingY
              + " spacingZ="
              + spacingZ);
    }
  }

  /**
   * {@return whether a voxel edge may be as long as given; false for NaN}
   *
   * @param mm the length, mm
   */
  public static boolean isValidSpacing(double mm) {
    return mm >= MIN_SPACING_MM && mm <= MAX_SPACING_MM;
  }

  /**
   * {@return the metric of a grid}
   *
   * @param spacingMm the edges of a voxel along x, y and z, mm; copied
   */
  public static GridMetric of(Vec3 spacingMm) {
    return new GridMetric(spacingMm.x, spacingMm.y, spacingMm.z);
  }

  /**
   * {@return the squared distance of two points, mm^2} Solvers decide by this formula alone whether
   * a point is strictly nearer. It has no fused multiply-add, so that the bits are the same on
   * every JDK.
   *
   * @param x0 the x component of the first point, in grid coordinates as are all others
   * @param y0 its y component
   * @param z0 its z component
   * @param x1 the x component of the second point
   * @param y1 its y component
   * @param z1 its z component
   */
  public double squaredDistance(double x0, double y0, double z0, double x1, double y1, double z1) {
    double x = (x1 - x0) * spacingX;
    double y = (y1 - y0) * spacingY;
    double z = (z1 - z0) * spacingZ;
    return x * x + y * y + z * z;
  }

  /**
   * {@return the distance of two points, mm}
   *
   * @param x0 the x component of the first point, in grid coordinates as are all others
   * @param y0 its y component
   * @param z0 its z component
   * @param x1 the x component of the second point
   * @param y1 its y component
   * @param z1 its z component
   */
  public double distance(double x0, double y0, double z0, double x1, double y1, double z1) {
    return Math.sqrt(squaredDistance(x0, y0, z0, x1, y1, z1));
  }

  /** {@return the shortest edge of a voxel, mm} */
  public double shortestEdgeMm() {
    return Math.min(spacingX, Math.min(spacingY, spacingZ));
  }
}
