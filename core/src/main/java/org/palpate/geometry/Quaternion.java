package org.palpate.geometry;

/**
 * A mutable Hamilton quaternion {@code w + x i + y j + z k}. A unit quaternion q turns a vector v
 * into {@code q v q*}; q and -q are the same rotation.
 *
 * <p>Methods that compute write into {@code dest}, which may be any of the inputs. Belongs to one
 * thread.
 *
 * <p>Reference: Sola, Quaternion kinematics for the error-state Kalman filter, 2017.
 */
public final class Quaternion {
  /** The norm of an orientation that was rounded differs from 1 by at most this. */
  public static final double NORM_TOLERANCE = 1e-3;

  /** Norms outside of this range and its reciprocal are rejected: their squares may be unsafe. */
  private static final double LARGEST_NORM = 1e100;

  /**
   * A norm this near to 1 is the result of a normalization, so normalizing twice changes no bit.
   */
  private static final double NORM_ROUNDING = 0x1p-50;

  /** Below this angle, rad, sin(a/2)/a is 1/2 to the last bit. */
  private static final double SMALL_ANGLE = 1e-9;

  /** The largest error of the squared norm of a unit quaternion: some thousand roundings. */
  private static final double UNIT_TOLERANCE = 1e-12;

  public double w = 1;
  public double x;
  public double y;
  public double z;

  /** Creates the identity. */
  public Quaternion() {}

  /**
   * Creates a quaternion from its four components.
   *
   * @param w the real part
   * @param x the first imaginary part
   * @param y the second
   * @param z the third
   */
  public Quaternion(double w, double x, double y, double z) {
    set(w, x, y, z);
  }

  /**
   * Sets the four components.
   *
   * @param newW the real part
   * @param newX the first imaginary part
   * @param newY the second
   * @param newZ the third
   * @return this quaternion
   */
  public Quaternion set(double newW, double newX, double newY, double newZ) {
    w = newW;
    x = newX;
    y = newY;
    z = newZ;
    return this;
  }

  /**
   * Copies the other quaternion.
   *
   * @param other the quaternion to copy
   * @return this quaternion
   */
  public Quaternion set(Quaternion other) {
    return set(other.w, other.x, other.y, other.z);
  }

  /**
   * Sets the identity.
   *
   * @return this quaternion
   */
  public Quaternion setIdentity() {
    return set(1, 0, 0, 0);
  }

  /**
   * Sets the rotation about an axis by the vector's length, rad: the exponential map.
   *
   * @param rotation the rotation vector, rad
   * @return this quaternion
   */
  public Quaternion setRotationVector(Vec3 rotation) {
    double angle = rotation.length();
    double scale = angle < SMALL_ANGLE ? 0.5 : StrictMath.sin(0.5 * angle) / angle;
    set(
        angle < SMALL_ANGLE ? 1 : StrictMath.cos(0.5 * angle),
        scale * rotation.x,
        scale * rotation.y,
        scale * rotation.z);
    return this;
  }

  /**
   * Sets the rotation that takes the coordinate axes to the given ones, with the norm 1.
   *
   * <p>Reference: Shepperd 1978, Quaternion from rotation matrix.
   *
   * @param axisX the image of the x axis; the three are orthonormal and right-handed, up to
   *     rounding
   * @param axisY the image of the y axis
   * @param axisZ the image of the z axis
   * @return this quaternion
   */
  public Quaternion setAxes(Vec3 axisX, Vec3 axisY, Vec3 axisZ) {
    double trace = axisX.x + axisY.y + axisZ.z;
    if (trace >= Math.max(axisX.x, Math.max(axisY.y, axisZ.z))) {
      set(1 + trace, axisY.z - axisZ.y, axisZ.x - axisX.z, axisX.y - axisY.x);
    } else if (axisX.x >= Math.max(axisY.y, axisZ.z)) {
      set(axisY.z - axisZ.y, 1 + 2 * axisX.x - trace, axisX.y + axisY.x, axisZ.x + axisX.z);
    } else if (axisY.y >= axisZ.z) {
      set(axisZ.x - axisX.z, axisX.y + axisY.x, 1 + 2 * axisY.y - trace, axisY.z + axisZ.y);
    } else {
      set(axisX.y - axisY.x, axisZ.x + axisX.z, axisY.z + axisZ.y, 1 + 2 * axisZ.z - trace);
    }
    normalize();
    return this;
  }

  /**
   * Writes the rotation vector, rad, of at most pi in length: the logarithm of the shorter of the
   * two ways around. This quaternion has the norm 1.
   *
   * @param dest receives the rotation vector, rad
   * @return {@code dest}
   */
  public Vec3 rotationVector(Vec3 dest) {
    double sign = w < 0 ? -1 : 1;
    double sine = Math.sqrt(x * x + y * y + z * z);
    double scale = sign * 2;
    if (sine > SMALL_ANGLE) {
      scale *= StrictMath.atan2(sine, sign * w) / sine;
    }
    return dest.set(scale * x, scale * y, scale * z);
  }

