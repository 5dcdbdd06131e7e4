package org.palpate.proxy.smooth.field;

import org.palpate.collision.CollisionScene;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.Vec3;

/**
 * The bits of thin slices, which {@link ShapeInterpolation} interpolates between the slices of
 * voxels. They are computed when the field reads a window of them, and not in advance.
 *
 * <p>The interpolation works on tiles of 4x4 columns between the middles of two slices, see {@link
 * AxisCut}. Tiles and bricks are cached only to save time. Coordinates (u,v,w) have the long axis
 * last. Cost: a search for the outline in two slices for each column that changes between them.
 */
final class ThinSlices implements BrickSource, CellCorrections.Source {
  /**
   * The least length of a terrace whose bend counts, in pixels. On shorter ones outlines are too
   * rough to show a bend, and a search for two more of them is not worth its time.
   */
  private static final double MIN_BENT_PIXELS = 4;

  private static final int COLUMNS = ShapeInterpolation.COLUMNS;

  /**
   * The cached bricks along each axis. A hand rubs over the same place again and again, and a brick
   * takes long to make.
   */
  private static final int BRICKS = 32;

  /** The cached tiles along each axis. They serve the bricks of one column. */
  private static final int TILES = 16;

  /** The farthest that the centre of a cell lies from a middle that it holds, with a margin. */
  private static final double MIDDLE_CELL = 0.5 + 1e-6;

  /** The most cells of a pair. */
  private static final int MAX_CELLS = ThinGrid.MAX_PER_VOXEL + 1;

  /**
   * A pair depends on its slices and the next one on either side: two on each side of its middle.
   */
  private static final int SLICES_AROUND_PAIR = 2;

  /** The reach of searches for the outline, in bricks, for each cell of a voxel. */
  private static final double REACH_BRICKS_PER_CELL = 2;

  /**
   * The greatest reach, in bricks. With it a window and all that its outlines reach fit into {@link
   * SliceBits}. If they did not, tiles side by side would read the same bricks again and again.
   */
  private static final int MAX_REACH_BRICKS = 6;

  /**
   * The greatest reach of a second cut, in bricks. Each brick that it reads has to be made by the
   * first one, so a wider reach makes rare frames several times as long. A reach of 2 doubles the
   * error on a torus of 1:3:2, and one of 6 hardly changes it.
   */
  private static final int MAX_REACH_BRICKS_OF_SECOND = 3;

  private final AxisCut cut;
  private final BrickSource source;

  /** The heights between which the centres of solid cells end, see {@link #roundedHeight}. */
  private final double leastHeight;

  private final double mostHeight;

  private final CellPairs pairs;
  private final SliceBits slices;
  private final ShapeInterpolation interpolation;
  private final CacheKeys brickKeys = new CacheKeys(BRICKS);
  private final long[] bricks = new long[brickKeys.slots()];
  private final CacheKeys tileKeys = new CacheKeys(TILES);

  /** For each tile and each cell between the two slices, the solid columns. */
  private final char[] tiles = new char[tileKeys.slots() * MAX_CELLS];

  /** The heights of the columns beyond the middle of the solid slice, in cells. */
  private final double[] heights = new double[COLUMNS];

  /** For each tile and column, the number of the cell between the slices that is corrected. */
  private final byte[] correctedCells = new byte[tileKeys.slots() * COLUMNS];

  /** The occupancy of that cell less its bit, in {@link CellCorrections#FRACTIONS}. */
  private final byte[] columnCorrections = new byte[tileKeys.slots() * COLUMNS];

  /** For each tile, the pixels around it that decided about its columns, at most 127. */
  private final byte[] decidingPixels = new byte[tileKeys.slots()];

  /** The tiles, at (u,v,pair), that changed voxels may reach: scratch. */
  private final IntBox reachedTiles = new IntBox();

  /** The bricks that they may reach: scratch. */
  private final IntBox reachedBricks = new IntBox();

  /** Whether anyone asks for corrections. */
  private final boolean corrects;

  /** The corrections of each brick. */
  private final CellCorrections.Slots slots;

  /** The columns that this cut has interpolated so far. */
  private long columns;

