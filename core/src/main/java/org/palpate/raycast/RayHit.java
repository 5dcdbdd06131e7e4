package org.palpate.raycast;

/**
 * The first solid voxel that a ray meets. An out-parameter of a cast: its contents after a miss are
 * undefined.
 */
public final class RayHit {
  /**
   * The value of {@link #axis} if the ray starts in the voxel, or if a sample found it. A ray that
   * starts on a plane of the voxel may have the axis of that plane instead.
   */
  public static final int NO_AXIS = -1;

  /** The ray parameter of the hit: 0 at the start of the ray, 1 at its end. */
  public double t;

  /** The x coordinate of the voxel. */
  public int i;

  /** The y coordinate of the voxel. */
  public int j;

  /** The z coordinate of the voxel. */
  public int k;

  /**
   * The axis whose grid plane the ray crosses when it enters the voxel: 0 is x, 1 is y, 2 is z;
   * else {@link #NO_AXIS}.
   */
  public int axis;

  /**
   * Sets all components.
   *
   * @param newT where the ray enters the voxel: 0 at its start, 1 at its end
   * @param newI the voxel's number along x
   * @param newJ its number along y
   * @param newK its number along z
   * @param newAxis see {@link #axis}
   */
  public void set(double newT, int newI, int newJ, int newK, int newAxis) {
    t = newT;
    i = newI;
    j = newJ;
    k = newK;
    axis = newAxis;
  }

  /**
   * Copies all components of another hit.
   *
   * @param other the hit to copy
   */
  public void set(RayHit other) {
    set(other.t, other.i, other.j, other.k, other.axis);
  }

  /**
   * {@return the coordinate of the voxel along an axis}
   *
   * @param ofAxis 0 for x, 1 for y, 2 for z
   */
  public int cell(int ofAxis) {
    return ofAxis == 0 ? i : ofAxis == 1 ? j : k;
  }

  /**
   * Sets the coordinate of the voxel along an axis.
   *
   * @param ofAxis 0 for x, 1 for y, 2 for z
   * @param cell the voxel's number along it
   */
  public void setCell(int ofAxis, int cell) {
    if (ofAxis == 0) {
      i = cell;
    } else if (ofAxis == 1) {
      j = cell;
    } else {
      k = cell;
    }
  }
}
