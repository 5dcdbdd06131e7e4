package org.palpate.proxy.smooth.field;

import java.util.Arrays;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.IntBox;

/**
 * A window of 12x12x12 voxels, with two bits each: whether the voxel is solid, and whether it
 * counts as reached, that is, connected with a seed by empty voxels.
 *
 * <p>Empty voxels that the seed does not reach count as solid. A wall one voxel thick then looks
 * like a half space from either side; otherwise its two faces would cancel each other out.
 *
 * <p>Operations work on many voxels of a word at once (SIMD within a register, SWAR). A layer is
 * three words of four rows:
 *
 * <pre>
 *   word w of 3   bit  r r x x x x    row 4 w + r, voxel x; bits 12 to 15 of each row are clear
 * </pre>
 *
 * <p>Call {@link #forget} after any change of the solids.
 */
final class BinaryWindow {
  /** The voxels along an edge. */
  static final int EDGE = 12;

  /** The distance from the low voxel to the middle corner. */
  static final int TO_MIDDLE = EDGE / 2;

  /** The words of a layer. */
  static final int WORDS = 3;

  /** All voxels of the four rows of a word. */
  static final long ROW_MASK = 0x0FFF_0FFF_0FFF_0FFFL;

  /** All voxels of one row. */
  private static final int ROW = 0x0FFF;

  /** The layer behind the window's own: scratch for one of its faces. */
  private static final int FACE = EDGE * WORDS;

  private final AxisCut[] cuts;
  private final BrickCopy copy;

  /** The empty voxels. */
  private final long[] free = new long[FACE + WORDS];

  /** The voxels that the last flood fill reached. */
  private final long[] flooded = new long[FACE + WORDS];

  private final FloodFill fill = new FloodFill(free, flooded);
  private final OpenFaceFinder faces = new OpenFaceFinder(free);

  /** The voxels that count as reached: {@link #free} or {@link #flooded}. */
  private long[] reached = free;

  private int lowX;
  private int lowY;
  private int lowZ;
  private boolean anySolid;

  /** The cell that is looked at as a seed. */
  private final int[] seedCell = new int[3];

  /** The cell from which a flood fill begins, counted within the window. */
  private int seedX;

  private int seedY;
  private int seedZ;

  /** Whether all empty voxels are known to be connected, so that the seed does not matter. */
  private boolean connected;

  /**
   * Creates a window on the cells of a grid.
   *
   * @param source gives their bits
   */
  BinaryWindow(ThinGrid grid, BrickSource source) {
    cuts = grid.cuts().toArray(new AxisCut[0]);
    copy = new BrickCopy(source);
  }

  /** Returns the copy from which voxels are loaded. */
  BrickCopy copy() {
    return copy;
  }

  /** Forgets the copied bits. */
  void forget() {
    copy.forget();
  }

  /**
   * Forgets the copied bits that changes reach.
   *
   * @param changed the voxels; receives the cells that they may change, see {@link
   *     BrickSource#forget(IntBox)}
   */
  void forget(IntBox changed) {
    copy.forget(changed);
  }

  /** Reads the voxels around the grid corner (x,y,z); every empty one counts as reached. */
  void loadAround(CollisionScene scene, int x, int y, int z) {
    lowX = x - TO_MIDDLE;
    lowY = y - TO_MIDDLE;
    lowZ = z - TO_MIDDLE;
    copy.cover(scene, lowX, lowY, lowZ);
    reached = free;
    connected = false;
    int row = lowY - copy.lowY();
    int layer = lowZ - copy.lowZ();
    long solid = 0;
    for (int n = 0; n < EDGE; n++) {
      int from = BrickCopy.wordOfRow(row, layer + n);
      solid |= loadLayer(n * WORDS, from, (row & 3) << 4, lowX - copy.lowX());
    }
    anySolid = solid != 0;
  }

