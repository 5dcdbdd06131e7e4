package org.palpate.scene;

import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;

/**
 * Grey values on three planes of the grid.
 *
 * @param grey where the values come from
 * @param i the plane across x that is shown, a voxel number; -1 for none
 * @param j across y
 * @param k across z
 * @param spacingMm of a voxel
 * @param pose from grid millimetres to the scene frame
 */
public record SlicePlanes(Grey grey, int i, int j, int k, Vec3 spacingMm, RigidTransform pose) {

  /** Grey values of a grid. Read by the thread that draws. */
  public interface Grey {
    int size(int axis);

    /** The value of a voxel of the grid. */
    double value(int i, int j, int k);

    /** What is drawn black. */
    double black();

    /** What is drawn white. */
    double white();
  }

  /** The plane across an axis. */
  public int plane(int axis) {
    return axis == 0 ? i : axis == 1 ? j : k;
  }
}
