package org.palpate.scene.surface;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.palpate.geometry.IntBox;
import org.palpate.volume.BitCube;

/**
 * Divides the cells of a grid into bricks.
 *
 * <p>Cell (a,b,c) lies between the centres of voxels (a-1,b-1,c-1) and (a,b,c), so its middle has
 * grid coordinates (a,b,c). Cells run from 0 to the grid's size, so that a surface closes at the
 * border.
 *
 * @param edge cells along an edge of a brick
 * @param bricksX number of bricks along x
 * @param bricksY number of bricks along y
 * @param bricksZ number of bricks along z
 */
public record BrickLayout(int edge, int bricksX, int bricksY, int bricksZ) {

  /** Returns the layout of the bricks that cover a cube. */
  public static BrickLayout of(BitCube bits, int edge) {
    return new BrickLayout(
        edge, bricks(bits.sizeX(), edge), bricks(bits.sizeY(), edge), bricks(bits.sizeZ(), edge));
  }

  private static int bricks(int size, int edge) {
    return size / edge + 1;
  }

  /** Returns the number of bricks. */
  public int count() {
    return bricksX * bricksY * bricksZ;
  }

  /** Returns the position of a brick along x, in bricks. */
  public int x(int brick) {
    return brick % bricksX;
  }

  /** Returns the position of a brick along y, in bricks. */
  public int y(int brick) {
    return brick / bricksX % bricksY;
  }

  /** Returns the position of a brick along z, in bricks. */
  public int z(int brick) {
    return brick / bricksX / bricksY;
  }

  /** Returns the number of the brick at a position in bricks. */
  int brick(int x, int y, int z) {
    return (z * bricksY + y) * bricksX + x;
  }

  /** Writes the box of a brick's cells into {@code dest}; it may reach beyond the grid. */
  IntBox cellsOf(int brick, IntBox dest) {
    dest.lowX = edge * x(brick);
    dest.lowY = edge * y(brick);
    dest.lowZ = edge * z(brick);
    dest.highX = dest.lowX + edge - 1;
    dest.highY = dest.lowY + edge - 1;
    dest.highZ = dest.lowZ + edge - 1;
    return dest;
  }

  /** Returns the bricks that have cells of a box within the grid. */
  int[] bricksOf(IntBox cells) {
    return IntStream.rangeClosed(cells.lowZ / edge, cells.highZ / edge)
        .flatMap(
            z ->
                IntStream.rangeClosed(cells.lowY / edge, cells.highY / edge)
                    .flatMap(
                        y ->
                            IntStream.rangeClosed(cells.lowX / edge, cells.highX / edge)
                                .map(x -> brick(x, y, z))))
        .toArray();
  }

  /** Divides a box of cells evenly into boxes of at most {@code most} cells along each axis. */
  static List<IntBox> parts(IntBox cells, int most) {
    if (cells.isEmpty()) {
      return List.of();
    }
    List<IntBox> parts = new ArrayList<>();
    int[] x = bounds(cells.lowX, cells.highX, most);
    int[] y = bounds(cells.lowY, cells.highY, most);
    int[] z = bounds(cells.lowZ, cells.highZ, most);
    for (int c = 1; c < z.length; c++) {
      for (int b = 1; b < y.length; b++) {
        for (int a = 1; a < x.length; a++) {
          IntBox part = new IntBox();
          part.include(x[a - 1], y[b - 1], z[c - 1]);
          part.include(x[a] - 1, y[b] - 1, z[c] - 1);
          parts.add(part);
        }
      }
    }
    return parts;
  }

  /** Returns the first position of each part, and the one after the last part. */
  private static int[] bounds(int low, int high, int most) {
    int size = high - low + 1;
    int count = (size + most - 1) / most;
    return IntStream.rangeClosed(0, count).map(n -> low + n * size / count).toArray();
  }
}