  /**
   * Loads one layer; returns its solid voxels.
   *
   * @param to its first word in the window
   * @param from its first word in the copy
   * @param shift 16 for each row of the first word that lies before the window
   * @param x the window's first voxel in the rows of the copy
   */
  private long loadLayer(int to, int from, int shift, int x) {
    long[] words = copy.words();
    long a = words[from] >>> x & ROW_MASK;
    long b = words[from + 1] >>> x & ROW_MASK;
    long c = words[from + 2] >>> x & ROW_MASK;
    long first = a;
    long second = b;
    long third = c;
    if (shift != 0) {
      long d = words[from + 3] >>> x & ROW_MASK;
      first = a >>> shift | b << -shift;
      second = b >>> shift | c << -shift;
      third = c >>> shift | d << -shift;
    }
    free[to] = first ^ ROW_MASK;
    free[to + 1] = second ^ ROW_MASK;
    free[to + 2] = third ^ ROW_MASK;
    return first | second | third;
  }

  /** Whether any voxel of the window is solid. */
  boolean anySolid() {
    return anySolid;
  }

  /** Whether some empty voxels do not count as reached. */
  boolean anyUnreached() {
    return reached != free && !isAllFlooded();
  }

  /** Returns the empty voxels of a row that do not count as reached, a bit each. */
  int unreachedOfRow(int y, int z) {
    int word = z * WORDS + (y >> 2);
    return (int) ((free[word] & ~reached[word]) >>> ((y & 3) << 4)) & ROW;
  }

  /** Returns the lowest x of the window. */
  int lowX() {
    return lowX;
  }

  /** Returns the lowest y of the window. */
  int lowY() {
    return lowY;
  }

  /** Returns the lowest z of the window. */
  int lowZ() {
    return lowZ;
  }

  /**
   * Whether a cell, or one of the two beside it along an axis, counts as reached. Cells are counted
   * from the low end of the window; those outside do not count.
   */
  boolean isBesideReached(int x, int y, int z, int axis) {
    int dx = axis == 0 ? 1 : 0;
    int dy = axis == 1 ? 1 : 0;
    int dz = axis == 2 ? 1 : 0;
    return isReached(x, y, z)
        || isReached(x - dx, y - dy, z - dz)
        || isReached(x + dx, y + dy, z + dz);
  }

  /** Whether a cell of the window, counted from its low end, counts as reached. */
  boolean isReached(int x, int y, int z) {
    return isInside(x, y, z) && isSet(reached, x, y, z);
  }

  /** Returns the voxels that count as reached, as words; valid until the next load. */
  long[] reachedWords() {
    return reached;
  }

  /**
   * Counts as reached only the empty voxels that a seed reaches by faces inside the window. If the
   * seed is solid or outside the window, every empty voxel counts as reached.
   */
  void floodFrom(SeedCell seed) {
    if (findSeed(seed)) {
      connected = isPlainlyConnected();
      if (!connected) {
        fill.floodFrom(seedX, seedY, seedZ);
        reached = flooded;
      }
    }
  }

  /**
   * Whether all empty voxels are connected for a reason that is quickly seen, as it is beside one
   * surface: straight columns of empty voxels lead from each of them to one face of the window, and
   * the empty voxels of that face are connected within it.
   */
  private boolean isPlainlyConnected() {
    boolean found = faces.findOpenFace(FACE);
    return found && (isFaceEmpty() || fill.isLayerConnected(FACE));
  }

  private boolean isFaceEmpty() {
    return (free[FACE] & free[FACE + 1] & free[FACE + 2]) == ROW_MASK;
  }

  /** Whether the same voxels would count as reached with another seed. */
  boolean holdsFor(SeedCell seed) {
    if (reached != free) {
      return findSeed(seed) ? isSet(flooded, seedX, seedY, seedZ) : isAllFlooded();
    }
    return !anySolid || connected || !findSeed(seed);
  }

  /** Whether the same voxels count as reached with every seed. */
  boolean holdsForEverySeed() {
    return reached == free ? !anySolid || connected : isAllFlooded();
  }

