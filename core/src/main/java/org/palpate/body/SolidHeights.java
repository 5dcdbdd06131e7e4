package org.palpate.body;

import java.util.Arrays;
import org.palpate.volume.BitCube;

/**
 * Finds how high the solid voxels of a bit cube reach along a direction. The height of a point is
 * the scalar product of its grid coordinates and the direction. What stays higher than all solids
 * of a box, and within the box, touches no solid.
 *
 * <p>Heights are those of whole bricks of 4x4x4 voxels, which are found once and then cached.
 * Bricks may share a place of the cache, which the last one keeps. After an edit, {@link #forget}
 * must be called. Haptic thread only; allocates nothing after construction.
 */
public final class SolidHeights {
  /** The most bricks of a box. */
  static final int MOST_BRICKS = 64;

  private static final int SHIFT = BitCube.BRICK_SHIFT;
  private static final int IN_BRICK = (1 << SHIFT) - 1;

  /** The binary logarithm of the most places of the cache, of 16 bytes each. */
  private static final int MOST_PLACES_SHIFT = 15;

  /** The binary logarithm of about how many bricks share a place, in cubes that are not large. */
  private static final int BRICKS_PER_PLACE_SHIFT = 2;

  private final BitCube bits;
  private final BrickPlaces places;
  private final long[] brickAt;
  private final double[] heightAt;

  /**
   * The height that the highest voxel of a row of a brick adds by its x. The index has a bit for
   * each of the 4 voxels.
   */
  private final double[] ofRow = new double[1 << (1 << SHIFT)];

  /** The height that each row of a brick adds by its y and z. */
  private final double[] rowAt = new double[1 << (2 * SHIFT)];

  private double directionX;
  private double directionY;
  private double directionZ;

  /**
   * Creates an empty cache; heights are those along x.
   *
   * @param bits the bit cube, which the caller keeps
   */
  public SolidHeights(BitCube bits) {
    this.bits = bits;
    places = new BrickPlaces(bits, BRICKS_PER_PLACE_SHIFT, MOST_PLACES_SHIFT);
    brickAt = new long[places.count()];
    heightAt = new double[places.count()];
    setDirection(1, 0, 0);
  }

  /** Forgets all heights, after voxels have changed. */
  public void forget() {
    if (places.forget()) {
      Arrays.fill(brickAt, 0);
    }
  }

  /**
   * Sets the direction, grid coordinates, of any length.
   *
   * @param x its x component
   * @param y its y component
   * @param z its z component
   */
  public void setDirection(double x, double y, double z) {
    directionX = x;
    directionY = y;
    directionZ = z;
    for (int voxels = 1; voxels < ofRow.length; voxels++) {
      int last = Integer.SIZE - Integer.numberOfLeadingZeros(voxels);
      ofRow[voxels] = x > 0 ? x * last : x * Integer.numberOfTrailingZeros(voxels);
    }
    for (int row = 0; row < rowAt.length; row++) {
      int j = row & IN_BRICK;
      int k = row >> SHIFT;
      rowAt[row] = y * (y > 0 ? j + 1 : j) + z * (z > 0 ? k + 1 : k);
    }
    forget();
  }

  /**
   * Returns an upper bound of the heights of the closed solid voxels that touch a closed box. It is
   * the height of the highest solid voxel in all bricks with a voxel that touches the box. Without
   * a solid voxel in them it is negative infinity. For more than {@link #MOST_BRICKS} such bricks
   * it is infinity.
   *
   * @param lowX the least x of the box
   * @param lowY the least y of the box
   * @param lowZ the least z of the box
   * @param highX the largest x of the box
   * @param highY the largest y of the box
   * @param highZ the largest z of the box
   * @return the bound
   */
  public double most(
      double lowX, double lowY, double lowZ, double highX, double highY, double highZ) {
    int firstX = firstBrick(lowX);
    int firstY = firstBrick(lowY);
    int firstZ = firstBrick(lowZ);
    int lastX = lastBrick(highX, bits.bricksX());
    int lastY = lastBrick(highY, bits.bricksY());
    int lastZ = lastBrick(highZ, bits.bricksZ());
    if (lastX < firstX || lastY < firstY || lastZ < firstZ) {
      return Double.NEGATIVE_INFINITY;
    }
    long count = (lastX - firstX + 1L) * (lastY - firstY + 1L) * (lastZ - firstZ + 1L);
    if (!(count <= MOST_BRICKS)) {
      return Double.POSITIVE_INFINITY;
    }
    double most = Double.NEGATIVE_INFINITY;
    for (int z = firstZ; z <= lastZ; z++) {
      for (int y = firstY; y <= lastY; y++) {
        for (int x = firstX; x <= lastX; x++) {
          most = Math.max(most, ofBrick(x, y, z));
        }
      }
    }
    return most;
  }

  /** Returns the first brick with a closed voxel that reaches a coordinate; at least 0. */
  private static int firstBrick(double low) {
    return (int) Math.max(0, Math.ceil(low) - 1) >> SHIFT;
  }

  private static int lastBrick(double high, int bricks) {
    return (int) Math.min(bricks - 1.0, Math.floor(high / (1 << SHIFT)));
  }

  private double ofBrick(int x, int y, int z) {
    long brick = places.index(x, y, z);
    long number = places.number(brick);
    int at = places.place(brick);
    if (brickAt[at] != number) {
      brickAt[at] = number;
      heightAt[at] = measured(x, y, z);
    }
    return heightAt[at];
  }

  private double measured(int x, int y, int z) {
    double most = Double.NEGATIVE_INFINITY;
    long rest = bits.brick(x, y, z);
    for (int row = 0; rest != 0; row++) {
      int voxels = (int) rest & ofRow.length - 1;
      if (voxels != 0) {
        most = Math.max(most, ofRow[voxels] + rowAt[row]);
      }
      rest >>>= 1 << SHIFT;
    }
    double corner = directionX * x + directionY * y + directionZ * z;
    return most + corner * (1 << SHIFT);
  }
}
