package org.palpate.force.guide;

import java.util.Arrays;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/**
 * Distances from a segment, up to a reach, as a continuous function of the position. The middle of
 * each voxel has its exact distance from the nearest solid voxel, as a closed box; between the
 * middles distances are interpolated linearly along each axis.
 *
 * <p>Describes the segment as it was when this was made. Immutable; any thread.
 */
public final class SegmentDistance {
  /** The most voxels whose distances are kept: 128 MiB. */
  public static final long MOST_VOXELS = 1L << 25;

  private static final int NO_BODY = -1;

  private final VoxelGrid grid;
  private final int body;

  /** The greatest distance that is kept, mm. */
  private final double mostMm;

  private final int lowX;
  private final int lowY;
  private final int lowZ;
  private final int sizeX;
  private final int sizeY;
  private final int sizeZ;

  /** Distances of the middles of voxels, mm, x first; at most {@link #mostMm}. */
  private final float[] distances;

  /**
   * Measures distances from a segment that stays at rest.
   *
   * @param solids the voxels of the segment; they may change afterwards
   * @param grid the grid of the segment
   * @param reachMm the largest distance that is measured, mm
   * @see #SegmentDistance(BitCube, VoxelGrid, double, int)
   */
  public SegmentDistance(BitCube solids, VoxelGrid grid, double reachMm) {
    this(solids, grid, reachMm, NO_BODY);
  }

  /**
   * Measures distances. Cost: the voxels of the box times the reach in voxels.
   *
   * @param solids the voxels of the segment
   * @param grid the grid of the segment
   * @param reachMm the largest distance that is measured, mm; larger ones count as at most that
   *     plus the longest voxel edge
   * @param body the index of the body that the segment is, whose pose it follows; negative if it
   *     stays at rest
   * @throws IllegalArgumentException if {@link #voxelsFor} exceeds {@link #MOST_VOXELS}
   */
  public SegmentDistance(BitCube solids, VoxelGrid grid, double reachMm, int body) {
    double voxels = voxelsFor(solids, grid, reachMm);
    mostMm = mostMm(grid, reachMm);
    if (!(voxels <= MOST_VOXELS)) {
      throw new IllegalArgumentException(
          "distances of at most " + MOST_VOXELS + " voxels can be kept: voxels=" + voxels);
    }
    this.grid = grid;
    this.body = body;
    IntBox box = solids.bounds();
    Vec3 spacing = grid.spacingMm();
    boolean isEmpty = box.isEmpty();
    lowX = isEmpty ? 0 : box.lowX - pad(mostMm, spacing.x);
    lowY = isEmpty ? 0 : box.lowY - pad(mostMm, spacing.y);
    lowZ = isEmpty ? 0 : box.lowZ - pad(mostMm, spacing.z);
    sizeX = isEmpty ? 0 : box.highX + pad(mostMm, spacing.x) - lowX + 1;
    sizeY = isEmpty ? 0 : box.highY + pad(mostMm, spacing.y) - lowY + 1;
    sizeZ = isEmpty ? 0 : box.highZ + pad(mostMm, spacing.z) - lowZ + 1;
    distances = new float[sizeX * sizeY * sizeZ];
    measure(solids);
  }

  /**
   * {@return the number of voxels whose distances are kept; may exceed {@link #MOST_VOXELS}}
   *
   * @param solids the voxels of the segment
   * @param grid the grid of the segment
   * @param reachMm the largest distance that is measured, mm
   */
  public static double voxelsFor(BitCube solids, VoxelGrid grid, double reachMm) {
    IntBox box = solids.bounds();
    Vec3 spacing = grid.spacingMm();
    double mostMm = mostMm(grid, reachMm);
    return box.isEmpty()
        ? 0
        : (box.highX - box.lowX + 1 + 2.0 * pad(mostMm, spacing.x))
            * (box.highY - box.lowY + 1 + 2.0 * pad(mostMm, spacing.y))
            * (box.highZ - box.lowZ + 1 + 2.0 * pad(mostMm, spacing.z));
  }

  /**
   * Returns the greatest distance that is kept: between middles of voxels all up to the reach
   * count.
   */
  private static double mostMm(VoxelGrid grid, double reachMm) {
    Vec3 spacing = grid.spacingMm();
    return reachMm + Math.max(spacing.x, Math.max(spacing.y, spacing.z));
  }

