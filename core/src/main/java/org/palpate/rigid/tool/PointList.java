package org.palpate.rigid.tool;

import java.util.Arrays;
import org.palpate.geometry.Vec3;

/** A growing list of sample points, mm. Belongs to one thread. */
final class PointList implements ToolShape.PointSink {
  private double[] x = new double[1024];
  private double[] y = new double[1024];
  private double[] z = new double[1024];
  private int count;

  @Override
  public void add(double px, double py, double pz) {
    if (count == x.length) {
      x = Arrays.copyOf(x, 2 * count);
      y = Arrays.copyOf(y, 2 * count);
      z = Arrays.copyOf(z, 2 * count);
    }
    x[count] = px;
    y[count] = py;
    z[count] = pz;
    count++;
  }

  /** Returns the number of points. */
  int count() {
    return count;
  }

  double x(int index) {
    return x[index];
  }

  double y(int index) {
    return y[index];
  }

  double z(int index) {
    return z[index];
  }

  /** Returns the squared distance of a point from another, mm^2. */
  double squaredDistance(int index, Vec3 p) {
    double dx = x[index] - p.x;
    double dy = y[index] - p.y;
    double dz = z[index] - p.z;
    return dx * dx + dy * dy + dz * dz;
  }

  /** Returns the coordinates x, y and z of all points relative to an origin. */
  double[][] relativeTo(Vec3 origin) {
    return new double[][] {
      minus(x, origin.x), minus(y, origin.y), minus(z, origin.z),
    };
  }

  private double[] minus(double[] values, double origin) {
    double[] result = Arrays.copyOf(values, count);
    for (int n = 0; n < count; n++) {
      result[n] -= origin;
    }
    return result;
  }
}
