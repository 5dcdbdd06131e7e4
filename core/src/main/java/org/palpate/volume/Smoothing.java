package org.palpate.volume;

import java.util.ArrayList;
import java.util.List;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.Vec3;

/**
 * Smooths voxels by a morphological opening and then a closing with a ball. The opening removes
 * what is thinner than the ball, and the closing fills gaps that are narrower. Voxels outside the
 * grid have no influence.
 *
 * <p>Reference: Serra, Image Analysis and Mathematical Morphology, 1982.
 *
 * <p>Any thread, on bits that no other thread changes. Cost: the voxels of the box times those of
 * the ball, four times.
 */
public final class Smoothing {
  private final GridMetric metric;
  private final int[][] ball;
  private final int reach;

  /**
   * Creates a smoothing.
   *
   * @param metric the edges of a voxel
   * @param radiusMm the radius of the ball, mm, at least 0
   */
  public Smoothing(GridMetric metric, double radiusMm) {
    this.metric = metric;
    List<int[]> offsets = new ArrayList<>();
    int reachX = (int) (radiusMm / metric.spacingX());
    int reachY = (int) (radiusMm / metric.spacingY());
    int reachZ = (int) (radiusMm / metric.spacingZ());
    for (int k = -reachZ; k <= reachZ; k++) {
      for (int j = -reachY; j <= reachY; j++) {
        for (int i = -reachX; i <= reachX; i++) {
          if (metric.squaredDistance(0, 0, 0, i, j, k) <= radiusMm * radiusMm) {
            offsets.add(new int[] {i, j, k});
          }
        }
      }
    }
    ball = offsets.toArray(new int[0][]);
    reach = Math.max(reachX, Math.max(reachY, reachZ));
  }

  /**
   * {@return a copy in which the voxels whose centres lie within a ball are those of the smooth
   * solid} The others are unchanged.
   *
   * @param bits the solid to smooth; not changed
   * @param centreGrid the centre of the ball, grid coordinates, finite
   * @param withinMm its radius, mm
   */
  public BitCube smoothed(BitCube bits, Vec3 centreGrid, double withinMm) {
    IntBox box = new IntBox();
    box.include(
        (int) Math.floor(centreGrid.x - withinMm / metric.spacingX()),
        (int) Math.floor(centreGrid.y - withinMm / metric.spacingY()),
        (int) Math.floor(centreGrid.z - withinMm / metric.spacingZ()));
    box.include(
        (int) Math.floor(centreGrid.x + withinMm / metric.spacingX()),
        (int) Math.floor(centreGrid.y + withinMm / metric.spacingY()),
        (int) Math.floor(centreGrid.z + withinMm / metric.spacingZ()));
    BitCube eroded = filtered(bits, box, 3, true);
    BitCube opened = filtered(eroded, box, 2, false);
    BitCube grown = filtered(opened, box, 1, false);
    BitCube closed = filtered(grown, box, 0, true);
    BitCube result = bits.copy();
    Vec3 c = centreGrid;
    forEach(
        bits,
        box,
        (i, j, k) -> {
          double square = metric.squaredDistance(c.x, c.y, c.z, i + 0.5, j + 0.5, k + 0.5);
          if (square <= withinMm * withinMm) {
            put(result, i, j, k, closed.get(i, j, k));
          }
        });
    return result;
  }

  /** Returns an erosion or a dilation. It is valid in the box, grown by a number of reaches. */
  private BitCube filtered(BitCube bits, IntBox box, int reaches, boolean erodes) {
    BitCube result = new BitCube(bits.sizeX(), bits.sizeY(), bits.sizeZ());
    IntBox grown = new IntBox().set(box).grow(reaches * reach);
    forEach(
        bits,
        grown,
        (i, j, k) -> {
          if (hasInBall(bits, i, j, k, !erodes) != erodes) {
            result.set(i, j, k);
          }
        });
    return result;
  }

  /** Whether the ball around a voxel has a voxel of the grid that is solid or empty, as asked. */
  private boolean hasInBall(BitCube bits, int i, int j, int k, boolean solid) {
    for (int[] offset : ball) {
      int x = i + offset[0];
      int y = j + offset[1];
      int z = k + offset[2];
      boolean inGrid =
          x >= 0 && x < bits.sizeX() && y >= 0 && y < bits.sizeY() && z >= 0 && z < bits.sizeZ();
      if (inGrid && bits.get(x, y, z) == solid) {
        return true;
      }
    }
    return false;
  }

  private static void put(BitCube bits, int i, int j, int k, boolean solid) {
    if (solid) {
      bits.set(i, j, k);
    } else {
      bits.clear(i, j, k);
    }
  }

  private static void forEach(BitCube grid, IntBox box, BitCube.VoxelSink sink) {
    for (int k = Math.max(0, box.lowZ); k <= Math.min(grid.sizeZ() - 1, box.highZ); k++) {
      for (int j = Math.max(0, box.lowY); j <= Math.min(grid.sizeY() - 1, box.highY); j++) {
        for (int i = Math.max(0, box.lowX); i <= Math.min(grid.sizeX() - 1, box.highX); i++) {
          sink.take(i, j, k);
        }
      }
    }
  }
}
