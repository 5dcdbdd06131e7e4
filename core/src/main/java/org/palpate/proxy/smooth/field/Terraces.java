package org.palpate.proxy.smooth.field;

import org.palpate.collision.CollisionScene;
import org.palpate.geometry.Vec3;

/**
 * Corrections of the cells on wide terraces, where a surface is nearly parallel to a layer of
 * cells.
 *
 * <p>A terrace that is wider than a window looks flat there, even if it stands for a curved or
 * inclined surface. {@link ShapeInterpolation} finds that surface from the outlines around the
 * terrace, as it does between thick slices. A correction is the height of the surface above the
 * terrace, negative if it runs below. The empty cell on the terrace gets the correction.
 *
 * <p>Only whole tiles are corrected: 4x4 columns side by side that are all solid in one layer and
 * empty in the next. Narrow terraces, which the smoothing resolves, have no such tiles, and noise
 * breaks them up. Where no tile is corrected, the field is the same to the bit as without terraces.
 */
final class Terraces implements CellCorrections.Source {
  /** The reach of searches for the outline, in shortest voxel edges. */
  private static final int REACH = 16;

  /** Surfaces are not bent, however long a terrace is: the outlines of two layers give them. */
  private static final double NEVER_BENT = Double.POSITIVE_INFINITY;

  private static final int BRICKS = 64;

  /** The number of the last column of a tile along u or v. */
  private static final int LAST = 3;

  private static final long SOLID = -1;

  /** The cells of a brick's first layer across each axis. */
  private static final long LAYER_X = 0x1111_1111_1111_1111L;

  private static final long LAYER_Y = 0x000F_000F_000F_000FL;
  private static final long LAYER_Z = 0xFFFFL;

  private final BrickCopy copy;
  private final Axis[] axes;

  /** The corrections of each brick of the copy. */
  private final CellCorrections.Slots slots = new CellCorrections.Slots(BRICKS);

  /**
   * Creates the corrections of the cells of a grid.
   *
   * @param cells their bits
   * @param copy a copy of the bits around the window
   * @param edges the edges of a voxel, in shortest edges
   */
  Terraces(ThinGrid grid, BrickSource cells, BrickCopy copy, Vec3 edges) {
    this.copy = copy;
    Vec3 cellEdges = grid.cellEdges(edges);
    axes = new Axis[3 - grid.cuts().size()];
    int count = 0;
    for (int axis = 0; axis < 3; axis++) {
      if (!grid.isCut(axis)) {
        axes[count++] = new Axis(axis, cells, cellEdges);
      }
    }
  }

  @Override
  public void forget() {
    for (Axis axis : axes) {
      axis.slices.forget();
    }
  }

  @Override
  public boolean find(CollisionScene scene, int number, int x, int y, int z) {
    long brick = copy.brick(number);
    boolean mayHaveTerrace =
        brick == 0 ? isBesideWholeLayer(scene, number) : brick != SOLID && hasEmptyLayer(brick);
    return mayHaveTerrace && correct(scene, brick, number, x, y, z);
  }

  /** Whether a layer beside a brick is solid. */
  private boolean isBesideWholeLayer(CollisionScene scene, int number) {
    return isSolid(copy.beside(scene, number, 0, -1), LAYER_X << LAST)
        || isSolid(copy.beside(scene, number, 0, 1), LAYER_X)
        || isSolid(copy.beside(scene, number, 1, -1), LAYER_Y << (4 * LAST))
        || isSolid(copy.beside(scene, number, 1, 1), LAYER_Y)
        || isSolid(copy.beside(scene, number, 2, -1), LAYER_Z << (16 * LAST))
        || isSolid(copy.beside(scene, number, 2, 1), LAYER_Z);
  }

  private static boolean isSolid(long brick, long layer) {
    return (~brick & layer) == 0;
  }

  /** Whether a layer of a brick across any axis is empty. */
  private static boolean hasEmptyLayer(long brick) {
    long alongZ = brick | brick >>> 32;
    alongZ |= alongZ >>> 16;
    long acrossX = alongZ | alongZ >>> 8;
    acrossX |= acrossX >>> 4;
    long alongX = brick | brick >>> 1;
    alongX |= alongX >>> 2;
    long acrossY = alongX | alongX >>> 32;
    acrossY |= acrossY >>> 16;
    long acrossZ = alongX | alongX >>> 4;
    acrossZ |= acrossZ >>> 8;
    return (acrossX & 0xF) != 0xF
        || (acrossY & 0x1111) != 0x1111
        || (acrossZ & 0x0001_0001_0001_0001L) != 0x0001_0001_0001_0001L;
  }

  /** The slots are a ring buffer along each axis, so those of a copy are all different. */
  @Override
  public int slotOf(CollisionScene scene, int x, int y, int z) {
    return BrickCopy.number(x & 3, y & 3, z & 3);
  }

  @Override
  public CellCorrections.Slots slots() {
    return slots;
  }

