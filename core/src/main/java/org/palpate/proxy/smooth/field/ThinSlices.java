package org.palpate.proxy.smooth.field;

import org.palpate.collision.CollisionScene;

/**
 * The bits of thin slices, which {@link ShapeInterpolation} interpolates between the slices of
 * voxels. They are computed when the field reads a window of them, and not in advance.
 *
 * <p>The interpolation works on tiles of 4x4 columns between the middles of two slices, see {@link
 * ThinGrid}. Tiles and bricks are cached only to save time. Coordinates (u,v,w) have the long axis
 * last. Cost: a search for the outline in two slices for each column that changes between them.
 */
final class ThinSlices implements BrickSource {
  /** All columns of a tile. */
  private static final int ALL = 0xFFFF;

  /** The columns of a tile. */
  static final int COLUMNS = 16;

  /** The most cells of a pair. */
  private static final int MAX_CELLS = ThinGrid.MAX_PER_VOXEL + 1;

  /** The reach of searches for the outline, in bricks, for each cell of a voxel. */
  private static final double REACH_BRICKS_PER_CELL = 2;

  /**
   * The greatest reach, in bricks. With it a window and all that its outlines reach fit into {@link
   * SliceBits}. If they did not, tiles side by side would read the same bricks again and again.
   */
  private static final int MAX_REACH_BRICKS = 6;

  private final ThinGrid grid;
  private final CellPairs pairs;
  private final SliceBits slices;
  private final SliceOutline outline;
  private final ShapeInterpolation interpolation;
  private final CacheKeys brickKeys = new CacheKeys();
  private final long[] bricks = new long[CacheKeys.SLOTS];
  private final CacheKeys tileKeys = new CacheKeys();

  /** For each tile and each cell between the two slices, the solid columns. */
  private final char[] tiles = new char[CacheKeys.SLOTS * MAX_CELLS];

  /** For each column of a tile, the distance to the outline of the solid slice, pixels. */
  private final double[] inside = new double[COLUMNS];

  /** The same for the slice where the column is empty. */
  private final double[] outside = new double[COLUMNS];

  /** The heights of the columns beyond the middle of the solid slice, in cells. */
  private final double[] heights = new double[COLUMNS];

  /** Creates the thin slices of a grid whose cells are not voxels. */
  ThinSlices(ThinGrid grid) {
    this.grid = grid;
    int reachBricks =
        Math.min(MAX_REACH_BRICKS, (int) Math.ceil(REACH_BRICKS_PER_CELL * grid.perVoxel()));
    pairs = new CellPairs(grid);
    slices = new SliceBits(grid.axis());
    outline = new SliceOutline(slices, 4 * reachBricks);
    interpolation = new ShapeInterpolation(outline, grid.perVoxel());
  }

  @Override
  public void forget() {
    slices.forget();
    brickKeys.forget();
    tileKeys.forget();
  }

  @Override
  public long brick(CollisionScene scene, int x, int y, int z) {
    int slot = CacheKeys.slot(x, y, z);
    if (!brickKeys.holdsElseSet(slot, x, y, z)) {
      slices.use(scene);
      bricks[slot] = make(x, y, z);
    }
    return bricks[slot];
  }

  private long make(int x, int y, int z) {
    return switch (grid.axis()) {
      case 0 -> slices.turned(thinBrick(z, y, x));
      case 1 -> slices.turned(thinBrick(x, z, y));
      default -> thinBrick(x, y, z);
    };
  }

  private long thinBrick(int u, int v, int w) {
    int slot = pairs.slotOf(w);
    int lowW = pairs.pair(slot, 0) >> 2;
    int highW = (pairs.pair(slot, 3) + 1) >> 2;
    long low = slices.brick(u, v, lowW);
    long high = highW == lowW ? low : slices.brick(u, v, highW);
    if (low == high && (low == 0 || low == -1)) {
      return low;
    }
    long brick = 0;
    for (int n = 0; n < 4; n++) {
      int pair = pairs.pair(slot, n);
      int lower = pixels(pair >> 2 == lowW ? low : high, pair);
      int upper = pixels((pair + 1) >> 2 == lowW ? low : high, pair + 1);
      long columns =
          lower == upper ? lower : between(u, v, pair, pairs.inPair(slot, n), lower, upper);
      brick |= columns << (COLUMNS * n);
    }
    return brick;
  }

  /** Returns the pixels of a slice, given the brick that holds it. */
  private static int pixels(long brick, int slice) {
    return (int) (brick >>> (COLUMNS * (slice & 3))) & ALL;
  }

  /**
   * Returns the solid columns of a tile in one cell between two slices that differ there.
   *
   * @param inPair the number of the cell between the slices
   */
  private int between(int u, int v, int pair, int inPair, int lower, int upper) {
    int slot = CacheKeys.slot(u, v, pair);
    if (!tileKeys.holdsElseSet(slot, u, v, pair)) {
      fillTile(u, v, pair, lower, upper, MAX_CELLS * slot);
    }
    return tiles[MAX_CELLS * slot + inPair];
  }

  private void fillTile(int u, int v, int pair, int lower, int upper, int at) {
    int first = grid.firstOfPair(pair);
    int cells = grid.firstOfPair(pair + 1) - first;
    for (int n = 0; n < cells; n++) {
      tiles[at + n] = (char) (lower & upper);
    }
    fillColumns(u, v, pair, 1, lower & ~upper, at);
    fillColumns(u, v, pair, -1, upper & ~lower, at);
  }

  /**
   * Fills the columns that are solid in one slice and empty in the other: those cells whose centres
   * lie nearer to the middle of the solid slice than the column is high.
   *
   * @param step 1 if the lower slice is the solid one, else -1
   */
  private void fillColumns(int u, int v, int pair, int step, int columns, int at) {
    if (columns == 0) {
      return;
    }
    int solidSlice = step > 0 ? pair : pair + 1;
    outline.measure(u, v, solidSlice, false, columns, inside);
    outline.measure(u, v, solidSlice + step, true, columns, outside);
    for (int left = columns; left != 0; left &= left - 1) {
      int column = Integer.numberOfTrailingZeros(left);
      heights[column] =
          interpolation.heightCells(
              4 * u + (column & 3),
              4 * v + (column >> 2),
              solidSlice,
              step,
              inside[column],
              outside[column]);
    }
    int first = grid.firstOfPair(pair);
    int cells = grid.firstOfPair(pair + 1) - first;
    for (int n = 0; n < cells; n++) {
      tiles[at + n] |= (char) higher(Math.abs(grid.beyondMiddle(first + n, solidSlice)), columns);
    }
  }

  /** Returns those of some columns that are higher than a number of cells. */
  private int higher(double cells, int columns) {
    int higher = 0;
    for (int left = columns; left != 0; left &= left - 1) {
      int column = Integer.numberOfTrailingZeros(left);
      higher |= heights[column] > cells ? 1 << column : 0;
    }
    return higher;
  }
}
