package org.palpate.scene;

import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;

/** A 4x4 matrix, column-major as in OpenGL. Immutable. */
public final class Matrix4 {
  private final double[] m;

  private Matrix4(double... columns) {
    m = columns;
  }

  /** Returns the matrix of a pose. */
  public static Matrix4 of(RigidTransform pose) {
    Vec3 x = pose.axisX();
    Vec3 y = pose.axisY();
    Vec3 z = pose.axisZ();
    Vec3 o = pose.origin();
    return new Matrix4(x.x, x.y, x.z, 0, y.x, y.y, y.z, 0, z.x, z.y, z.z, 0, o.x, o.y, o.z, 1);
  }

  /** Returns the view matrix of a camera at {@code eye} with unit axes; it looks along -back. */
  static Matrix4 view(Vec3 right, Vec3 up, Vec3 back, Vec3 eye) {
    return new Matrix4(
        right.x,
        up.x,
        back.x,
        0,
        right.y,
        up.y,
        back.y,
        0,
        right.z,
        up.z,
        back.z,
        0,
        -right.dot(eye),
        -up.dot(eye),
        -back.dot(eye),
        1);
  }

  /**
   * Returns a perspective projection.
   *
   * @param heightPerDistance visible height over distance, twice the tangent of half the angle
   * @param aspect width over height
   * @param shift sideways shift of the near plane for a stereo eye
   */
  static Matrix4 perspective(
      double heightPerDistance, double aspect, double near, double far, double shift) {
    double yScale = 2 / heightPerDistance;
    double depth = (near + far) / (near - far);
    return new Matrix4(
        yScale / aspect,
        0,
        0,
        0,
        0,
        yScale,
        0,
        0,
        shift,
        0,
        depth,
        -1,
        0,
        0,
        2 * near * far / (near - far),
        0);
  }

  /**
   * Returns this projection, after which a part of the picture fills the whole of it.
   *
   * @param x the middle of the part, -1 at the left edge of the picture, 1 at the right edge
   * @param y the same from the lower to the upper edge
   * @param width the width of the picture in widths of the part
   * @param height its height in heights of the part
   */
  public Matrix4 zoomed(double x, double y, double width, double height) {
    Matrix4 zoom =
        new Matrix4(width, 0, 0, 0, 0, height, 0, 0, 0, 0, 1, 0, -x * width, -y * height, 0, 1);
    return zoom.times(this);
  }

  /** Returns the product of this and {@code first}, which is applied first. */
  public Matrix4 times(Matrix4 first) {
    double[] product = new double[16];
    for (int column = 0; column < 4; column++) {
      for (int row = 0; row < 4; row++) {
        double sum = 0;
        for (int i = 0; i < 4; i++) {
          sum += m[4 * i + row] * first.m[4 * column + i];
        }
        product[4 * column + row] = sum;
      }
    }
    return new Matrix4(product);
  }

  /**
   * Projects a point and divides by w.
   *
   * @return w, which is not positive for a point behind the eye
   */
  public double project(Vec3 point, Vec3 dest) {
    double w = row(3, point);
    dest.set(row(0, point) / w, row(1, point) / w, row(2, point) / w);
    return w;
  }

  private double row(int row, Vec3 p) {
    return m[row] * p.x + m[4 + row] * p.y + m[8 + row] * p.z + m[12 + row];
  }

  /** Returns one element; the planes of the view frustum are made from rows. */
  public double at(int row, int column) {
    return m[4 * column + row];
  }

  /** Returns the elements as OpenGL takes them. */
  public float[] toFloats() {
    float[] floats = new float[16];
    for (int i = 0; i < 16; i++) {
      floats[i] = (float) m[i];
    }
    return floats;
  }
}