  /** Cells that the seed does not reach count as solid, and their terraces do not matter. */
  @Override
  public boolean counts(BinaryWindow window, int x, int y, int z) {
    return window.isReached(x, y, z);
  }

  /** Corrects the cells of a brick; returns whether there are any. */
  private boolean correct(CollisionScene scene, long brick, int number, int x, int y, int z) {
    int slot = slotOf(scene, x, y, z);
    slots.clear(slot);
    for (Axis axis : axes) {
      int empty = axis.wholeLayers(~brick);
      if (empty != 0) {
        int solid = axis.wholeLayers(brick) << 1;
        if ((empty & 1) != 0) {
          solid |= axis.isWhole(copy.beside(scene, number, axis.number, -1), LAST) ? 1 : 0;
        }
        if ((empty & 8) != 0) {
          solid |= axis.isWhole(copy.beside(scene, number, axis.number, 1), 0) ? 1 << 5 : 0;
        }
        if ((empty & (solid | solid >> 2)) != 0) {
          axis.slices.use(scene);
          correctTiles(axis, empty, solid, x, y, z, slot);
        }
      }
    }
    return slots.corrected(slot) != 0;
  }

  /**
   * Corrects the cells of a brick that lie on terraces across an axis.
   *
   * @param empty its empty layers, a bit each
   * @param solid the solid layers, from the one below the brick on
   */
  private void correctTiles(Axis axis, int empty, int solid, int x, int y, int z, int slot) {
    int u = axis.number == 0 ? z : x;
    int v = axis.number == 1 ? z : y;
    int w = axis.number == 0 ? x : axis.number == 1 ? y : z;
    for (int n = 0; n < 4; n++) {
      if (((empty & solid) >> n & 1) != 0) {
        correct(axis, u, v, 4 * w + n, 1, slot);
      }
      if (((empty & solid >> 2) >> n & 1) != 0) {
        correct(axis, u, v, 4 * w + n, -1, slot);
      }
    }
  }

  /**
   * Corrects the cells of an empty tile beside a solid one.
   *
   * @param step from the solid one: 1 or -1
   */
  private void correct(Axis axis, int u, int v, int layer, int step, int slot) {
    axis.findHeights(u, v, layer - step, step);
    for (int column = 0; column < ShapeInterpolation.COLUMNS; column++) {
      int correction = CellCorrections.inFractions(axis.heights[column] - 0.5);
      if (correction != 0) {
        // A cell may lie on several terraces, such as in a corner: their corrections add up.
        slots.add(slot, axis.slices.bitOf(column & 3, column >> 2, layer & 3), correction);
      }
    }
  }

  /** The layers of cells across one axis. */
  private static final class Axis {
    /** The columns at the corners of a tile. */
    private static final int CORNERS = 1 | 1 << LAST | 1 << (4 * LAST) | 1 << (5 * LAST);

    private final int number;

    /** The cells of the first layer in the word of a brick. */
    private final long layer;

    /** The distance of neighbouring layers in the word of a brick, bits. */
    private final int stride;

    private final SliceBits slices;
    private final ShapeInterpolation interpolation;

    /** The heights of the surface above the middle of the solid layer, in cells. */
    private final double[] heights = new double[ShapeInterpolation.COLUMNS];

    Axis(int number, BrickSource cells, Vec3 cellEdges) {
      this.number = number;
      stride = 1 << (2 * number);
      layer = number == 0 ? LAYER_X : number == 1 ? LAYER_Y : LAYER_Z;
      slices = new SliceBits(cells, number);
      interpolation =
          new ShapeInterpolation(
              slices, PixelEdges.across(number, cellEdges), REACH, 1, NEVER_BENT);
    }

    /** Returns the layers of a brick whose bits are all set, a bit each. */
    int wholeLayers(long brick) {
      return (isWhole(brick, 0) ? 1 : 0)
          | (isWhole(brick, 1) ? 2 : 0)
          | (isWhole(brick, 2) ? 4 : 0)
          | (isWhole(brick, 3) ? 8 : 0);
    }

    boolean isWhole(long brick, int n) {
      return isSolid(brick, layer << (n * stride));
    }

    /** Finds the heights at the corners of a tile, and the others by linear interpolation. */
    void findHeights(int u, int v, int solidLayer, int step) {
      interpolation.findHeights(u, v, solidLayer, step, CORNERS, heights);
      for (int row = 0; row <= 4 * LAST; row += 4 * LAST) {
        interpolate(row, 1);
      }
      for (int column = 0; column <= LAST; column++) {
        interpolate(column, 4);
      }
    }

    /** Interpolates the two heights between the first and the last one of four. */
    private void interpolate(int first, int stride) {
      double from = heights[first];
      double to = heights[first + LAST * stride];
      heights[first + stride] = from + (to - from) / LAST;
      heights[first + 2 * stride] = to + (from - to) / LAST;
    }
  }
}
