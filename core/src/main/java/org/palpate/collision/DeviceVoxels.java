package org.palpate.collision;

import org.palpate.geometry.IntBox;
import org.palpate.geometry.PointSet;

/** The voxels of one bit cube on a {@link CollisionDevice}. One thread at a time. */
public interface DeviceVoxels {
  /**
   * Notes that voxels within a box may have changed. Allocates nothing.
   *
   * @param box may be empty and may reach beyond the cube
   */
  void voxelsChanged(IntBox box);

  /**
   * {@return a batch that judges the legs of points against these voxels} Allocates.
   *
   * @param points the points whose legs are judged, in the frame that a motion's maps lead from
   */
  LegBatch newBatch(PointSet points);
}
