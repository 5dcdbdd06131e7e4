package org.palpate.benchmarks.fracture;

import java.io.IOException;
import java.nio.file.Path;
import org.palpate.benchmarks.input.Scans;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;
import org.palpate.volume.fracture.FractureSpec;
import org.palpate.volume.phantom.FracturePhantom;

/**
 * A bone before it breaks, of voxels of 1 mm.
 *
 * @param name its name in tables
 * @param bits the voxels
 */
record WholeBone(String name, BitCube bits) {
  private static final int TUBE_LENGTH = 100;
  private static final double TUBE_OUTER = 12;
  private static final double TUBE_INNER = 6;
  private static final int MARGIN = 4;

  /** The box of the scan CThead that holds the lower jaw below its teeth, voxels. */
  private static final int JAW_LOW_X = 45;

  private static final int JAW_LOW_Y = 20;
  private static final int JAW_LOW_SLICE = 84;
  private static final int JAW_SIZE_X = 126;
  private static final int JAW_SIZE_Y = 72;
  private static final int JAW_SLICES = 29;

  /** The slices of the scan lie 2 mm apart. */
  private static final int PER_SLICE = 2;

  /** Returns a tube like the shaft of a long bone, 100 mm long and 24 mm thick. */
  static WholeBone tube() {
    int width = 2 * ((int) TUBE_OUTER + MARGIN);
    BitCube bits = new BitCube(width, width, TUBE_LENGTH + 2 * MARGIN);
    double middle = width / 2.0;
    for (int j = 0; j < width; j++) {
      for (int i = 0; i < width; i++) {
        double radius = Math.hypot(i + 0.5 - middle, j + 0.5 - middle);
        for (int k = MARGIN; k < MARGIN + TUBE_LENGTH; k++) {
          if (radius >= TUBE_INNER && radius <= TUBE_OUTER) {
            bits.set(i, j, k);
          }
        }
      }
    }
    return new WholeBone("tube", bits);
  }

  /** Returns the bent arch of {@code --phantom fracture:160}. */
  static WholeBone arch() {
    FractureSpec any = new FractureSpec(2, 1, 0);
    return new WholeBone("arch", new FracturePhantom(FracturePhantom.DEFAULT_EDGE, any).bone());
  }

  /**
   * Returns the lower jaw of the scan CThead below its teeth, whose metal streaks are left out.
   *
   * @param data the folder of the scans
   */
  static WholeBone jaw(Path data) throws IOException {
    BitCube head = Scans.read(data, Scans.NAMES.get(0)).bone();
    BitCube bits = new BitCube(JAW_SIZE_X, JAW_SIZE_Y, JAW_SLICES * PER_SLICE);
    for (int k = 0; k < bits.sizeZ(); k++) {
      for (int j = 0; j < JAW_SIZE_Y; j++) {
        for (int i = 0; i < JAW_SIZE_X; i++) {
          if (head.get(JAW_LOW_X + i, JAW_LOW_Y + j, JAW_LOW_SLICE + k / PER_SLICE)) {
            bits.set(i, j, k);
          }
        }
      }
    }
    return new WholeBone("jaw", bits);
  }

  /** Returns the grid. */
  VoxelGrid grid() {
    return VoxelGrid.ofUnitVoxels(bits.sizeX(), bits.sizeY(), bits.sizeZ());
  }
}
