package org.palpate.collision;

import org.palpate.geometry.GridMetric;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.Vec3;

/**
 * Finds the position at which an interaction point is set free, after a start in a solid or an edit
 * that made its voxel solid. It is the centre of the nearest empty voxel by metric distance. Of
 * equally near voxels it takes the one of lowest index (z first, then y, then x). Voxels outside
 * the grid are empty.
 *
 * <p>Keeps scratch: haptic thread only; allocates nothing. Cost: it looks at bricks in growing
 * cubes around the point, and one comparison passes a full brick or one that is too far away. At a
 * depth of r bricks in a solid it looks at about (2 r)^3 bricks. The cubes grow at most until they
 * contain all solids.
 */
public final class NearestFreeVoxel {
  private static final int BRICK_EDGE = 4;
  private static final double FIRST_CENTRE = 0.5;
  private static final double LAST_CENTRE = BRICK_EDGE - FIRST_CENTRE;

  private final GridMetric metric;
  private final IntBox bounds = new IntBox();
  private final double shortestSpacing;
  private CollisionScene scene;
  private Vec3 from;
  private double leastSquare;
  private int bestI;
  private int bestJ;
  private int bestK;

  /**
   * Creates a search.
   *
   * @param metric the edges of a voxel, by which distances are measured
   */
  public NearestFreeVoxel(GridMetric metric) {
    this.metric = metric;
    shortestSpacing = metric.shortestEdgeMm();
  }

  /**
   * Writes the centre of the nearest free voxel into {@code dest}.
   *
   * @param collisionScene a scene of which a solid touches {@code point}
   * @param point grid coordinates, finite
   * @param dest may be {@code point}
   * @return {@code dest}
   */
  public Vec3 find(CollisionScene collisionScene, Vec3 point, Vec3 dest) {
    scene = collisionScene;
    from = point;
    leastSquare = Double.POSITIVE_INFINITY;
    int brickX = Math.floorDiv((int) Math.floor(point.x), BRICK_EDGE);
    int brickY = Math.floorDiv((int) Math.floor(point.y), BRICK_EDGE);
    int brickZ = Math.floorDiv((int) Math.floor(point.z), BRICK_EDGE);
    int last = lastRing(brickX, brickY, brickZ);
    for (int ring = 0; ring <= last && mayContainNearer(ring); ring++) {
      searchRing(brickX, brickY, brickZ, ring);
    }
    return dest.set(bestI + 0.5, bestJ + 0.5, bestK + 0.5);
  }

  /**
   * Whether a voxel centre in a ring of bricks may be nearer than the best so far, or as near with
   * a lower index. Each such centre is at least {@code leastMm} away along one axis.
   */
  private boolean mayContainNearer(int ring) {
    double leastMm = ((double) BRICK_EDGE * (ring - 1) + 0.5) * shortestSpacing;
    return leastMm <= 0 || leastMm * leastMm <= leastSquare;
  }

  /**
   * Returns the last ring that may contain the nearest free voxel. Beyond the solids all is empty,
   * so it is no farther away than the first voxel beyond them.
   */
  private int lastRing(int brickX, int brickY, int brickZ) {
    scene.bounds(bounds);
    int last = 1;
    last = Math.max(last, farther(brickX, bounds.lowX, bounds.highX));
    last = Math.max(last, farther(brickY, bounds.lowY, bounds.highY));
    return Math.max(last, farther(brickZ, bounds.lowZ, bounds.highZ));
  }

  private static int farther(int brick, int low, int high) {
    return Math.max(
        brick - Math.floorDiv(low - 1, BRICK_EDGE), Math.floorDiv(high + 1, BRICK_EDGE) - brick);
  }

  private void searchRing(int brickX, int brickY, int brickZ, int ring) {
    for (int z = -ring; z <= ring; z++) {
      double nearestZ = nearestCentre(from.z, brickZ + z);
      if (isTooFar(from.x, from.y, nearestZ)) {
        continue;
      }
      for (int y = -ring; y <= ring; y++) {
        double nearestY = nearestCentre(from.y, brickY + y);
        if (isTooFar(from.x, nearestY, nearestZ)) {
          continue;
        }
        boolean onRing = Math.abs(z) == ring || Math.abs(y) == ring;
        int stride = onRing || ring == 0 ? 1 : 2 * ring;
        for (int x = -ring; x <= ring; x += stride) {
          searchBrick(brickX + x, brickY + y, brickZ + z);
        }
      }
    }
  }

  /** Returns the coordinate nearest to {@code from} between the outer voxel centres of a brick. */
  private static double nearestCentre(double from, int brick) {
    double corner = (double) brick * BRICK_EDGE;
    return Math.max(corner + FIRST_CENTRE, Math.min(corner + LAST_CENTRE, from));
  }

  /**
   * Whether a position is farther away than the best voxel. Uses the same formula as {@link
   * #consider}, which is monotonic in each component, rounded or not.
   */
  private boolean isTooFar(double x, double y, double z) {
    return metric.squaredDistance(from.x, from.y, from.z, x, y, z) > leastSquare;
  }

  private void searchBrick(int brickX, int brickY, int brickZ) {
    for (long empty = ~scene.brick(brickX, brickY, brickZ); empty != 0; empty &= empty - 1) {
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