  /**
   * Returns the voxels by which the box reaches beyond the segment. The last one is as far away as
   * the greatest distance that is kept.
   */
  private static int pad(double mostMm, double spacingMm) {
    return (int) Math.min(1 << 20, Math.ceil(mostMm / spacingMm) + 2);
  }

  /** Writes squared distances along x, extends them along y and z, and takes their roots. */
  private void measure(BitCube solids) {
    float most = (float) (mostMm * mostMm);
    Arrays.fill(distances, most);
    for (int index = 0; index < distances.length; index++) {
      int i = lowX + index % sizeX;
      int j = lowY + index / sizeX % sizeY;
      int k = lowZ + index / sizeX / sizeY;
      if (grid.contains(i, j, k) && solids.get(i, j, k)) {
        distances[index] = 0;
      }
    }
    extend(sizeX, 1, grid.spacingMm().x);
    extend(sizeY, sizeX, grid.spacingMm().y);
    extend(sizeZ, sizeX * sizeY, grid.spacingMm().z);
    for (int index = 0; index < distances.length; index++) {
      distances[index] = (float) Math.sqrt(distances[index]);
    }
  }

  /** Extends squared distances along every line of an axis. */
  private void extend(int size, int stride, double spacingMm) {
    int reach = pad(mostMm, spacingMm);
    float[] squares = new float[reach + 1];
    for (int n = 1; n <= reach; n++) {
      squares[n] = (float) ((n - 0.5) * spacingMm * ((n - 0.5) * spacingMm));
    }
    float[] line = new float[size];
    for (int first = 0; first < distances.length; first++) {
      if (first / stride % size == 0) {
        for (int n = 0; n < size; n++) {
          line[n] = distances[first + n * stride];
        }
        for (int n = 0; n < size; n++) {
          distances[first + n * stride] = nearest(line, n, squares);
        }
      }
    }
  }

  private static float nearest(float[] line, int at, float[] squares) {
    float least = line[at];
    for (int n = 1; n < squares.length && squares[n] < least; n++) {
      float before = at - n >= 0 ? line[at - n] : Float.MAX_VALUE;
      float after = at + n < line.length ? line[at + n] : Float.MAX_VALUE;
      least = Math.min(least, squares[n] + Math.min(before, after));
    }
    return least;
  }

  /**
   * {@return the distance at a position, mm, at most the reach plus the longest voxel edge}
   *
   * @param x the position along x, grid coordinates
   * @param y its y component
   * @param z its z component
   */
  public double at(double x, double y, double z) {
    double u = x - 0.5 - lowX;
    double v = y - 0.5 - lowY;
    double w = z - 0.5 - lowZ;
    if (!(u >= 0 && u < sizeX - 1 && v >= 0 && v < sizeY - 1 && w >= 0 && w < sizeZ - 1)) {
      return mostMm;
    }
    int i = (int) u;
    int j = (int) v;
    int k = (int) w;
    int index = (k * sizeY + j) * sizeX + i;
    double low = plane(index, u - i, v - j);
    double high = plane(index + sizeX * sizeY, u - i, v - j);
    return low + (w - k) * (high - low);
  }

  private double plane(int index, double u, double v) {
    double low = distances[index] + u * (distances[index + 1] - distances[index]);
    int next = index + sizeX;
    double high = distances[next] + u * (distances[next + 1] - distances[next]);
    return low + v * (high - low);
  }

  /**
   * Writes the direction in which the distance grows, along the grid's axes, at most 1 long. It
   * changes continuously with the position, and is short where directions meet.
   *
   * @param gridPosition the position, grid coordinates
   * @param dest receives the direction; may be {@code gridPosition}
   */
  public void gradient(Vec3 gridPosition, Vec3 dest) {
    double x = gridPosition.x;
    double y = gridPosition.y;
    double z = gridPosition.z;
    Vec3 spacing = grid.spacingMm();
    dest.set(
        (at(x + 0.5, y, z) - at(x - 0.5, y, z)) / spacing.x,
        (at(x, y + 0.5, z) - at(x, y - 0.5, z)) / spacing.y,
        (at(x, y, z + 0.5) - at(x, y, z - 0.5)) / spacing.z);
    double length = dest.length();
    dest.mul(length > 1 ? 1 / length : 1, dest);
  }

  /** {@return the index of the body that the segment is; negative if it stays at rest} */
  public int body() {
    return body;
  }

  /** {@return the grid of the segment} */
  public VoxelGrid grid() {
    return grid;
  }
}
