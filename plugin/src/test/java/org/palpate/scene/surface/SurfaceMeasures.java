package org.palpate.scene.surface;

/** Measures closed surfaces for tests. */
final class SurfaceMeasures {
  private final float[] positionsMm;
  private final int[] triangles;

  private SurfaceMeasures(WeldedSurface surface) {
    positionsMm = surface.positionsMm();
    triangles = surface.triangles();
  }

  static SurfaceMeasures of(WeldedSurface surface) {
    return new SurfaceMeasures(surface);
  }

  /** Returns the enclosed volume, cubic millimetres. */
  double volumeMm3() {
    double sum = 0;
    for (int t = 0; t < triangles.length; t += 3) {
      double ax = x(t);
      double ay = y(t);
      double az = z(t);
      double cx = y(t + 1) * z(t + 2) - z(t + 1) * y(t + 2);
      double cy = z(t + 1) * x(t + 2) - x(t + 1) * z(t + 2);
      double cz = x(t + 1) * y(t + 2) - y(t + 1) * x(t + 2);
      sum += ax * cx + ay * cy + az * cz;
    }
    return sum / 6;
  }

  /** Returns the area, square millimetres. */
  double areaMm2() {
    double sum = 0;
    for (int t = 0; t < triangles.length; t += 3) {
      double ux = x(t + 1) - x(t);
      double uy = y(t + 1) - y(t);
      double uz = z(t + 1) - z(t);
      double vx = x(t + 2) - x(t);
      double vy = y(t + 2) - y(t);
      double vz = z(t + 2) - z(t);
      double cx = uy * vz - uz * vy;
      double cy = uz * vx - ux * vz;
      double cz = ux * vy - uy * vx;
      sum += Math.sqrt(cx * cx + cy * cy + cz * cz);
    }
    return sum / 2;
  }

  /** Returns x of a triangle corner, counted over all triangles. */
  double x(int corner) {
    return positionsMm[3 * triangles[corner]];
  }

  double y(int corner) {
    return positionsMm[3 * triangles[corner] + 1];
  }

  double z(int corner) {
    return positionsMm[3 * triangles[corner] + 2];
  }
}
