package org.palpate.geometry;

/**
 * A mutable triple of doubles; what it means (position, force, size) and its unit stand in the name
 * of the variable.
 */
public final class Vec3 {
  public double x;
  public double y;
  public double z;

  public Vec3() {}

  public Vec3(double x, double y, double z) {
    set(x, y, z);
  }

  /** Sets all three. */
  public Vec3 set(double newX, double newY, double newZ) {
    x = newX;
    y = newY;
    z = newZ;
    return this;
  }

  public Vec3 set(Vec3 other) {
    return set(other.x, other.y, other.z);
  }

  /** The component along {@code axis}: 0 is x, 1 is y, 2 is z. */
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

  public double dot(Vec3 other) {
    return x * other.x + y * other.y + z * other.z;
  }

  public double length() {
    return Math.sqrt(x * x + y * y + z * z);
  }

  /** Whether no component is NaN or infinite. */
  public boolean isFinite() {
    return Double.isFinite(x) && Double.isFinite(y) && Double.isFinite(z);
  }

  /**
   * Whether both hold the same bits; unlike {@code ==} it tells -0.0 from 0.0 and finds NaN equal
   * to itself.
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
