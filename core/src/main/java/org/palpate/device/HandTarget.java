package org.palpate.device;

import java.util.List;
import org.palpate.geometry.Vec3;

/**
 * What a simulated hand goes for, world mm.
 *
 * @param lowMm lowest corner of the box that holds what is to be touched
 * @param highMm highest corner
 * @param voxelMm the shortest edge of a voxel, the measure of depths and speeds
 * @param surfaceMm points on the surface, pressed towards the box's centre; where there are none,
 *     points inside the box are used
 */
public record HandTarget(Vec3 lowMm, Vec3 highMm, double voxelMm, List<Vec3> surfaceMm) {

  /** Checks the box and the voxel's edge. */
  public HandTarget {
    surfaceMm = List.copyOf(surfaceMm);
    if (!(lowMm.x <= highMm.x && lowMm.y <= highMm.y && lowMm.z <= highMm.z)) {
      throw new IllegalArgumentException(
          "box must not be empty: lowMm=" + lowMm + " highMm=" + highMm);
    }
    if (!(voxelMm > 0)) {
      throw new IllegalArgumentException("voxelMm must be positive: voxelMm=" + voxelMm);
    }
  }

  /** A target without known points on its surface. */
  public static HandTarget ofBox(Vec3 lowMm, Vec3 highMm, double voxelMm) {
    return new HandTarget(lowMm, highMm, voxelMm, List.of());
  }

  /** The middle of the box. */
  Vec3 centreMm() {
    return new Vec3((lowMm.x + highMm.x) / 2, (lowMm.y + highMm.y) / 2, (lowMm.z + highMm.z) / 2);
  }

  /** Half the box's diagonal, at least four voxels. */
  double radiusMm() {
    return Math.max(highMm.sub(lowMm, new Vec3()).length() / 2, 4 * voxelMm);
  }
}