  /**
   * Creates the thin slices of one cut.
   *
   * @param source the voxels, or what an earlier cut along another axis made of them
   * @param edges the edges of what is cut, in shortest voxel edges
   * @param maxReachBricks the greatest reach of searches for the outline
   * @param isLast whether no other cut divides the cells
   * @param corrects whether anyone asks for corrections
   */
  private ThinSlices(
      AxisCut cut,
      BrickSource source,
      Vec3 edges,
      int maxReachBricks,
      boolean isLast,
      boolean corrects) {
    this.cut = cut;
    this.corrects = corrects;
    slots = new CellCorrections.Slots(corrects ? brickKeys.slots() : 0);
    this.source = source;
    leastHeight = isLast ? MIDDLE_CELL : 0;
    mostHeight = isLast ? cut.perVoxel() - MIDDLE_CELL : cut.perVoxel();
    pairs = new CellPairs(cut);
    slices = new SliceBits(source, cut.axis());
    int reach = reach(cut, maxReachBricks);
    interpolation =
        new ShapeInterpolation(
            slices, PixelEdges.across(cut.axis(), edges), reach, cut.perVoxel(), MIN_BENT_PIXELS);
  }

  /**
   * Returns the thin slices of a grid with at least one cut. The first cut divides the voxels, and
   * the second divides the cells of the first.
   *
   * @param corrects whether it is a source of corrections as well; without them it takes less time
   */
  static ThinSlices of(ThinGrid grid, Vec3 edges, boolean corrects) {
    BrickSource source = new BrickSource.BoundedVoxels();
    ThinSlices slices = null;
    int maxReachBricks = MAX_REACH_BRICKS;
    Vec3 left = new Vec3().set(edges);
    for (AxisCut cut : grid.cuts()) {
      boolean isLast = cut.equals(grid.cuts().get(grid.cuts().size() - 1));
      slices = new ThinSlices(cut, source, left, maxReachBricks, isLast, corrects && isLast);
      source = slices;
      maxReachBricks = MAX_REACH_BRICKS_OF_SECOND;
      left.set(cut.axis(), left.get(cut.axis()) / cut.perVoxel());
    }
    return slices;
  }

  /** Returns the reach of searches for the outline of a cut's slices, in shortest voxel edges. */
  private static int reach(AxisCut cut, int maxBricks) {
    return 4 * Math.min(maxBricks, (int) Math.ceil(REACH_BRICKS_PER_CELL * cut.perVoxel()));
  }

  /** Returns the columns that this cut and earlier ones have interpolated so far. */
  @Override
  public long columns() {
    return columns + source.columns();
  }

  @Override
  public void forget() {
    slices.forget();
    brickKeys.forget();
    tileKeys.forget();
  }

  /**
   * Tiles that no changed voxel decides about stay. All bricks within reach are put together anew,
   * from tiles that stayed where possible, because a brick may outlive its tiles in the cache.
   */
  @Override
  public void forget(IntBox changed) {
    slices.forget(changed);
    setReached(changed);
    forgetTiles(changed);
    brickKeys.forget(reachedBricks);
    for (int axis = 0; axis < 3; axis++) {
      changed.setRange(axis, 4 * reachedBricks.low(axis), 4 * reachedBricks.high(axis) + 3);
    }
  }

  /** Finds the tiles and the bricks that changed cells of the source may reach. */
  private void setReached(IntBox changed) {
    setReachedAcross(0, slices.axisU(), changed);
    setReachedAcross(1, slices.axisV(), changed);
    int lowPair = changed.low(cut.axis()) - SLICES_AROUND_PAIR;
    int highPair = changed.high(cut.axis()) + SLICES_AROUND_PAIR - 1;
    reachedTiles.setRange(2, lowPair, highPair);
    int highCell = cut.firstOfPair(highPair + 1) - 1;
    reachedBricks.setRange(cut.axis(), cut.firstOfPair(lowPair) >> 2, highCell >> 2);
  }

  /**
   * Sets the range of tiles and bricks along u or v.
   *
   * @param number 0 for u, 1 for v
   * @param axis the axis along which it runs
   */
  private void setReachedAcross(int number, int axis, IntBox changed) {
    int low = (changed.low(axis) >> 2) - interpolation.reachBricks();
    int high = (changed.high(axis) >> 2) + interpolation.reachBricks();
    reachedTiles.setRange(number, low, high);
    reachedBricks.setRange(axis, low, high);
  }

  /** Forgets the tiles within reach that depend on changed voxels. */
  private void forgetTiles(IntBox changed) {
    if (CacheKeys.isLarge(reachedTiles)) {
      tileKeys.forget();
      return;
    }
    for (int pair = reachedTiles.lowZ; pair <= reachedTiles.highZ; pair++) {
      for (int v = reachedTiles.lowY; v <= reachedTiles.highY; v++) {
        for (int u = reachedTiles.lowX; u <= reachedTiles.highX; u++) {
          int slot = tileKeys.slot(u, v, pair);
          if (tileKeys.holds(slot, u, v, pair) && dependsOn(changed, u, v, decidingPixels[slot])) {
            tileKeys.forget(slot);
          }
        }
      }
    }
  }

