package org.palpate.proxy.smooth.field;

import org.palpate.collision.CollisionScene;

/**
 * The bits of thin slices, which {@link ShapeInterpolation} interpolates between the slices of
 * voxels. They are made when a window asks for them; nothing is precalculated.
 *
 * <p>The interpolation works on tiles of 4x4 columns between the middles of two slices, see {@link
 * ThinGrid}. Tiles and bricks are cached only to save time. Coordinates (u,v,w) have the long axis
 * last. Cost: a search for the outline in two slices for each column that changes between them.
 */
final class ThinSlices implements BrickSource {
  /** All columns of a tile. */
  private static final int ALL = 0xFFFF;

  private static final int COLUMNS = 16;

  /** The most cells of a pair. */
  private static final int MAX_CELLS = ThinGrid.MAX_PER_VOXEL + 1;

  /** The reach of searches for the outline, in bricks, for each cell of a voxel. */
  private static final double REACH_BRICKS_PER_CELL = 2;

  private static final int MAX_REACH_BRICKS = 7;

  private final ThinGrid grid;
  private final SliceBits slices;
  private final SliceOutline outline;
  private final ShapeInterpolation interpolation;
  private final CacheKeys brickKeys = new CacheKeys();
  private final long[] bricks = new long[CacheKeys.SLOTS];
  private final CacheKeys tileKeys = new CacheKeys();

  /** For each tile and each cell between the two slices, the solid columns. */
  private final char[] tiles = new char[CacheKeys.SLOTS * MAX_CELLS];

  /** Creates the thin slices of a grid whose cells are not voxels. */
  ThinSlices(ThinGrid grid) {
    this.grid = grid;
    int reachBricks =
        Math.min(MAX_REACH_BRICKS, (int) Math.ceil(REACH_BRICKS_PER_CELL * grid.perVoxel()));
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
    int first = 4 * w;
    int pair = grid.pairOf(first);
    int lowW = pair >> 2;
    int highW = (grid.pairOf(first + 3) + 1) >> 2;
    long low = slices.brick(u, v, lowW);
    long high = highW == lowW ? low : slices.brick(u, v, highW);
    if (low == high && (low == 0 || low == -1)) {
      return low;
    }
    long brick = 0;
    for (int n = 0; n < 4; n++) {
      pair = first + n < grid.firstOfPair(pair + 1) ? pair : pair + 1;
      int lower = pixels(pair >> 2 == lowW ? low : high, pair);
      int upper = pixels((pair + 1) >> 2 == lowW ? low : high, pair + 1);
      long columns = lower == upper ? lower : between(u, v, pair, first + n, lower, upper);
      brick |= columns << (COLUMNS * n);
    }
    return brick;
  }

  /** Returns the pixels of a slice, given the brick that holds it. */
  private static int pixels(long brick, int slice) {
    return (int) (brick >>> (COLUMNS * (slice & 3))) & ALL;
  }

  /** Returns the solid columns of a tile in one cell between two slices that differ there. */
  private int between(int u, int v, int pair, int cell, int lower, int upper) {
    int slot = CacheKeys.slot(u, v, pair);
    if (!tileKeys.holdsElseSet(slot, u, v, pair)) {
      fillTile(u, v, pair, lower, upper, MAX_CELLS * slot);
    }
    return tiles[MAX_CELLS * slot + cell - grid.firstOfPair(pair)];
  }

  private void fillTile(int u, int v, int pair, int lower, int upper, int at) {
    outline.coverNear(u, v, pair);
    outline.coverNear(u, v, pair + 1);
    int cells = grid.firstOfPair(pair + 1) - grid.firstOfPair(pair);
    for (int n = 0; n < cells; n++) {
      tiles[at + n] = (char) (lower & upper);
    }
    fillColumns(u, v, pair, 1, lower & ~upper, at);
    fillColumns(u, v, pair, -1, upper & ~lower, at);
  }

  /**
   * Fills the columns that are solid in one slice and empty in the other.
   *
   * @param step 1 if the lower slice is the solid one, else -1
   */
  private void fillColumns(int u, int v, int pair, int step, int columns, int at) {
    int solidSlice = step > 0 ? pair : pair + 1;
    boolean whole = columns == ALL;
    boolean endsInSolid = !whole || outline.isAnyAround(u, v, solidSlice, false);
    boolean endsInEmpty = !whole || outline.isAnyAround(u, v, solidSlice + step, true);
    for (int left = columns; left != 0; left &= left - 1) {
      int column = Integer.numberOfTrailingZeros(left);
      double height =
          interpolation.heightCells(
              4 * u + (column & 3),
              4 * v + (column >> 2),
              solidSlice,
              step,
              endsInSolid,
              endsInEmpty);
      fillColumn(pair, solidSlice, height, 1 << column, at);
    }
  }

  /** Fills the cells whose centres lie nearer than a height to the middle of the solid slice. */
  private void fillColumn(int pair, int solidSlice, double heightCells, int column, int at) {
    int first = grid.firstOfPair(pair);
    int end = grid.firstOfPair(pair + 1);
    for (int cell = first; cell < end; cell++) {
      if (Math.abs(grid.beyondMiddle(cell, solidSlice)) < heightCells) {
        tiles[at + cell - first] |= (char) column;
      }
    }
  }
}
