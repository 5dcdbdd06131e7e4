package org.palpate.proxy.smooth.field;

import org.palpate.collision.CollisionScene;
import org.palpate.geometry.IntBox;
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

  /** The cached bricks along each axis, see {@link ThinSlices}. */
  private static final int BRICKS = 32;

  /** The layers on either side of a corrected one on which the correction depends. */
  private static final int LAYERS_BESIDE_TERRACE = 2;

  /** The number of the last column of a tile along u or v. */
  private static final int LAST = 3;

  /** The bits of the cells if {@link #forget} must make them forget, else null. */
  private final BrickSource bits;

  private final BrickCopy copy;
  private final FlatBricks flatBricks;
  private final Axis[] axes;

  /** The bricks that changes of cells reach: scratch. */
  private final IntBox reached = new IntBox();

  /** The bricks whose corrections are known, most of which have none. */
  private final CacheKeys keys = new CacheKeys(BRICKS);

  private final CellCorrections.Slots slots = new CellCorrections.Slots(keys.slots());

  /** The columns that were interpolated so far. */
  private long columns;

  /**
   * Creates the corrections of the voxels of a grid that are not cut.
   *
   * @param copy a copy of the bits around the window
   * @param edges the edges of a voxel, in shortest edges
   */
  static Terraces ofVoxels(BrickCopy copy, Vec3 edges) {
    BrickSource voxels = new BrickSource.BoundedVoxels();
    return new Terraces(ThinGrid.WHOLE, voxels, voxels, copy, edges);
  }

  /**
   * Creates the corrections of the cells of a grid.
   *
   * @param cells their bits, which the owner of the copy makes forget
   * @param copy a copy of the bits around the window
   * @param edges the edges of a voxel, in shortest edges
   */
  Terraces(ThinGrid grid, BrickSource cells, BrickCopy copy, Vec3 edges) {
    this(grid, cells, null, copy, edges);
  }

  private Terraces(ThinGrid grid, BrickSource cells, BrickSource bits, BrickCopy copy, Vec3 edges) {
    this.bits = bits;
    this.copy = copy;
    Vec3 cellEdges = grid.cellEdges(edges);
    axes = new Axis[3 - grid.cuts().size()];
    int[] numbers = new int[axes.length];
    int count = 0;
    for (int axis = 0; axis < 3; axis++) {
      if (!grid.isCut(axis)) {
        numbers[count] = axis;
        axes[count++] = new Axis(axis, cells, cellEdges);
      }
    }
    flatBricks = new FlatBricks(copy, numbers);
  }

  @Override
  public long columns() {
    return columns;
  }

  @Override
  public void forget() {
    keys.forget();
    for (Axis axis : axes) {
      axis.slices.forget();
    }
  }

  @Override
  public void forgetAround(IntBox cells) {
    if (bits != null) {
      bits.forget(cells);
    }
    for (Axis axis : axes) {
      axis.slices.forgetRows(cells);
      axis.setReached(cells, reached);
      keys.forget(reached);
    }
  }

  @Override
  public long toFind(long kept, int offset) {
    return flatBricks.find(kept, offset);
  }

  @Override
  public long toFindInWindow(CollisionScene scene, BinaryWindow window) {
    return flatBricks.findAtRim(
        scene,
        window.lowX() - copy.lowX(),
        window.lowY() - copy.lowY(),
        window.lowZ() - copy.lowZ());
  }

  @Override
  public boolean find(CollisionScene scene, int number, int x, int y, int z) {
    int slot = keys.slot(x, y, z);
    if (!keys.holdsElseSet(slot, x, y, z)) {
      slots.clear(slot);
      for (Axis axis : axes) {
        axis.findLayers(scene, copy, number);
        if (axis.hasTerrace()) {
          axis.slices.use(scene);
          correctTiles(axis, x, y, z, slot);
        }
      }
    }
    return slots.corrected(slot) != 0;
  }

  /** Bricks of one copy have different slots. */
  @Override
  public int slotOf(CollisionScene scene, int x, int y, int z) {
    return keys.slot(x, y, z);
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

  /** Corrects the cells of a brick that lie on terraces across an axis. */
  private void correctTiles(Axis axis, int x, int y, int z, int slot) {
    int u = axis.number == 0 ? z : x;
    int v = axis.number == 1 ? z : y;
    int w = axis.number == 0 ? x : axis.number == 1 ? y : z;
    for (int n = 0; n < 4; n++) {
      if ((axis.terracesAbove() >> n & 1) != 0) {
        correct(axis, u, v, 4 * w + n, 1, slot);
      }
      if ((axis.terracesBelow() >> n & 1) != 0) {
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
    columns += Axis.CORNER_COLUMNS;
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

    /** The number of these columns. */
    private static final int CORNER_COLUMNS = 4;

    private final int number;

    private final SliceBits slices;
    private final ShapeInterpolation interpolation;

    /** The empty layers of the brick that is looked at, a bit each. */
    private int empty;

    /** Its solid layers from the one below the brick to the one above it. */
    private int solid;

    /** The heights of the surface above the middle of the solid layer, in cells. */
    private final double[] heights = new double[ShapeInterpolation.COLUMNS];

    Axis(int number, BrickSource cells, Vec3 cellEdges) {
      this.number = number;
      slices = new SliceBits(cells, number);
      interpolation =
          new ShapeInterpolation(
              slices, PixelEdges.across(number, cellEdges), REACH, 1, NEVER_BENT);
    }

    /** Sets a box to the bricks whose corrections depend on changed cells. */
    void setReached(IntBox cells, IntBox dest) {
      for (int n = 0; n < 3; n++) {
        int reach = n == number ? 0 : interpolation.reachBricks();
        int beside = n == number ? LAYERS_BESIDE_TERRACE : 0;
        dest.setRange(
            n, ((cells.low(n) - beside) >> 2) - reach, ((cells.high(n) + beside) >> 2) + reach);
      }
    }

    /** Finds the empty and the solid layers of a brick of the copy. */
    void findLayers(CollisionScene scene, BrickCopy copy, int brickNumber) {
      long brick = copy.brick(brickNumber);
      empty = FlatBricks.emptyLayers(brick, number);
      solid = FlatBricks.emptyLayers(~brick, number) << 1;
      if ((empty & 1) != 0 && areSolidBeside(scene, copy, brickNumber, -1)) {
        solid |= 1;
      }
      if ((empty & 8) != 0 && areSolidBeside(scene, copy, brickNumber, 1)) {
        solid |= 1 << 5;
      }
    }

    private boolean areSolidBeside(
        CollisionScene scene, BrickCopy copy, int brickNumber, int step) {
      long nearest = FlatBricks.outermost(number, -step);
      return copy.areSolidBeside(scene, brickNumber, number, step, nearest);
    }

    /** Whether an empty layer of the brick lies beside a solid one. */
    boolean hasTerrace() {
      return (terracesAbove() | terracesBelow()) != 0;
    }

    /** Returns the empty layers that lie above a solid one, a bit each. */
    int terracesAbove() {
      return empty & solid;
    }

    /** Returns the empty layers that lie below a solid one, a bit each. */
    int terracesBelow() {
      return empty & solid >> 2;
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