  /**
   * Finds the cell from which a seed reaches empty space. It looks at the empty cells of the voxel
   * of the seed. Of those nearest to the middle along the first cut, it takes the one nearest along
   * the second. Returns false if there is none in the window.
   */
  private boolean findSeed(SeedCell seed) {
    seedCell[0] = seed.x();
    seedCell[1] = seed.y();
    seedCell[2] = seed.z();
    return findSeedAlong(0);
  }

  /** Tries the cells along a cut and those after it, given the voxel along these. */
  private boolean findSeedAlong(int n) {
    if (n == cuts.length) {
      return setSeed(seedCell[0], seedCell[1], seedCell[2]);
    }
    AxisCut cut = cuts[n];
    int voxel = seedCell[cut.axis()];
    int middle = cut.middleOf(voxel);
    boolean found = false;
    for (int k = 0; !found && k < cut.perVoxel() + 2; k++) {
      int cell = (k & 1) == 0 ? middle - k / 2 : middle + (k + 1) / 2;
      if (cut.voxelOf(cell) == voxel) {
        seedCell[cut.axis()] = cell;
        found = findSeedAlong(n + 1);
      }
    }
    seedCell[cut.axis()] = voxel;
    return found;
  }

  /** Sets the seed to a cell; returns whether it is an empty one of the window. */
  private boolean setSeed(int x, int y, int z) {
    seedX = x - lowX;
    seedY = y - lowY;
    seedZ = z - lowZ;
    return isInside(seedX, seedY, seedZ) && isSet(free, seedX, seedY, seedZ);
  }

  private static boolean isSet(long[] words, int x, int y, int z) {
    return (words[z * WORDS + (y >> 2)] >>> ((y & 3) << 4 | x) & 1) != 0;
  }

  private static boolean isInside(int x, int y, int z) {
    return x >= 0 && x < EDGE && y >= 0 && y < EDGE && z >= 0 && z < EDGE;
  }

  private boolean isAllFlooded() {
    long missing = 0;
    for (int word = 0; word < FACE; word++) {
      missing |= free[word] ^ flooded[word];
    }
    return missing == 0;
  }

  /**
   * Flood fill by faces of the empty voxels of a window.
   *
   * <p>All voxels of a word spread at once: a run of free voxels that holds a reached one is filled
   * by a carry or by shifts of doubling length.
   */
  private static final class FloodFill {
    private static final int AXES = 3;

    private final long[] free;
    private final long[] reached;

    /**
     * Creates a fill over two arrays of words.
     *
     * @param free the empty voxels of a window, and of a face behind it
     * @param reached receives the voxels that are reached, in the same layout
     */
    FloodFill(long[] free, long[] reached) {
      this.free = free;
      this.reached = reached;
    }

    /**
     * Writes the voxels that the empty voxel (x,y,z) reaches by faces. It fills runs along one axis
     * after the other, until two axes in succession add nothing.
     */
    void floodFrom(int x, int y, int z) {
      Arrays.fill(reached, 0);
      reached[z * WORDS + (y >> 2)] = 1L << ((y & 3) << 4 | x);
      int settledAxes = 0;
      for (int axis = 0; settledAxes < AXES; axis = axis == 2 ? 0 : axis + 1) {
        long added = spreadAlong(axis);
        settledAxes = added != 0 ? 1 : settledAxes + 1;
      }
    }

    /** Spreads along z, y or x for axis 0, 1 or 2; returns 0 if that adds no voxel. */
    private long spreadAlong(int axis) {
      return axis == 0 ? spreadAlongZ() : axis == 1 ? spreadAlongY() : spreadAlongX();
    }

    private long spreadAlongX() {
      long added = 0;
      for (int word = 0; word < EDGE * WORDS; word++) {
        long before = reached[word];
        long after = spreadRows(before, free[word]);
        added |= before ^ after;
        reached[word] = after;
      }
      return added;
    }

