package org.palpate.volume;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;

/**
 * Splits the solid voxels of a cube into connected components by flood fill.
 *
 * <p>Any thread, on bits that no other thread changes. Cost: one visit of each solid voxel and its
 * neighbours, and 12 bytes for each voxel of the largest component.
 */
public final class ConnectedComponents {
  /** The voxels that count as neighbours of a voxel. */
  public enum Neighbours {
    /** The 6 voxels that share a face. */
    FACES(1),
    /** The 26 voxels that share a face, an edge or a corner. */
    FACES_EDGES_CORNERS(3);

    private final int mostSteps;

    Neighbours(int mostSteps) {
      this.mostSteps = mostSteps;
    }

    /** Whether a voxel is a neighbour that differs by these steps along the axes, each -1 to 1. */
    boolean include(int di, int dj, int dk) {
      int steps = Math.abs(di) + Math.abs(dj) + Math.abs(dk);
      return steps > 0 && steps <= mostSteps;
    }
  }

  /** Receives the components of a cube, one after the other. */
  public interface Visitor {
    /**
     * Takes a component.
     *
     * @param voxels the voxels, three numbers i, j, k for each; overwritten after the call
     * @param count the number of voxels, so that {@code 3 * count} numbers are valid
     */
    void accept(int[] voxels, int count);
  }

  private final BitCube remaining;
  private final Neighbours neighbours;
  private int[] voxels = new int[3 * 1024];
  private int count;

  private ConnectedComponents(BitCube bits, Neighbours neighbours) {
    remaining = bits.copy();
    this.neighbours = neighbours;
  }

  /**
   * Hands every component to the visitor, in the order of the first brick that they have.
   *
   * @param bits the voxels; they are copied
   * @param neighbours which voxels belong together
   * @param visitor receives the components on the calling thread
   */
  public static void visit(BitCube bits, Neighbours neighbours, Visitor visitor) {
    new ConnectedComponents(bits, neighbours).visit(visitor);
  }

  /**
   * {@return the components that have at least some voxels, each in a cube of the same size, the
   * largest first} Components of equal size stand in the order of their first brick.
   *
   * @param bits the voxels; they are copied
   * @param neighbours which voxels belong together
   * @param leastVoxels the smallest number of voxels of a component that is returned
   */
  public static List<BitCube> of(BitCube bits, Neighbours neighbours, long leastVoxels) {
    List<BitCube> found = new ArrayList<>();
    visit(
        bits,
        neighbours,
        (voxels, count) -> {
          if (count >= leastVoxels) {
            found.add(cubeOf(bits, voxels, count));
          }
        });
    found.sort(Comparator.comparingLong(BitCube::solidCount).reversed());
    return found;
  }

  /**
   * {@return the largest component, or the first one of several that are equally large; an empty
   * cube if nothing is solid}
   *
   * @param bits the voxels; they are copied
   * @param neighbours which voxels belong together
   */
  public static BitCube largest(BitCube bits, Neighbours neighbours) {
    BitCube[] largest = {new BitCube(bits.sizeX(), bits.sizeY(), bits.sizeZ())};
    visit(
        bits,
        neighbours,
        (voxels, count) -> {
          if (count > largest[0].solidCount()) {
            largest[0] = cubeOf(bits, voxels, count);
          }
        });
    return largest[0];
  }

  private static BitCube cubeOf(BitCube sizes, int[] voxels, int count) {
    BitCube cube = new BitCube(sizes.sizeX(), sizes.sizeY(), sizes.sizeZ());
    for (int n = 0; n < 3 * count; n += 3) {
      cube.set(voxels[n], voxels[n + 1], voxels[n + 2]);
    }
    return cube;
  }

  private void visit(Visitor visitor) {
    for (int z = 0; z < remaining.bricksZ(); z++) {
      for (int y = 0; y < remaining.bricksY(); y++) {
        for (int x = 0; x < remaining.bricksX(); x++) {
          visitBrick(x, y, z, visitor);
        }
      }
    }
  }

  private void visitBrick(int x, int y, int z, Visitor visitor) {
    for (long word = remaining.brick(x, y, z); word != 0; word = remaining.brick(x, y, z)) {
      int bit = Long.numberOfTrailingZeros(word);
      fill(4 * x + (bit & 3), 4 * y + (bit >> 2 & 3), 4 * z + (bit >> 4));
      visitor.accept(voxels, count);
    }
  }

  /** Moves the component of a voxel from the remaining voxels into the list. */
  private void fill(int i, int j, int k) {
    count = 0;
    take(i, j, k);
    for (int next = 0; next < count; next++) {
      takeNeighbours(voxels[3 * next], voxels[3 * next + 1], voxels[3 * next + 2]);
    }
  }

  private void takeNeighbours(int i, int j, int k) {
    for (int dk = -1; dk <= 1; dk++) {
      for (int dj = -1; dj <= 1; dj++) {
        for (int di = -1; di <= 1; di++) {
          if (neighbours.include(di, dj, dk) && remaining.get(i + di, j + dj, k + dk)) {
            take(i + di, j + dj, k + dk);
          }
        }
      }
    }
  }

  private void take(int i, int j, int k) {
    remaining.clear(i, j, k);
    if (3 * count == voxels.length) {
      voxels = Arrays.copyOf(voxels, Math.multiplyExact(2, voxels.length));
    }
    voxels[3 * count] = i;
    voxels[3 * count + 1] = j;
    voxels[3 * count + 2] = k;
    count++;
  }
}
