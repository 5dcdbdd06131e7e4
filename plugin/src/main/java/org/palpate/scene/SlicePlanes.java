package org.palpate.scene;

import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;

/**
 * Grey values on up to three planes of the grid.
 *
 * @param grey the grey values
 * @param i number of the plane across x; -1 for none
 * @param j number of the plane across y; -1 for none
 * @param k number of the plane across z; -1 for none
 * @param spacingMm edge lengths of a voxel
 * @param pose transform from grid mm to the scene frame
 */
public record SlicePlanes(Grey grey, int i, int j, int k, Vec3 spacingMm, RigidTransform pose) {

  /** Grey values of a grid. The drawing thread reads them. */
  public interface Grey {
    /** Returns the number of voxels along an axis. */
    int size(int axis);

    /** Returns the value of a voxel. */
    double value(int i, int j, int k);

    /** Returns the value that is drawn black. */
    double black();

    /** Returns the value that is drawn white. */
    double white();
  }

  /** Returns the number of the plane across an axis. */
  public int plane(int axis) {
    return axis == 0 ? i : axis == 1 ? j : k;
  }
}
