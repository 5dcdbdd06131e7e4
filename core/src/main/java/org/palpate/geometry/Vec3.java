package org.palpate.geometry;

/**
 * A mutable triple of doubles. The name of a variable states its meaning and unit: a position, a
 * force, a size. Methods that write a result take {@code dest} last and return it. One thread.
 */
public final class Vec3 {
  public double x;
  public double y;
  public double z;

  /** Creates a zero vector. */
  public Vec3() {}

  /** Creates a vector with these components. */
  public Vec3(double x, double y, double z) {
    set(x, y, z);
  }

  /** Sets all components and returns this. */
  public Vec3 set(double newX, double newY, double newZ) {
    x = newX;
    y = newY;
    z = newZ;
    return this;
  }

  /** Copies {@code other} and returns this. */
  public Vec3 set(Vec3 other) {
    return set(other.x, other.y, other.z);
  }

  /** Returns the component along {@code axis}: 0 is x, 1 is y, 2 is z. */
  public double get(int axis) {
    return axis == 0 ? x : axis == 1 ? y : z;
  }

  /** Sets the component along {@code axis}: 0 is x, 1 is y, 2 is z. */
  public void set(int axis, double value) {
    if (axis == 0) {
      x = value;
    } else if (axis == 1) {
      y = value;
    } else {
      z = value;
    }
  }

  /** Writes this minus {@code other} into {@code dest}, which may be either of them. */
  public Vec3 sub(Vec3 other, Vec3 dest) {
    return dest.set(x - other.x, y - other.y, z - other.z);
  }

  /** Writes this plus {@code other} into {@code dest}, which may be either of them. */
  public Vec3 add(Vec3 other, Vec3 dest) {
    return dest.set(x + other.x, y + other.y, z + other.z);
  }

  /** Writes this times {@code factor} into {@code dest}, which may be this. */
  public Vec3 mul(double factor, Vec3 dest) {
    return dest.set(x * factor, y * factor, z * factor);
  }

  /** Returns the dot product with {@code other}. */
  public double dot(Vec3 other) {
    return x * other.x + y * other.y + z * other.z;
  }

  /** Writes the cross product with {@code other} into {@code dest}, which may be either of them. */
  public Vec3 cross(Vec3 other, Vec3 dest) {
    return dest.set(
        y * other.z - z * other.y, z * other.x - x * other.z, x * other.y - y * other.x);
  }

  /** Returns the Euclidean length. */
  public double length() {
    return Math.sqrt(x * x + y * y + z * z);
  }

  /** Whether no component is NaN or infinite. */
  public boolean isFinite() {
    return Double.isFinite(x) && Double.isFinite(y) && Double.isFinite(z);
  }

  /**
   * Whether both have the same bits. Unlike {@code ==} it distinguishes -0.0 from 0.0, and NaN
   * equals itself.
   */
  public boolean sameBits(Vec3 other) {
    return Double.doubleToRawLongBits(x) == Double.doubleToRawLongBits(other.x)
        && Double.doubleToRawLongBits(y) == Double.doubleToRawLongBits(other.y)
        && Double.doubleToRawLongBits(z) == Double.doubleToRawLongBits(other.z);
  }

  @Override
  public String toString() {
    return "(" + x + ", " + y + ", " + z + ")";
  }
}