  /**
   * Whether a changed cell may decide about a tile.
   *
   * @param pixels how many pixels around the tile decide about it
   */
  private boolean dependsOn(IntBox changed, int u, int v, int pixels) {
    return 4 * u - pixels <= changed.high(slices.axisU())
        && 4 * u + 3 + pixels >= changed.low(slices.axisU())
        && 4 * v - pixels <= changed.high(slices.axisV())
        && 4 * v + 3 + pixels >= changed.low(slices.axisV());
  }

  /** The corrections are forgotten with the cells to which they belong. */
  @Override
  public void forgetAround(IntBox cells) {}

  @Override
  public long brick(CollisionScene scene, int x, int y, int z) {
    return bricks[slotOf(scene, x, y, z)];
  }

  @Override
  public boolean areSolid(CollisionScene scene, int x, int y, int z, long cells) {
    if (!brickKeys.holds(brickKeys.slot(x, y, z), x, y, z)) {
      slices.use(scene);
      if ((~possiblySolid(x, y, z) & cells) != 0) {
        return false;
      }
    }
    return (~brick(scene, x, y, z) & cells) == 0;
  }

  /** Returns the slot that holds a brick and its corrections until another one is asked for. */
  @Override
  public int slotOf(CollisionScene scene, int x, int y, int z) {
    int slot = brickKeys.slot(x, y, z);
    if (!brickKeys.holdsElseSet(slot, x, y, z)) {
      slices.use(scene);
      if (corrects) {
        slots.clear(slot);
      }
      bricks[slot] = make(x, y, z, slot);
    }
    return slot;
  }

  @Override
  public boolean find(CollisionScene scene, int number, int x, int y, int z) {
    return slots.corrected(slotOf(scene, x, y, z)) != 0;
  }

  @Override
  public CellCorrections.Slots slots() {
    return slots;
  }

  /**
   * Whether the seed reaches the cell or one beside it along the last cut. Otherwise its empty part
   * counts as solid, like empty cells that the seed does not reach.
   */
  @Override
  public boolean counts(BinaryWindow window, int x, int y, int z) {
    return window.isBesideReached(x, y, z, cut.axis());
  }

  private long make(int x, int y, int z, int slot) {
    return switch (cut.axis()) {
      case 0 -> slices.turned(thinBrick(z, y, x, slot));
      case 1 -> slices.turned(thinBrick(x, z, y, slot));
      default -> thinBrick(x, y, z, slot);
    };
  }

  /** Returns the cells of a brick that may be solid, as far as is known without interpolation. */
  private long possiblySolid(int x, int y, int z) {
    return switch (cut.axis()) {
      case 0 -> slices.turned(betweenSolid(z, y, x));
      case 1 -> slices.turned(betweenSolid(x, z, y));
      default -> betweenSolid(x, y, z);
    };
  }

  /** Returns the cells of a brick that lie between two pixels of which one is solid, or both. */
  private long betweenSolid(int u, int v, int w) {
    int slot = pairs.slotOf(w);
    int lowW = pairs.pair(slot, 0) >> 2;
    int highW = (pairs.pair(slot, 3) + 1) >> 2;
    long low = slices.brick(u, v, lowW);
    long high = highW == lowW ? low : slices.brick(u, v, highW);
    long brick = 0;
    for (int n = 0; n < 4; n++) {
      int pair = pairs.pair(slot, n);
      int lower = SliceBits.pixels(pair >> 2 == lowW ? low : high, pair);
      int upper = SliceBits.pixels((pair + 1) >> 2 == lowW ? low : high, pair + 1);
      brick |= (long) (lower | upper) << (COLUMNS * n);
    }
    return brick;
  }

