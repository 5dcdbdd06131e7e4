package org.palpate.geometry;

/**
 * An axis-aligned box in the world, mm, both ends included. The low ends of an empty box are
 * infinite. Mutable; one thread.
 */
public final class WorldBox {
  public double lowX;
  public double lowY;
  public double lowZ;
  public double highX;
  public double highY;
  public double highZ;

  /** Creates an empty box. */
  public WorldBox() {
    clear();
  }

  /**
   * Makes the box empty.
   *
   * @return this box
   */
  public WorldBox clear() {
    lowX = lowY = lowZ = Double.POSITIVE_INFINITY;
    highX = highY = highZ = Double.NEGATIVE_INFINITY;
    return this;
  }

  /**
   * Copies another box.
   *
   * @param o the box to copy
   * @return this box
   */
  public WorldBox set(WorldBox o) {
    lowX = o.lowX;
    lowY = o.lowY;
    lowZ = o.lowZ;
    highX = o.highX;
    highY = o.highY;
    highZ = o.highZ;
    return this;
  }

  /**
   * Grows the box so that it contains a point.
   *
   * @param p the point, world mm
   * @return this box
   */
  public WorldBox include(Vec3 p) {
    lowX = Math.min(lowX, p.x);
    lowY = Math.min(lowY, p.y);
    lowZ = Math.min(lowZ, p.z);
    highX = Math.max(highX, p.x);
    highY = Math.max(highY, p.y);
    highZ = Math.max(highZ, p.z);
    return this;
  }

  /**
   * Sets the box around the image of a box of cells, which are closed.
   *
   * @param toWorld from the coordinates of the cells to world mm
   * @param cells not empty
   * @param margin the number of cells that are added on each side
   * @return this box
   */
  public WorldBox setImage(AffineMap toWorld, IntBox cells, int margin) {
    double x = 0.5 * (cells.highX + 1.0 + cells.lowX);
    double y = 0.5 * (cells.highY + 1.0 + cells.lowY);
    double z = 0.5 * (cells.highZ + 1.0 + cells.lowZ);
    double sideX = cells.highX + 1.0 - x + margin;
    double sideY = cells.highY + 1.0 - y + margin;
    double sideZ = cells.highZ + 1.0 - z + margin;
    double atX = toWorld.x(x, y, z);
    double atY = toWorld.y(x, y, z);
    double atZ = toWorld.z(x, y, z);
    double alongX = reach(toWorld.mXX, toWorld.mXY, toWorld.mXZ, sideX, sideY, sideZ);
    double alongY = reach(toWorld.mYX, toWorld.mYY, toWorld.mYZ, sideX, sideY, sideZ);
    double alongZ = reach(toWorld.mZX, toWorld.mZY, toWorld.mZZ, sideX, sideY, sideZ);
    lowX = atX - alongX;
    lowY = atY - alongY;
    lowZ = atZ - alongZ;
    highX = atX + alongX;
    highY = atY + alongY;
    highZ = atZ + alongZ;
    return this;
  }

  private static double reach(double a, double b, double c, double x, double y, double z) {
    return Math.abs(a) * x + Math.abs(b) * y + Math.abs(c) * z;
  }

  /**
   * Sets the smallest box that contains two others.
   *
   * @param a the first box, which may be this one
   * @param b the second box, which may be this one
   * @return this box
   */
  public WorldBox setUnion(WorldBox a, WorldBox b) {
    lowX = Math.min(a.lowX, b.lowX);
    lowY = Math.min(a.lowY, b.lowY);
    lowZ = Math.min(a.lowZ, b.lowZ);
    highX = Math.max(a.highX, b.highX);
    highY = Math.max(a.highY, b.highY);
    highZ = Math.max(a.highZ, b.highZ);
    return this;
  }

  /**
   * Moves each side outwards.
   *
   * @param mm the distance of each side, mm
   * @return this box
   */
  public WorldBox grow(double mm) {
    lowX -= mm;
    lowY -= mm;
    lowZ -= mm;
    highX += mm;
    highY += mm;
    highZ += mm;
    return this;
  }

  /** {@return the largest absolute coordinate of a box that is not empty, mm} */
  public double farthestMm() {
    double x = Math.max(Math.abs(lowX), Math.abs(highX));
    double y = Math.max(Math.abs(lowY), Math.abs(highY));
    double z = Math.max(Math.abs(lowZ), Math.abs(highZ));
    return Math.max(x, Math.max(y, z));
  }

  /** {@return the sum of the edges along the three axes, mm} */
  public double edgesMm() {
    return highX - lowX + (highY - lowY) + (highZ - lowZ);
  }

  /**
   * {@return whether two boxes have a point in common} An empty box has none.
   *
   * @param o the box to compare with
   */
  public boolean meets(WorldBox o) {
    return lowX <= o.highX
        && o.lowX <= highX
        && lowY <= o.highY
        && o.lowY <= highY
        && lowZ <= o.highZ
        && o.lowZ <= highZ;
  }

  /**
   * {@return whether the box contains all points of another}
   *
   * @param o the box that may lie inside
   */
  public boolean contains(WorldBox o) {
    return lowX <= o.lowX
        && o.highX <= highX
        && lowY <= o.lowY
        && o.highY <= highY
        && lowZ <= o.lowZ
        && o.highZ <= highZ;
  }

  @Override
  public String toString() {
    return "x " + lowX + ".." + highX + ", y " + lowY + ".." + highY + ", z " + lowZ + ".." + highZ;
  }
}
