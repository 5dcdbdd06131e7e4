package org.palpate.body;

import java.util.Arrays;
import org.palpate.geometry.IntBox;
import org.palpate.volume.BitCube;

/**
 * Lower bounds of the distance to the solid voxels of a bit cube. For each brick, holds the
 * distance in bricks to the nearest brick with a solid voxel, up to a limit. This is the Chebyshev
 * distance: the largest difference along an axis.
 *
 * <p>Invariant: no distance is larger than the true one. Added voxels must be reported; the bounds
 * still hold after voxels are removed. Belongs to one thread. Cost of a query: one load.
 */
public final class BrickClearance {
  /**
   * The largest distance that is stored, bricks, so that an added voxel changes a bounded
   * neighbourhood.
   */
  public static final int LARGEST_BRICKS = 8;

  private static final int BRICK_EDGE = 1 << BitCube.BRICK_SHIFT;

  private final BitCube bits;
  private final byte[] distance;
  private final int bricksX;
  private final int bricksY;
  private final int bricksZ;

  /**
   * Measures all bricks of a cube that the caller keeps.
   *
   * @param bits the voxels; later additions are to be reported
   */
  public BrickClearance(BitCube bits) {
    this.bits = bits;
    bricksX = bits.bricksX();
    bricksY = bits.bricksY();
    bricksZ = bits.bricksZ();
    distance = new byte[bricksX * bricksY * bricksZ];
    measureAll();
  }

  private void measureAll() {
    Arrays.fill(distance, (byte) LARGEST_BRICKS);
    for (int z = 0; z < bricksZ; z++) {
      for (int y = 0; y < bricksY; y++) {
        for (int x = 0; x < bricksX; x++) {
          if (bits.brick(x, y, z) != 0) {
            distance[index(x, y, z)] = 0;
          }
        }
      }
    }
    spreadAlong(1, bricksX, bricksY * bricksZ, bricksX);
    for (int z = 0; z < bricksZ; z++) {
      spreadLayer(z * bricksX * bricksY);
    }
    spreadAlong(bricksX * bricksY, bricksZ, bricksX * bricksY, 1);
  }

  private void spreadLayer(int first) {
    for (int x = 0; x < bricksX; x++) {
      spreadLine(first + x, bricksX, bricksY);
    }
  }

  private void spreadAlong(int stride, int length, int lines, int lineStride) {
    for (int line = 0; line < lines; line++) {
      spreadLine(line * lineStride, stride, length);
    }
  }

  /**
   * Replaces each value of a line by the minimum of max(value, number of bricks to it) over the
   * line. One pass for each axis gives the Chebyshev distance.
   */
  private void spreadLine(int first, int stride, int length) {
    byte[] line = new byte[length];
    for (int n = 0; n < length; n++) {
      line[n] = distance[first + n * stride];
    }
    for (int n = 0; n < length; n++) {
      int least = line[n];
      for (int step = 1; step < least; step++) {
        int below = n - step >= 0 ? line[n - step] : LARGEST_BRICKS;
        int above = n + step < length ? line[n + step] : LARGEST_BRICKS;
        least = Math.min(least, Math.max(step, Math.min(below, above)));
      }
      distance[first + n * stride] = (byte) least;
    }
  }

  private int index(int x, int y, int z) {
    return (z * bricksY + y) * bricksX + x;
  }

  /**
   * Lowers the bounds for voxels that became solid anywhere in a box of voxels. Cost: about 5,000
   * bricks for each brick of the box that is not empty.
   *
   * @param box the box of voxels; may reach beyond the cube
   */
  public void solidsAdded(IntBox box) {
    if (box.isEmpty()) {
      return;
    }
    for (int z = Math.max(0, box.lowZ >> 2); z <= Math.min(bricksZ - 1, box.highZ >> 2); z++) {
      for (int y = Math.max(0, box.lowY >> 2); y <= Math.min(bricksY - 1, box.highY >> 2); y++) {
        for (int x = Math.max(0, box.lowX >> 2); x <= Math.min(bricksX - 1, box.highX >> 2); x++) {
          if (distance[index(x, y, z)] != 0 && bits.brick(x, y, z) != 0) {
            lowerAround(x, y, z);
          }
        }
      }
    }
  }

  private void lowerAround(int x, int y, int z) {
    int reach = LARGEST_BRICKS - 1;
    for (int w = Math.max(0, z - reach); w <= Math.min(bricksZ - 1, z + reach); w++) {
      for (int v = Math.max(0, y - reach); v <= Math.min(bricksY - 1, y + reach); v++) {
        int far = Math.max(Math.abs(w - z), Math.abs(v - y));
        for (int u = Math.max(0, x - reach); u <= Math.min(bricksX - 1, x + reach); u++) {
          int at = index(u, v, w);
          distance[at] = (byte) Math.min(distance[at], Math.max(far, Math.abs(u - x)));
        }
      }
    }
  }

  /**
   * {@return half the edge, in voxels, of an open cube around a point that no solid voxel reaches}
   *
   * @param x the point along x, grid coordinates, finite
   * @param y its y component
   * @param z its z component
   */
  public double at(double x, double y, double z) {
    double insideX = clamp(x, bricksX * BRICK_EDGE);
    double insideY = clamp(y, bricksY * BRICK_EDGE);
    double insideZ = clamp(z, bricksZ * BRICK_EDGE);
    double beside =
        Math.max(Math.abs(x - insideX), Math.max(Math.abs(y - insideY), Math.abs(z - insideZ)));
    return Math.max(beside, atInside(insideX, insideY, insideZ));
  }

  private static double clamp(double v, int size) {
    return v < 0 ? 0 : v > size ? size : v;
  }

  private double atInside(double x, double y, double z) {
    int brickX = Math.min((int) x >> 2, bricksX - 1);
    int brickY = Math.min((int) y >> 2, bricksY - 1);
    int brickZ = Math.min((int) z >> 2, bricksZ - 1);
    int bricks = distance[index(brickX, brickY, brickZ)];
    if (bricks == 0) {
      return 0;
    }
    double inner =
        Math.min(
            toRim(x - (brickX << 2)), Math.min(toRim(y - (brickY << 2)), toRim(z - (brickZ << 2))));
    return (bricks - 1) * BRICK_EDGE + inner;
  }

  private static double toRim(double inBrick) {
    return Math.min(inBrick, BRICK_EDGE - inBrick);
  }
}
