package org.palpate.raycast;

/**
 * Where a ray first met a solid voxel. An out-parameter: what it holds after a miss is not defined.
 */
public final class RayHit {
  /**
   * Value of {@link #axis} where the ray's start already touches the voxel or a sample found it.
   */
  public static final int NO_AXIS = -1;

  /** How far along the ray, 0 at its start and 1 at its end. */
  public double t;

  /** The voxel. */
  public int i;

  public int j;
  public int k;

  /**
   * The axis (0 is x, 1 is y, 2 is z) across whose grid plane the voxel was entered, or {@link
   * #NO_AXIS}.
   */
  public int axis;

  /** Sets all five. */
  public void set(double newT, int newI, int newJ, int newK, int newAxis) {
    t = newT;
    i = newI;
    j = newJ;
    k = newK;
    axis = newAxis;
  }

  /** The voxel's coordinate along an axis. */
  public int cell(int ofAxis) {
    return ofAxis == 0 ? i : ofAxis == 1 ? j : k;
  }

  /** Sets the voxel's coordinate along an axis. */
  public void setCell(int ofAxis, int cell) {
    if (ofAxis == 0) {
      i = cell;
    } else if (ofAxis == 1) {
      j = cell;
    } else {
      k = cell;
    }
  }

  public void set(RayHit other) {
    set(other.t, other.i, other.j, other.k, other.axis);
  }
}
