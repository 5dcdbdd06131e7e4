package org.palpate.geometry;

/**
 * A mutable affine map of points: a matrix of 3x3 and an offset. Its three components are the one
 * formula by which the points of a tool get their grid coordinates, with the same bits on every
 * JDK: products and sums in the order in which they are written, no fused multiply-add.
 *
 * <p>Names are row and column: {@code y = mYX x + mYY y + mYZ z + offsetY}. Belongs to one thread.
 */
public final class AffineMap {
  public double mXX = 1;
  public double mXY;
  public double mXZ;
  public double mYX;
  public double mYY = 1;
  public double mYZ;
  public double mZX;
  public double mZY;
  public double mZZ = 1;
  public double offsetX;
  public double offsetY;
  public double offsetZ;

  /**
   * {@return the image's x component}
   *
   * @param px the x component of the point, in the frame that the map leads from
   * @param py its y component
   * @param pz its z component
   */
  public double x(double px, double py, double pz) {
    return mXX * px + mXY * py + mXZ * pz + offsetX;
  }

  /**
   * {@return the image's y component}
   *
   * @param px the x component of the point, in the frame that the map leads from
   * @param py its y component
   * @param pz its z component
   */
  public double y(double px, double py, double pz) {
    return mYX * px + mYY * py + mYZ * pz + offsetY;
  }

  /**
   * {@return the image's z component}
   *
   * @param px the x component of the point, in the frame that the map leads from
   * @param py its y component
   * @param pz its z component
   */
  public double z(double px, double py, double pz) {
    return mZX * px + mZY * py + mZZ * pz + offsetZ;
  }

  /**
   * Writes the image of a point.
   *
   * @param p the point, in the frame that the map leads from
   * @param dest receives the image; may be {@code p}
   * @return {@code dest}
   */
  public Vec3 transform(Vec3 p, Vec3 dest) {
    return dest.set(x(p.x, p.y, p.z), y(p.x, p.y, p.z), z(p.x, p.y, p.z));
  }

  /**
   * Writes the image of a direction, without the offset.
   *
   * @param v the direction, in the frame that the map leads from
   * @param dest receives the image, not normalized; may be {@code v}
   * @return {@code dest}
   */
  public Vec3 transformDirection(Vec3 v, Vec3 dest) {
    return dest.set(
        mXX * v.x + mXY * v.y + mXZ * v.z,
        mYX * v.x + mYY * v.y + mYZ * v.z,
        mZX * v.x + mZY * v.y + mZZ * v.z);
  }

  /**
   * Copies the other map.
   *
   * @param o the map to copy
   * @return this map
   */
  public AffineMap set(AffineMap o) {
    setFirstRows(o.mXX, o.mXY, o.mXZ, o.mYX, o.mYY, o.mYZ);
    return setLastRowAndOffset(o.mZX, o.mZY, o.mZZ, o.offsetX, o.offsetY, o.offsetZ);
  }

  private void setFirstRows(double xx, double xy, double xz, double yx, double yy, double yz) {
    mXX = xx;
    mXY = xy;
    mXZ = xz;
    mYX = yx;
    mYY = yy;
    mYZ = yz;
  }

  private AffineMap setLastRowAndOffset(
      double zx, double zy, double zz, double ox, double oy, double oz) {
    mZX = zx;
    mZY = zy;
    mZZ = zz;
    offsetX = ox;
    offsetY = oy;
    offsetZ = oz;
    return this;
  }

  /**
   * Sets the map of a pose: rotation, then translation.
   *
   * @param pose the pose, with a unit quaternion; it is copied
   * @return this map
   */
  public AffineMap set(Pose pose) {
    double w = pose.rotation.w;
    double x = pose.rotation.x;
    double y = pose.rotation.y;
    double z = pose.rotation.z;
    setFirstRows(
        1 - 2 * (y * y + z * z),
        2 * (x * y - w * z),
        2 * (x * z + w * y),
        2 * (x * y + w * z),
        1 - 2 * (x * x + z * z),
        2 * (y * z - w * x));
    return setLastRowAndOffset(
        2 * (x * z - w * y),
        2 * (y * z + w * x),
        1 - 2 * (x * x + y * y),
        pose.translation.x,
        pose.translation.y,
        pose.translation.z);
  }

  /**
   * Sets the inverse map of a pose.
   *
   * @param pose the pose, with a unit quaternion; it is copied
   * @return this map, which leads from the frame of the pose's images back to the object's own
   */
  public AffineMap setInverse(Pose pose) {
    set(pose);
    double rowXLast = mXZ;
    double rowYLast = mYZ;
    double tx = offsetX;
    double ty = offsetY;
    double tz = offsetZ;
    setFirstRows(mXX, mYX, mZX, mXY, mYY, mZY);
    return setLastRowAndOffset(
        rowXLast,
        rowYLast,
        mZZ,
        -(mXX * tx + mXY * ty + mXZ * tz),
        -(mYX * tx + mYY * ty + mYZ * tz),
        -(rowXLast * tx + rowYLast * ty + mZZ * tz));
  }

