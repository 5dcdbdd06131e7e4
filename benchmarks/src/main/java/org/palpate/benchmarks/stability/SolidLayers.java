package org.palpate.benchmarks.stability;

import org.palpate.body.Body;
import org.palpate.body.Mobility;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/** Flat layers of voxels across z in a cube. */
final class SolidLayers {
  /** The edge of the cube, voxels. */
  static final int EDGE = 128;

  private SolidLayers() {}

  /** Returns a cube whose layers from {@code low} to below {@code high} are solid. */
  static BitCube bits(int low, int high) {
    BitCube bits = new BitCube(EDGE, EDGE, EDGE);
    for (int k = low; k < high; k++) {
      for (int j = 0; j < EDGE; j++) {
        for (int i = 0; i < EDGE; i++) {
          bits.set(i, j, k);
        }
      }
    }
    return bits;
  }

  /** Returns a body of the lowest layers. */
  static Body body(String name, int layers) {
    double voxel = TouchedShape.VOXEL_MM;
    VoxelGrid grid =
        new VoxelGrid(EDGE, EDGE, EDGE, new Vec3(voxel, voxel, voxel), RigidTransform.identity());
    return new Body(name, bits(0, layers), grid, Mobility.FIXED);
  }

  /** Returns the position above the middle of the cube at a height, mm. */
  static Vec3 middleMm(double heightMm) {
    double middle = EDGE / 2 * TouchedShape.VOXEL_MM;
    return new Vec3(middle, middle, heightMm);
  }
}
