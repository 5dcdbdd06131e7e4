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

  /**
   * Creates a vector.
   *
   * @param x the component along x
   * @param y the component along y
   * @param z the component along z
   */
  public Vec3(double x, double y, double z) {
    set(x, y, z);
  }

  /**
   * Sets all components.
   *
   * @param newX the component along x
   * @param newY the component along y
   * @param newZ the component along z
   * @return this vector
   */
  public Vec3 set(double newX, double newY, double newZ) {
    x = newX;
    y = newY;
    z = newZ;
    return this;
  }

  /**
   * Copies another vector.
   *
   * @param other the vector to copy
   * @return this vector
   */
  public Vec3 set(Vec3 other) {
    return set(other.x, other.y, other.z);
  }

  /**
   * {@return the component along an axis}
   *
   * @param axis 0 for x, 1 for y, 2 for z
   */
  public double get(int axis) {
    return axis == 0 ? x : axis == 1 ? y : z;
  }

  /**
   * Sets the component along an axis.
   *
   * @param axis 0 for x, 1 for y, 2 for z
   * @param value the new component
   */
  public void set(int axis, double value) {
    if (axis == 0) {
      x = value;
    } else if (axis == 1) {
      y = value;
    } else {
      z = value;
    }
  }

  /**
   * Writes this minus another vector.
   *
   * @param other the vector to subtract
   * @param dest receives the difference; may be either of them
   * @return {@code dest}
   */
  public Vec3 sub(Vec3 other, Vec3 dest) {
    return dest.set(x - other.x, y - other.y, z - other.z);
  }

  /**
   * Writes this plus another vector.
   *
   * @param other the vector to add
   * @param dest receives the sum; may be either of them
   * @return {@code dest}
   */
  public Vec3 add(Vec3 other, Vec3 dest) {
    return dest.set(x + other.x, y + other.y, z + other.z);
  }

  /**
   * Writes a multiple of this vector.
   *
   * @param factor the factor of each component
   * @param dest receives the product; may be this
   * @return {@code dest}
   */
  public Vec3 mul(double factor, Vec3 dest) {
    return dest.set(x * factor, y * factor, z * factor);
  }

  /**
   * {@return the dot product with another vector}
   *
   * @param other the second factor
   */
  public double dot(Vec3 other) {
    return x * other.x + y * other.y + z * other.z;
  }

  /**
   * Writes the cross product of this and another vector.
   *
   * @param other the right factor
   * @param dest receives the product; may be either of them
   * @return {@code dest}
   */
  public Vec3 cross(Vec3 other, Vec3 dest) {
    return dest.set(
        y * other.z - z * other.y, z * other.x - x * other.z, x * other.y - y * other.x);
  }

  /** {@return the Euclidean length} */
  public double length() {
    return Math.sqrt(x * x + y * y + z * z);
  }

  /** {@return whether no component is NaN or infinite} */
  public boolean isFinite() {
    return Double.isFinite(x) && Double.isFinite(y) && Double.isFinite(z);
  }

  /**
   * {@return whether both have the same bits} Unlike {@code ==} it distinguishes -0.0 from 0.0, and
   * NaN equals itself.
   *
   * @param other the vector to compare with
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