  private long thinBrick(int u, int v, int w, int to) {
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
      int lower = SliceBits.pixels(pair >> 2 == lowW ? low : high, pair);
      int upper = SliceBits.pixels((pair + 1) >> 2 == lowW ? low : high, pair + 1);
      int columns = lower;
      if (lower != upper) {
        int tile = tileOf(u, v, pair, lower, upper);
        columns = tiles[MAX_CELLS * tile + pairs.inPair(slot, n)];
        if (corrects) {
          correct(tile, pairs.inPair(slot, n), lower ^ upper, n, to);
        }
      }
      brick |= (long) columns << (COLUMNS * n);
    }
    return brick;
  }

  /** Writes the corrections of a brick's layer, those of one cell of a tile. */
  private void correct(int tile, int inPair, int columns, int layer, int to) {
    for (int left = columns; left != 0; left &= left - 1) {
      int column = Integer.numberOfTrailingZeros(left);
      int correction = columnCorrections[COLUMNS * tile + column];
      if (correctedCells[COLUMNS * tile + column] == inPair && correction != 0) {
        slots.add(to, slices.bitOf(column & 3, column >> 2, layer), correction);
      }
    }
  }

  /** Returns the slot that holds a tile between two slices that differ there. */
  private int tileOf(int u, int v, int pair, int lower, int upper) {
    int slot = tileKeys.slot(u, v, pair);
    if (!tileKeys.holdsElseSet(slot, u, v, pair)) {
      fillTile(u, v, pair, lower, upper, slot);
    }
    return slot;
  }

  private void fillTile(int u, int v, int pair, int lower, int upper, int slot) {
    int first = cut.firstOfPair(pair);
    int cells = cut.firstOfPair(pair + 1) - first;
    for (int n = 0; n < cells; n++) {
      tiles[MAX_CELLS * slot + n] = (char) (lower & upper);
    }
    decidingPixels[slot] = 0;
    fillColumns(u, v, pair, 1, lower & ~upper, slot);
    fillColumns(u, v, pair, -1, upper & ~lower, slot);
  }

  /**
   * Fills the columns that are solid in one slice and empty in the other: those cells whose centres
   * lie nearer to the middle of the solid slice than the column is high, see {@link
   * #roundedHeight}.
   *
   * @param step 1 if the lower slice is the solid one, else -1
   */
  private void fillColumns(int u, int v, int pair, int step, int columns, int slot) {
    if (columns == 0) {
      return;
    }
    int solidSlice = step > 0 ? pair : pair + 1;
    interpolation.findHeights(u, v, solidSlice, step, columns, heights);
    this.columns += Integer.bitCount(columns);
    decidingPixels[slot] = (byte) Math.max(decidingPixels[slot], interpolation.decidingPixels());
    int first = cut.firstOfPair(pair);
    int cells = cut.firstOfPair(pair + 1) - first;
    for (int n = 0; n < cells; n++) {
      tiles[MAX_CELLS * slot + n] |=
          (char) higher(Math.abs(cut.beyondMiddle(first + n, solidSlice)), columns);
    }
    for (int left = corrects ? columns : 0; left != 0; left &= left - 1) {
      int column = Integer.numberOfTrailingZeros(left);
      noteCorrection(column, first, cells, solidSlice, step, slot);
    }
  }

  /**
   * Notes by how much the solid part of a column is longer than its solid cells, and the cell at
   * their end that makes up for it: of the cells between the two slices the first empty one or the
   * last solid one.
   */
  private void noteCorrection(
      int column, int first, int cells, int solidSlice, int step, int slot) {
    double height = heights[column];
    double roundedHeight = roundedHeight(height);
    int nearest = step > 0 ? first : first + cells - 1;
    int solid = 0;
    while (solid < cells
        && Math.abs(cut.beyondMiddle(nearest + step * solid, solidSlice)) < roundedHeight) {
      solid++;
    }
    double beyond = step * cut.beyondMiddle(nearest, solidSlice) - 0.5;
    int correction = CellCorrections.inFractions(height - beyond - solid);
    int corrected = correction > 0 ? Math.min(solid, cells - 1) : Math.max(solid - 1, 0);
    int at = COLUMNS * slot + column;
    columnCorrections[at] = (byte) correction;
    correctedCells[at] = (byte) (step > 0 ? corrected : cells - 1 - corrected);
  }

  /**
   * Returns the height below which the centres of solid cells lie. In the last cut, the cell that
   * holds the middle of what is cut keeps its bit, and its correction makes up for that. So if
   * voxels are cut along one axis, an empty voxel has an empty cell, from which a flood fill can
   * begin. An earlier cut has no corrections, so its bits are rounded to the nearest.
   */
  private double roundedHeight(double height) {
    return Math.max(leastHeight, Math.min(mostHeight, height));
  }

  /** Returns those of some columns that are higher than a number of cells. */
  private int higher(double cells, int columns) {
    int higher = 0;
    for (int left = columns; left != 0; left &= left - 1) {
      int column = Integer.numberOfTrailingZeros(left);
      higher |= roundedHeight(heights[column]) > cells ? 1 << column : 0;
    }
    return higher;
  }
}
