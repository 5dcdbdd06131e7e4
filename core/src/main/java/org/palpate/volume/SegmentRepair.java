package org.palpate.volume;

import org.palpate.volume.ConnectedComponents.Neighbours;

/**
 * Removes small islands from a segment and fills small holes in it. Solid voxels belong together if
 * they share a face, an edge or a corner. Empty ones belong together if they share a face, because
 * no point passes where solids share an edge.
 *
 * <p>Any thread, on bits that no other thread changes.
 */
public final class SegmentRepair {
  private SegmentRepair() {}

  /**
   * {@return a copy without the islands that have fewer voxels than a number} The largest island
   * stays, however small it is.
   *
   * @param bits the segment; not changed
   * @param leastVoxels the smallest number of voxels of an island that stays
   */
  public static BitCube withoutIslands(BitCube bits, long leastVoxels) {
    BitCube result = bits.copy();
    BitCube largest = ConnectedComponents.largest(bits, Neighbours.FACES_EDGES_CORNERS);
    ConnectedComponents.visit(
        bits,
        Neighbours.FACES_EDGES_CORNERS,
        (voxels, count) -> {
          if (count < leastVoxels && !largest.get(voxels[0], voxels[1], voxels[2])) {
            for (int n = 0; n < 3 * count; n += 3) {
              result.clear(voxels[n], voxels[n + 1], voxels[n + 2]);
            }
          }
        });
    return result;
  }

  /**
   * {@return a copy in which holes that have fewer voxels than a number are filled} A hole is
   * enclosed: empty voxels at the faces of the grid belong to none.
   *
   * @param bits the segment; not changed
   * @param mostVoxels the smallest number of voxels of a hole that stays empty
   */
  public static BitCube withoutHoles(BitCube bits, long mostVoxels) {
    BitCube result = bits.copy();
    ConnectedComponents.visit(
        complement(bits),
        Neighbours.FACES,
        (voxels, count) -> {
          if (count < mostVoxels && isEnclosed(bits, voxels, count)) {
            for (int n = 0; n < 3 * count; n += 3) {
              result.set(voxels[n], voxels[n + 1], voxels[n + 2]);
            }
          }
        });
    return result;
  }

  private static boolean isEnclosed(BitCube bits, int[] voxels, int count) {
    for (int n = 0; n < 3 * count; n += 3) {
      if (isAtFace(voxels[n], bits.sizeX())
          || isAtFace(voxels[n + 1], bits.sizeY())
          || isAtFace(voxels[n + 2], bits.sizeZ())) {
        return false;
      }
    }
    return true;
  }

  private static boolean isAtFace(int voxel, int size) {
    return voxel == 0 || voxel == size - 1;
  }

  private static BitCube complement(BitCube bits) {
    BitCube empty = new BitCube(bits.sizeX(), bits.sizeY(), bits.sizeZ());
    for (int k = 0; k < bits.sizeZ(); k++) {
      for (int j = 0; j < bits.sizeY(); j++) {
        for (int i = 0; i < bits.sizeX(); i++) {
          if (!bits.get(i, j, k)) {
            empty.set(i, j, k);
          }
        }
      }
    }
    return empty;
  }
}