  /** {@return the angle of the rotation, rad, from 0 to pi} */
  public double angle() {
    return 2 * StrictMath.atan2(Math.sqrt(x * x + y * y + z * z), Math.abs(w));
  }

  /**
   * {@return the scalar product of the two as vectors of four components}
   *
   * @param other the second factor
   */
  public double dot(Quaternion other) {
    return w * other.w + x * other.x + y * other.y + z * other.z;
  }

  /** {@return the length as a vector of four components} */
  public double norm() {
    return Math.sqrt(dot(this));
  }

  /** {@return whether the norm is 1 up to {@link #NORM_TOLERANCE}, as that of an orientation is} */
  public boolean isNearUnit() {
    return Math.abs(norm() - 1) <= NORM_TOLERANCE;
  }

  /**
   * Scales this to the norm 1, to some units in the last place. A quaternion that has that norm
   * already keeps its bits.
   *
   * @return false if it cannot be scaled, because its norm is not from 1e-100 to 1e100 or is NaN;
   *     it is then unchanged
   */
  public boolean normalize() {
    double norm = norm();
    if (!(norm <= LARGEST_NORM && norm >= 1 / LARGEST_NORM)) {
      return false;
    }
    if (Math.abs(norm - 1) > NORM_ROUNDING) {
      set(w / norm, x / norm, y / norm, z / norm);
    }
    return true;
  }

  /** {@return whether the norm is 1 up to rounding: its square differs from 1 by at most 1e-12} */
  public boolean isUnit() {
    return Math.abs(dot(this) - 1) <= UNIT_TOLERANCE;
  }

  /**
   * Writes minus this, the same rotation.
   *
   * @param dest receives the result
   * @return {@code dest}
   */
  public Quaternion negate(Quaternion dest) {
    return dest.set(-w, -x, -y, -z);
  }

  /**
   * Writes the conjugate: for a unit quaternion, the inverse rotation.
   *
   * @param dest receives the result
   * @return {@code dest}
   */
  public Quaternion conjugate(Quaternion dest) {
    return dest.set(w, -x, -y, -z);
  }

  /**
   * Writes the product of this and another quaternion, the rotation by the other one first.
   *
   * @param other the right factor
   * @param dest receives the product
   * @return {@code dest}
   */
  public Quaternion multiply(Quaternion other, Quaternion dest) {
    return dest.set(
        w * other.w - x * other.x - y * other.y - z * other.z,
        w * other.x + x * other.w + y * other.z - z * other.y,
        w * other.y + y * other.w + z * other.x - x * other.z,
        w * other.z + z * other.w + x * other.y - y * other.x);
  }

  /**
   * Writes the rotated vector. This quaternion has the norm 1.
   *
   * @param vector the vector to rotate
   * @param dest receives the rotated vector; may be {@code vector}
   * @return {@code dest}
   */
  public Vec3 rotate(Vec3 vector, Vec3 dest) {
    double tx = 2 * (y * vector.z - z * vector.y);
    double ty = 2 * (z * vector.x - x * vector.z);
    double tz = 2 * (x * vector.y - y * vector.x);
    return dest.set(
        vector.x + w * tx + y * tz - z * ty,
        vector.y + w * ty + z * tx - x * tz,
        vector.z + w * tz + x * ty - y * tx);
  }

  /**
   * Writes the vector that this rotates into a given one. This quaternion has the norm 1.
   *
   * @param vector the rotated vector
   * @param dest receives the vector before the rotation; may be {@code vector}
   * @return {@code dest}
   */
  public Vec3 inverseRotate(Vec3 vector, Vec3 dest) {
    double tx = 2 * (z * vector.y - y * vector.z);
    double ty = 2 * (x * vector.z - z * vector.x);
    double tz = 2 * (y * vector.x - x * vector.y);
    return dest.set(
        vector.x + w * tx - y * tz + z * ty,
        vector.y + w * ty - z * tx + x * tz,
        vector.z + w * tz - x * ty + y * tx);
  }

  /** {@return whether no component is NaN or infinite} */
  public boolean isFinite() {
    return Double.isFinite(w) && Double.isFinite(x) && Double.isFinite(y) && Double.isFinite(z);
  }

  /**
   * {@return whether both hold the same bits}
   *
   * @param other the quaternion to compare with
   */
  public boolean sameBits(Quaternion other) {
    return Double.doubleToRawLongBits(w) == Double.doubleToRawLongBits(other.w)
        && Double.doubleToRawLongBits(x) == Double.doubleToRawLongBits(other.x)
        && Double.doubleToRawLongBits(y) == Double.doubleToRawLongBits(other.y)
        && Double.doubleToRawLongBits(z) == Double.doubleToRawLongBits(other.z);
  }

  @Override
  public String toString() {
    return "(" + w + "; " + x + ", " + y + ", " + z + ")";
  }
}
