package org.palpate.raycast;

/**
 * A straight segment between two points in grid coordinates, exactly as its six doubles say.
 *
 * <p>Mutable, so that a frame can use one instance again and again. One thread.
 */
public final class Ray {
  public double fromX;
  public double fromY;
  public double fromZ;
  public double toX;
  public double toY;
  public double toZ;

  /**
   * Sets the start of the ray.
   *
   * @param x the start along x, grid coordinates, finite
   * @param y its y component
   * @param z its z component
   * @return this ray
   */
  public Ray from(double x, double y, double z) {
    fromX = x;
    fromY = y;
    fromZ = z;
    return this;
  }

  /**
   * Sets the end of the ray.
   *
   * @param x the end along x, grid coordinates, finite
   * @param y its y component
   * @param z its z component
   * @return this ray
   */
  public Ray to(double x, double y, double z) {
    toX = x;
    toY = y;
    toZ = z;
    return this;
  }

  @Override
  public String toString() {
    return "(" + fromX + ", " + fromY + ", " + fromZ + ") to (" + toX + ", " + toY + ", " + toZ
        + ")";
  }
}
