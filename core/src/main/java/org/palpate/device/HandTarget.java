package org.palpate.device;

import java.util.List;
import org.palpate.geometry.Vec3;

/**
 * The target of a simulated hand, world mm.
 *
 * @param lowMm lowest corner of the box around the object to touch
 * @param highMm highest corner
 * @param voxelMm shortest edge of a voxel, the unit of the hand's depths and speeds
 * @param surfaceMm points on the surface, which the hand presses towards the centre of the box; if
 *     empty, the hand uses points inside the box
 */
public record HandTarget(Vec3 lowMm, Vec3 highMm, double voxelMm, List<Vec3> surfaceMm) {

  /**
   * Checks the box and the voxel's edge.
   *
   * @throws IllegalArgumentException if the box is empty or the edge is not positive
   */
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

  /**
   * {@return a target without known points on its surface}
   *
   * @param lowMm lowest corner of the box around the object to touch, world mm
   * @param highMm highest corner
   * @param voxelMm shortest edge of a voxel, the unit of the hand's depths and speeds
   */
  public static HandTarget ofBox(Vec3 lowMm, Vec3 highMm, double voxelMm) {
    return new HandTarget(lowMm, highMm, voxelMm, List.of());
  }

  /** Returns the centre of the box. */
  Vec3 centreMm() {
    return new Vec3((lowMm.x + highMm.x) / 2, (lowMm.y + highMm.y) / 2, (lowMm.z + highMm.z) / 2);
  }

  /** {@return half the diagonal of the box, mm, but at least four voxels} */
  public double radiusMm() {
    return Math.max(highMm.sub(lowMm, new Vec3()).length() / 2, 4 * voxelMm);
  }
}
