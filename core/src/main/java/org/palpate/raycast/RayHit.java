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

  /** Sets all components. */
  public void set(double newT, int newI, int newJ, int newK, int newAxis) {
    t = newT;
    i = newI;
    j = newJ;
    k = newK;
    axis = newAxis;
  }

  /** Copies all components of {@code other}. */
  public void set(RayHit other) {
    set(other.t, other.i, other.j, other.k, other.axis);
  }

  /** Returns the coordinate of the voxel along an axis: 0 is x, 1 is y, 2 is z. */
  public int cell(int ofAxis) {
    return ofAxis == 0 ? i : ofAxis == 1 ? j : k;
  }

  /** Sets the coordinate of the voxel along an axis: 0 is x, 1 is y, 2 is z. */
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