    private long spreadAlongY() {
      long added = 0;
      for (int layer = 0; layer < EDGE * WORDS; layer += WORDS) {
        long freeA = free[layer];
        long freeB = free[layer + 1];
        long freeC = free[layer + 2];
        long a = spreadUp(reached[layer], freeA);
        long b = spreadUp(reached[layer + 1] | (freeB & a >>> 48), freeB);
        long c = spreadDown(spreadUp(reached[layer + 2] | (freeC & b >>> 48), freeC), freeC);
        b = spreadDown(b | (freeB & c << 48), freeB);
        a = spreadDown(a | (freeA & b << 48), freeA);
        added |= (a ^ reached[layer]) | (b ^ reached[layer + 1]) | (c ^ reached[layer + 2]);
        reached[layer] = a;
        reached[layer + 1] = b;
        reached[layer + 2] = c;
      }
      return added;
    }

    private long spreadAlongZ() {
      return spreadLayers(0, WORDS) | spreadLayers((EDGE - 1) * WORDS, -WORDS);
    }

    /** Spreads from layer to layer, from the first one on; returns 0 if that adds no voxel. */
    private long spreadLayers(int first, int step) {
      long added = 0;
      long a = 0;
      long b = 0;
      long c = 0;
      for (int layer = first; layer >= 0 && layer < EDGE * WORDS; layer += step) {
        long addA = a & free[layer] & ~reached[layer];
        long addB = b & free[layer + 1] & ~reached[layer + 1];
        long addC = c & free[layer + 2] & ~reached[layer + 2];
        added |= addA | addB | addC;
        reached[layer] = a = reached[layer] | addA;
        reached[layer + 1] = b = reached[layer + 1] | addB;
        reached[layer + 2] = c = reached[layer + 2] | addC;
      }
      return added;
    }

    /**
     * Whether the empty voxels of one layer are connected within it. Overwrites the layer's reached
     * voxels.
     *
     * @param layer the first word of the layer
     */
    boolean isLayerConnected(int layer) {
      long freeA = free[layer];
      long freeB = free[layer + 1];
      long freeC = free[layer + 2];
      long a = Long.lowestOneBit(freeA);
      long b = freeA == 0 ? Long.lowestOneBit(freeB) : 0;
      long c = (freeA | freeB) == 0 ? Long.lowestOneBit(freeC) : 0;
      boolean all = a == freeA && b == freeB && c == freeC;
      boolean settled = all;
      while (!settled) {
        long nextA = spreadColumns(spreadRows(a | b << 48, freeA), freeA);
        long nextB = spreadColumns(spreadRows(b | nextA >>> 48 | c << 48, freeB), freeB);
        long nextC = spreadColumns(spreadRows(c | nextB >>> 48, freeC), freeC);
        all = nextA == freeA && nextB == freeB && nextC == freeC;
        settled = all || (nextA == a && nextB == b && nextC == c);
        a = nextA;
        b = nextB;
        c = nextC;
      }
      return all;
    }

    /** Fills the runs of free voxels that hold a seed, along y both ways, inside a word. */
    private static long spreadColumns(long seeds, long free) {
      return spreadDown(spreadUp(seeds, free), free);
    }

    private static long spreadUp(long seeds, long free) {
      long up = seeds | (free & seeds << 16);
      return up | (free & free << 16 & up << 32);
    }

    private static long spreadDown(long seeds, long free) {
      long down = seeds | (free & seeds >>> 16);
      return down | (free & free >>> 16 & down >>> 32);
    }

    /** Fills the runs of free voxels that hold a seed, along x both ways. */
    private static long spreadRows(long seeds, long free) {
      long up = seeds & free;
      // A sum carries from the lowest seed of a run to its upper end; rows end in clear bits.
      long run = (((free + up) ^ free) | up) & free;
      run |= free & run >>> 1;
      long pairs = free & free >>> 1;
      run |= pairs & run >>> 2;
      long fours = pairs & pairs >>> 2;
      run |= fours & run >>> 4;
      long eights = fours & fours >>> 4;
      return run | (eights & run >>> 8);
    }
  }
}
