package org.palpate.benchmarks.elastic;

import java.util.List;
import org.palpate.geometry.GridMetric;
import org.palpate.volume.BitCube;

/**
 * Voxels of a soft segment and of one that stands still.
 *
 * @param name for tables
 * @param soft the voxels that deform
 * @param still the voxels that stand still; may be empty
 */
record SoftScene(String name, BitCube soft, BitCube still, GridMetric metric) {
  /** The width of the air at each side of a block, voxels. */
  static final int MARGIN = 16;

  /** The lowest layer of a block; the floor lies below it. */
  static final int FLOOR = 8;

  /** Returns a block of the usual size, 64 x 64 x 40 voxels of 1 mm, on a floor. */
  static SoftScene block() {
    return block(64, 40, new GridMetric(1, 1, 1));
  }

  /** Returns a block on a floor. */
  static SoftScene block(int width, int height, GridMetric metric) {
    int across = width + 2 * MARGIN;
    BitCube soft = new BitCube(across, across, FLOOR + height + 24);
    BitCube still = new BitCube(across, across, soft.sizeZ());
    fill(soft, MARGIN, MARGIN + width, FLOOR, FLOOR + height);
    fill(still, MARGIN / 2, across - MARGIN / 2, FLOOR - 4, FLOOR);
    return new SoftScene("block", soft, still, metric);
  }

  private static void fill(BitCube bits, int low, int high, int z0, int z1) {
    for (int k = z0; k < z1; k++) {
      for (int j = low; j < high; j++) {
        for (int i = low; i < high; i++) {
          bits.set(i, j, k);
        }
      }
    }
  }

  /** Returns a copy whose voxels may be edited. */
  SoftScene copy() {
    return new SoftScene(name, soft.copy(), still.copy(), metric);
  }

  /** Returns the voxels of both, which an interaction point must not touch. */
  List<BitCube> solids() {
    return List.of(soft, still);
  }
}
