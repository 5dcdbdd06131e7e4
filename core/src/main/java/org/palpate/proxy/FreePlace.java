package org.palpate.proxy;

import org.palpate.geometry.Vec3;

/**
 * Finds where an interaction point is set free that starts in a solid, or to which a solid came:
 * the centre of the nearest empty voxel, by metric distance, of equals the one of lowest index (z
 * first, then y, then x). Voxels outside the grid are empty.
 *
 * <p>Keeps scratch: haptic thread only. Cost: looks at bricks in growing cubes around the point and
 * passes full ones with one comparison; in a solid of r bricks' depth some (2 r)^3 of them.
 */
public final class FreePlace {
  private static final int BRICK_EDGE = 4;

  private final Metric metric;
  private final double shortestSpacing;
  private Obstacles obstacles;
  private Vec3 from;
  private double leastSquare;
  private int bestI;
  private int bestJ;
  private int bestK;

  /** Measures distances by {@code metric}. */
  public FreePlace(Metric metric) {
    this.metric = metric;
    shortestSpacing = metric.shortestEdgeMm();
  }

  /**
   * Writes the nearest free place into {@code dest}.
   *
   * @param solids the solids, of which one touches {@code point}
   * @param point grid coordinates
   * @param dest may be {@code point}
   */
  public Vec3 find(Obstacles solids, Vec3 point, Vec3 dest) {
    obstacles = solids;
    from = point;
    leastSquare = Double.POSITIVE_INFINITY;
    int brickX = Math.floorDiv((int) Math.floor(point.x), BRICK_EDGE);
    int brickY = Math.floorDiv((int) Math.floor(point.y), BRICK_EDGE);
    int brickZ = Math.floorDiv((int) Math.floor(point.z), BRICK_EDGE);
    for (int ring = 0; mayHoldNearer(ring); ring++) {
      searchRing(brickX, brickY, brickZ, ring);
    }
    return dest.set(bestI + 0.5, bestJ + 0.5, bestK + 0.5);
  }

  /**
   * A voxel's centre in a ring of bricks is at least this far along one axis; equals count, for the
   * lower index.
   */
  private boolean mayHoldNearer(int ring) {
    double leastMm = ((double) BRICK_EDGE * (ring - 1) + 0.5) * shortestSpacing;
    return leastMm <= 0 || leastMm * leastMm <= leastSquare;
  }

  private void searchRing(int brickX, int brickY, int brickZ, int ring) {
    for (int z = -ring; z <= ring; z++) {
      for (int y = -ring; y <= ring; y++) {
        boolean onRing = Math.abs(z) == ring || Math.abs(y) == ring;
        int stride = onRing || ring == 0 ? 1 : 2 * ring;
        for (int x = -ring; x <= ring; x += stride) {
          searchBrick(brickX + x, brickY + y, brickZ + z);
        }
      }
    }
  }

  private void searchBrick(int brickX, int brickY, int brickZ) {
    for (long empty = ~obstacles.brick(brickX, brickY, brickZ); empty != 0; empty &= empty - 1) {
      int bit = Long.numberOfTrailingZeros(empty);
      consider(
          brickX * BRICK_EDGE + (bit & 3),
          brickY * BRICK_EDGE + (bit >> 2 & 3),
          brickZ * BRICK_EDGE + (bit >> 4));
    }
  }

  private void consider(int i, int j, int k) {
    double square = metric.squaredDistance(from.x, from.y, from.z, i + 0.5, j + 0.5, k + 0.5);
    if (square < leastSquare || (square == leastSquare && comesBefore(i, j, k))) {
      leastSquare = square;
      bestI = i;
      bestJ = j;
      bestK = k;
    }
  }

  private boolean comesBefore(int i, int j, int k) {
    if (k != bestK) {
      return k < bestK;
    }
    return j != bestJ ? j < bestJ : i < bestI;
  }
}
