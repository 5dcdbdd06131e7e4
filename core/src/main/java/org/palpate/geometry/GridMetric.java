package org.palpate.geometry;

/**
 * Distances in mm between points in grid coordinates: the axes weigh as their spacing says.
 *
 * @param spacingX edge of a voxel along x, mm, as {@link #isValidSpacing} allows
 * @param spacingY edge of a voxel along y, mm, likewise
 * @param spacingZ edge of a voxel along z, mm, likewise
 */
public record GridMetric(double spacingX, double spacingY, double spacingZ) {

  /** The shortest permitted voxel edge: squares of distances stay far from subnormal numbers. */
  public static final double MIN_SPACING_MM = 1e-12;

  /** The longest permitted voxel edge: squares of distances stay far from infinity. */
  public static final double MAX_SPACING_MM = 1e12;

  /** Checks the spacing. */
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

  /** Whether a voxel edge may have this length in mm; false for NaN. */
  public static boolean isValidSpacing(double mm) {
    return mm >= MIN_SPACING_MM && mm <= MAX_SPACING_MM;
  }

  /** Returns the metric of a grid with this spacing in mm. */
  public static GridMetric of(Vec3 spacingMm) {
    return new GridMetric(spacingMm.x, spacingMm.y, spacingMm.z);
  }

  /**
   * The square of the distance, mm^2. The one formula by which solvers call a point strictly
   * nearer: no fused multiply-add, same bits on every JDK.
   */
  public double squaredDistance(double x0, double y0, double z0, double x1, double y1, double z1) {
    double x = (x1 - x0) * spacingX;
    double y = (y1 - y0) * spacingY;
    double z = (z1 - z0) * spacingZ;
    return x * x + y * y + z * z;
  }

  /** The distance, mm. */
  public double distance(double x0, double y0, double z0, double x1, double y1, double z1) {
    return Math.sqrt(squaredDistance(x0, y0, z0, x1, y1, z1));
  }

  /** The shortest edge of a voxel, mm. */
  public double shortestEdgeMm() {
    return Math.min(spacingX, Math.min(spacingY, spacingZ));
  }
}