  /**
   * Sets the map from the world to the coordinates of a grid.
   *
   * @param gridMmToWorld from the grid's frame in mm to the world, orthonormal
   * @param spacingMm the edges of a voxel, mm
   * @return this map
   */
  public AffineMap setInverseGrid(RigidTransform gridMmToWorld, Vec3 spacingMm) {
    Vec3 x = gridMmToWorld.axisX();
    Vec3 y = gridMmToWorld.axisY();
    Vec3 z = gridMmToWorld.axisZ();
    Vec3 s = spacingMm;
    setFirstRows(x.x / s.x, x.y / s.x, x.z / s.x, y.x / s.y, y.y / s.y, y.z / s.y);
    setLastRowAndOffset(z.x / s.z, z.y / s.z, z.z / s.z, 0, 0, 0);
    Vec3 origin = transformDirection(gridMmToWorld.origin(), new Vec3());
    return setLastRowAndOffset(mZX, mZY, mZZ, -origin.x, -origin.y, -origin.z);
  }

  /**
   * Sets the map from a grid's frame in mm to the world.
   *
   * @param t from the grid's frame in mm to the world; it is copied
   * @return this map
   */
  public AffineMap set(RigidTransform t) {
    setFirstRows(t.axisX().x, t.axisY().x, t.axisZ().x, t.axisX().y, t.axisY().y, t.axisZ().y);
    return setLastRowAndOffset(
        t.axisX().z, t.axisY().z, t.axisZ().z, t.origin().x, t.origin().y, t.origin().z);
  }

  /**
   * Writes the map that applies another one and then this.
   *
   * @param first the map that is applied first
   * @param dest receives the product; neither this map nor {@code first}
   * @return {@code dest}
   */
  public AffineMap multiply(AffineMap first, AffineMap dest) {
    dest.setFirstRows(
        mXX * first.mXX + mXY * first.mYX + mXZ * first.mZX,
        mXX * first.mXY + mXY * first.mYY + mXZ * first.mZY,
        mXX * first.mXZ + mXY * first.mYZ + mXZ * first.mZZ,
        mYX * first.mXX + mYY * first.mYX + mYZ * first.mZX,
        mYX * first.mXY + mYY * first.mYY + mYZ * first.mZY,
        mYX * first.mXZ + mYY * first.mYZ + mYZ * first.mZZ);
    return dest.setLastRowAndOffset(
        mZX * first.mXX + mZY * first.mYX + mZZ * first.mZX,
        mZX * first.mXY + mZY * first.mYY + mZZ * first.mZY,
        mZX * first.mXZ + mZY * first.mYZ + mZZ * first.mZZ,
        x(first.offsetX, first.offsetY, first.offsetZ),
        y(first.offsetX, first.offsetY, first.offsetZ),
        z(first.offsetX, first.offsetY, first.offsetZ));
  }

  /**
   * {@return the largest distance along an axis between the images of any point under this map and
   * another} It is rounded up, apart from the rounding of the maps themselves.
   *
   * @param b the other map, from and to the same frames as this
   * @param radius the largest distance of a point from the origin
   */
  public double longestMotionTo(AffineMap b, double radius) {
    double alongX = motion(b.mXX - mXX, b.mXY - mXY, b.mXZ - mXZ, b.offsetX - offsetX, radius);
    double alongY = motion(b.mYX - mYX, b.mYY - mYY, b.mYZ - mYZ, b.offsetY - offsetY, radius);
    double alongZ = motion(b.mZX - mZX, b.mZY - mZY, b.mZZ - mZZ, b.offsetZ - offsetZ, radius);
    return Math.max(alongX, Math.max(alongY, alongZ));
  }

  private static double motion(
      double rowX, double rowY, double rowZ, double offset, double radius) {
    double turned = Math.sqrt(rowX * rowX + rowY * rowY + rowZ * rowZ) * radius;
    return (Math.abs(offset) + turned) * (1 + 1e-12);
  }

  /**
   * {@return whether another map has the same bits, so that it gives the same images}
   *
   * @param o the other map
   */
  public boolean sameBits(AffineMap o) {
    return sameRow(mXX, mXY, mXZ, offsetX, o.mXX, o.mXY, o.mXZ, o.offsetX)
        && sameRow(mYX, mYY, mYZ, offsetY, o.mYX, o.mYY, o.mYZ, o.offsetY)
        && sameRow(mZX, mZY, mZZ, offsetZ, o.mZX, o.mZY, o.mZZ, o.offsetZ);
  }

  private static boolean sameRow(
      double ax, double ay, double az, double a, double bx, double by, double bz, double b) {
    return sameBits(ax, bx) && sameBits(ay, by) && sameBits(az, bz) && sameBits(a, b);
  }

  private static boolean sameBits(double a, double b) {
    return Double.doubleToRawLongBits(a) == Double.doubleToRawLongBits(b);
  }

  /**
   * {@return the sum of the absolute components of the offsets of this map and another}
   *
   * @param o the other map
   */
  public double sumOfOffsets(AffineMap o) {
    return Math.abs(offsetX)
        + Math.abs(offsetY)
        + Math.abs(offsetZ)
        + Math.abs(o.offsetX)
        + Math.abs(o.offsetY)
        + Math.abs(o.offsetZ);
  }
}
