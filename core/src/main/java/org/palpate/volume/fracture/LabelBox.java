package org.palpate.volume.fracture;

import org.palpate.geometry.IntBox;
import org.palpate.volume.BitCube;
import org.palpate.volume.ConnectedComponents;
import org.palpate.volume.ConnectedComponents.Neighbours;

/** The label of each voxel in a box of a grid, 1 to 127; 0 is empty. One thread. */
final class LabelBox {
  private final IntBox box = new IntBox();
  private final int sizeX;
  private final int sizeY;
  private final byte[] labels;

  /** Creates an empty box. */
  LabelBox(IntBox box) {
    this.box.set(box);
    sizeX = box.highX - box.lowX + 1;
    sizeY = box.highY - box.lowY + 1;
    labels =
        new byte
            [Math.toIntExact(Math.multiplyExact((long) sizeX * sizeY, box.highZ - box.lowZ + 1L))];
  }

  private LabelBox(LabelBox other) {
    box.set(other.box);
    sizeX = other.sizeX;
    sizeY = other.sizeY;
    labels = other.labels.clone();
  }

  LabelBox copy() {
    return new LabelBox(this);
  }

  private int index(int i, int j, int k) {
    return i - box.lowX + sizeX * (j - box.lowY + sizeY * (k - box.lowZ));
  }

  /** Returns the label of a voxel; 0 outside the box. */
  int get(int i, int j, int k) {
    return box.contains(i, j, k) ? labels[index(i, j, k)] : 0;
  }

  /** Sets the label of a voxel in the box. */
  void set(int i, int j, int k, int label) {
    labels[index(i, j, k)] = (byte) label;
  }

  /** Returns the voxels of a label in a cube of given sizes. */
  BitCube bits(int label, BitCube sizes) {
    BitCube cube = new BitCube(sizes.sizeX(), sizes.sizeY(), sizes.sizeZ());
    int n = 0;
    for (int k = box.lowZ; k <= box.highZ; k++) {
      for (int j = box.lowY; j <= box.highY; j++) {
        for (int i = box.lowX; i <= box.highX; i++, n++) {
          if (labels[n] == label) {
            cube.set(i, j, k);
          }
        }
      }
    }
    return cube;
  }

  /** Removes all components of a label but the largest, and adds their voxels to {@code strays}. */
  void keepLargest(int label, BitCube strays) {
    BitCube all = bits(label, strays);
    BitCube largest = ConnectedComponents.largest(all, Neighbours.FACES_EDGES_CORNERS);
    ConnectedComponents.visit(
        all,
        Neighbours.FACES_EDGES_CORNERS,
        (voxels, count) -> {
          if (!largest.get(voxels[0], voxels[1], voxels[2])) {
            for (int n = 0; n < 3 * count; n += 3) {
              set(voxels[n], voxels[n + 1], voxels[n + 2], 0);
              strays.set(voxels[n], voxels[n + 1], voxels[n + 2]);
            }
          }
        });
  }

  /** Counts the labels among the 26 neighbours of a voxel into {@code counts}. */
  void countNeighbours(int i, int j, int k, int[] counts) {
    for (int n = 0; n < 27; n++) {
      counts[get(i + n % 3 - 1, j + n / 3 % 3 - 1, k + n / 9 - 1)]++;
    }
  }

  /**
   * Whether a voxel within some steps along each axis has a label from {@code least} to {@code
   * most}.
   */
  boolean hasNear(int i, int j, int k, int steps, int least, int most) {
    for (int z = Math.max(box.lowZ, k - steps); z <= Math.min(box.highZ, k + steps); z++) {
      for (int y = Math.max(box.lowY, j - steps); y <= Math.min(box.highY, j + steps); y++) {
        for (int x = Math.max(box.lowX, i - steps); x <= Math.min(box.highX, i + steps); x++) {
          int label = labels[index(x, y, z)];
          if (label >= least && label <= most) {
            return true;
          }
        }
      }
    }
    return false;
  }
}
