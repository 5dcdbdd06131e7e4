package org.palpate.raycast;

/**
 * The straight way between two points in grid coordinates, exactly as its six doubles say. Mutable
 * carrier.
 */
public final class Ray {
  public double fromX;
  public double fromY;
  public double fromZ;
  public double toX;
  public double toY;
  public double toZ;

  /** Sets where the ray starts. */
  public Ray from(double x, double y, double z) {
    fromX = x;
    fromY = y;
    fromZ = z;
    return this;
  }

  /** Sets where the ray ends. */
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
