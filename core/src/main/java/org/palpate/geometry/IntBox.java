package org.palpate.geometry;

/**
 * An axis-aligned box of whole cells, both ends included. In an empty box every low end lies above
 * its high end, as {@link #clear} sets it; never make a box empty along one axis alone. Mutable;
 * one thread.
 */
public final class IntBox {
  public int lowX;
  public int lowY;
  public int lowZ;
  public int highX;
  public int highY;
  public int highZ;

  /** Creates an empty box. */
  public IntBox() {
    clear();
  }

  /** Makes the box empty. */
  public void clear() {
    lowX = lowY = lowZ = Integer.MAX_VALUE;
    highX = highY = highZ = Integer.MIN_VALUE;
  }

  /** {@return whether the box contains no cell} Compares the ends along x, see above. */
  public boolean isEmpty() {
    return lowX > highX;
  }

  /**
   * Grows the box so that it contains the cell.
   *
   * @param i the number of the cell along x
   * @param j its number along y
   * @param k its number along z
   */
  public void include(int i, int j, int k) {
    lowX = Math.min(lowX, i);
    lowY = Math.min(lowY, j);
    lowZ = Math.min(lowZ, k);
    highX = Math.max(highX, i);
    highY = Math.max(highY, j);
    highZ = Math.max(highZ, k);
  }

  /**
   * Grows the box so that it contains another, which may be empty.
   *
   * @param other the box to contain; not changed
   */
  public void include(IntBox other) {
    if (!other.isEmpty()) {
      include(other.lowX, other.lowY, other.lowZ);
      include(other.highX, other.highY, other.highZ);
    }
  }

  /**
   * Copies another box.
   *
   * @param other the box to copy, perhaps empty
   * @return this box
   */
  public IntBox set(IntBox other) {
    lowX = other.lowX;
    lowY = other.lowY;
    lowZ = other.lowZ;
    highX = other.highX;
    highY = other.highY;
    highZ = other.highZ;
    return this;
  }

  /**
   * {@return the low end along an axis}
   *
   * @param axis 0 to 2
   */
  public int low(int axis) {
    return axis == 0 ? lowX : axis == 1 ? lowY : lowZ;
  }

  /**
   * {@return the high end along an axis}
   *
   * @param axis 0 to 2
   */
  public int high(int axis) {
    return axis == 0 ? highX : axis == 1 ? highY : highZ;
  }

  /**
   * Sets both ends along an axis.
   *
   * @param axis 0 to 2
   * @param low the lowest cell
   * @param high the highest cell
   */
  public void setRange(int axis, int low, int high) {
    if (axis == 0) {
      lowX = low;
      highX = high;
    } else if (axis == 1) {
      lowY = low;
      highY = high;
    } else {
      lowZ = low;
      highZ = high;
    }
  }

  /**
   * {@return whether the box contains the cell}
   *
   * @param i the number of the cell along x
   * @param j its number along y
   * @param k its number along z
   */
  public boolean contains(int i, int j, int k) {
    return i >= lowX && i <= highX && j >= lowY && j <= highY && k >= lowZ && k <= highZ;
  }

  /**
   * {@return whether a point lies in the box, whose cells are closed}
   *
   * @param p the point, in the coordinates in which cell (i,j,k) is the cube from (i,j,k) to
   *     (i+1,j+1,k+1)
   */
  public boolean touches(Vec3 p) {
    return p.x >= lowX
        && p.x <= highX + 1.0
        && p.y >= lowY
        && p.y <= highY + 1.0
        && p.z >= lowZ
        && p.z <= highZ + 1.0;
  }

  /**
   * {@return whether the two boxes share a cell}
   *
   * @param other the box to compare with; an empty one shares no cell
   */
  public boolean meets(IntBox other) {
    return lowX <= other.highX
        && other.lowX <= highX
        && lowY <= other.highY
        && other.lowY <= highY
        && lowZ <= other.highZ
        && other.lowZ <= highZ;
  }

  /**
   * Grows the box, which must not be empty, on each side. Stops at the ends of the int range.
   *
   * @param cells the number of cells that are added on each side
   * @return this box
   */
  public IntBox grow(int cells) {
    lowX = (int) Math.max(Integer.MIN_VALUE, (long) lowX - cells);
    lowY = (int) Math.max(Integer.MIN_VALUE, (long) lowY - cells);
    lowZ = (int) Math.max(Integer.MIN_VALUE, (long) lowZ - cells);
    highX = (int) Math.min(Integer.MAX_VALUE, (long) highX + cells);
    highY = (int) Math.min(Integer.MAX_VALUE, (long) highY + cells);
    highZ = (int) Math.min(Integer.MAX_VALUE, (long) highZ + cells);
    return this;
  }

  @Override
  public String toString() {
    return isEmpty()
        ? "empty"
        : "x " + lowX + "-" + highX + ", y " + lowY + "-" + highY + ", z " + lowZ + "-" + highZ;
  }
}
