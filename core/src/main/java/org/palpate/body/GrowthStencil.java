package org.palpate.body;

import java.util.Optional;
import org.palpate.volume.BitCube;

/**
 * The voxels that make a cell of {@link GrownSolids} solid, as masks of their bricks. The masks
 * depend on where the cell lies relative to the bricks, so there is a set of masks for each such
 * position. One thread.
 */
final class GrowthStencil {
  /** The largest number of masks; they take 256 kB. */
  private static final int MOST_MASKS = 1 << 15;

  private static final int BRICK_EDGE = 1 << BitCube.BRICK_SHIFT;

  private final Axis x;
  private final Axis y;
  private final Axis z;
  private final long[] masks;

  /** The bricks along one axis that a cell needs. */
  private static final class Axis {
    /** The first cell of voxel 0. */
    final int first;

    /** The number of cells along the edge of a brick, a power of two. */
    final int period;

    /**
     * For each position of a cell in its brick, the lowest brick with a voxel that may make the
     * cell solid, relative to the brick of the cell.
     */
    final int[] lowest;

    /** The number of bricks from there on. */
    final int bricks;

    Axis(GrownSolids grown, int axis) {
      first = grown.padVoxels() * grown.parts(axis);
      period = BRICK_EDGE * grown.parts(axis);
      lowest = new int[period];
      int most = 0;
      for (int n = 0; n < period; n++) {
        lowest[n] = grown.lowestVoxel(first + n, axis) >> BitCube.BRICK_SHIFT;
        int highest = grown.highestVoxel(first + n, axis) >> BitCube.BRICK_SHIFT;
        most = Math.max(most, highest - lowest[n] + 1);
      }
      bricks = most;
    }

    /** Returns the position of a cell in its brick. */
    int position(int cell) {
      return cell - first & period - 1;
    }

    /** Returns the lowest brick that a cell needs. */
    int lowestBrick(int cell) {
      return Math.floorDiv(cell - first, period) + lowest[position(cell)];
    }
  }

  private GrowthStencil(Axis x, Axis y, Axis z) {
    this.x = x;
    this.y = y;
    this.z = z;
    masks = new long[(int) count(x, y, z)];
  }

  /** Returns the stencil of grown solids, unless it takes too much memory. */
  static Optional<GrowthStencil> of(GrownSolids grown) {
    Axis x = new Axis(grown, 0);
    Axis y = new Axis(grown, 1);
    Axis z = new Axis(grown, 2);
    if (count(x, y, z) > MOST_MASKS) {
      return Optional.empty();
    }
    GrowthStencil stencil = new GrowthStencil(x, y, z);
    stencil.fill(grown);
    return Optional.of(stencil);
  }

  private static long count(Axis x, Axis y, Axis z) {
    return (long) x.period * y.period * z.period * x.bricks * y.bricks * z.bricks;
  }

  private void fill(GrownSolids grown) {
    int at = 0;
    for (int c = z.first; c < z.first + z.period; c++) {
      for (int b = y.first; b < y.first + y.period; b++) {
        for (int a = x.first; a < x.first + x.period; a++) {
          at = fillCell(grown, a, b, c, at);
        }
      }
    }
  }

  private int fillCell(GrownSolids grown, int a, int b, int c, int from) {
    int at = from;
    for (int brickZ = z.lowestBrick(c); brickZ < z.lowestBrick(c) + z.bricks; brickZ++) {
      for (int brickY = y.lowestBrick(b); brickY < y.lowestBrick(b) + y.bricks; brickY++) {
        for (int brickX = x.lowestBrick(a); brickX < x.lowestBrick(a) + x.bricks; brickX++) {
          for (int n = 0; n < Long.SIZE; n++) {
            int i = BRICK_EDGE * brickX + (n & 3);
            int j = BRICK_EDGE * brickY + (n >> 2 & 3);
            int k = BRICK_EDGE * brickZ + (n >> 4);
            masks[at] |= grown.reaches(i, j, k, a, b, c) ? 1L << BitCube.bit(i, j, k) : 0;
          }
          at++;
        }
      }
    }
    return at;
  }

  /** Whether a solid voxel makes a cell solid. */
  boolean isNearSolid(BitCube bits, int a, int b, int c) {
    int cell = (z.position(c) * y.period + y.position(b)) * x.period + x.position(a);
    int at = cell * x.bricks * y.bricks * z.bricks;
    int lowX = x.lowestBrick(a);
    int lowY = y.lowestBrick(b);
    int lowZ = z.lowestBrick(c);
    for (int brickZ = lowZ; brickZ < lowZ + z.bricks; brickZ++) {
      for (int brickY = lowY; brickY < lowY + y.bricks; brickY++) {
        for (int brickX = lowX; brickX < lowX + x.bricks; brickX++) {
          if ((bits.brick(brickX, brickY, brickZ) & masks[at++]) != 0) {
            return true;
          }
        }
      }
    }
    return false;
  }
}
