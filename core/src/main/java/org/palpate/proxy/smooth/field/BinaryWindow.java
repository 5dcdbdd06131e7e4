package org.palpate.proxy.smooth.field;

import java.util.Arrays;
import org.palpate.collision.CollisionScene;

/**
 * The bits of 12x12x12 voxels, and which of the empty ones can be reached from a seed inside it.
 *
 * <p>What the seed cannot reach counts as solid: a wall one voxel thick then looks like a half
 * space from either side, where its own two faces would cancel out.
 *
 * <pre>
 *   layer word w of 3   bit  r r x x x x    row 4 w + r, voxel x; voxels beyond 11 are clear
 * </pre>
 *
 * <p>The bits come from a copy of 16x16x16 voxels at a multiple of 4, which is read anew when the
 * window leaves it: {@link #forget} after any change of the solids.
 */
final class BinaryWindow {
  /** Voxels along an edge. */
  static final int EDGE = 12;

  /** Words to a layer. */
  static final int WORDS = 3;

  private static final int SCRATCH_LAYER = EDGE;
  private static final int AREA_BRICKS = 4;
  private static final int AREA_EDGE = 16;
  static final long ROW_MASK = 0x0FFF_0FFF_0FFF_0FFFL;
  private static final int ROW_OF_WORD = 0x0FFF;

  private final long[] area = new long[AREA_EDGE * AREA_BRICKS];
  private int areaX;
  private int areaY;
  private int areaZ;
  private boolean areaValid;

  /** A layer more than the window has: scratch for a face of it. */
  private final long[] free = new long[(EDGE + 1) * WORDS];

  private final long[] reached = new long[(EDGE + 1) * WORDS];
  private final OpenFaceFinder faces = new OpenFaceFinder(free);

  /** What counts as reached: all free voxels, or those that a flood found. */
  private long[] inside = free;

  private boolean anySolid;

  /** Whether all free voxels are known to be joined, so that no seed matters. */
  private boolean joined;

  /** Forgets the copied bits. */
  void forget() {
    areaValid = false;
  }

  /** Reads the voxels from (lowX, lowY, lowZ) on; every empty one counts as reached. */
  void load(CollisionScene obstacles, int lowX, int lowY, int lowZ) {
    if (!isInArea(lowX, lowY, lowZ)) {
      copyArea(obstacles, centred(lowX), centred(lowY), centred(lowZ));
    }
    inside = free;
    joined = false;
    int x = lowX - areaX;
    int y = lowY - areaY;
    int z = lowZ - areaZ;
    long solid = 0;
    for (int layer = 0; layer < EDGE; layer++) {
      solid |= loadLayer(layer * WORDS, (z + layer) * AREA_BRICKS + (y >> 2), (y & 3) << 4, x);
    }
    anySolid = solid != 0;
  }

  private long loadLayer(int to, int from, int shift, int x) {
    long a = area[from] >>> x & ROW_MASK;
    long b = area[from + 1] >>> x & ROW_MASK;
    long c = area[from + 2] >>> x & ROW_MASK;
    long first = a;
    long second = b;
    long third = c;
    if (shift != 0) {
      long d = area[from + 3] >>> x & ROW_MASK;
      first = a >>> shift | b << -shift;
      second = b >>> shift | c << -shift;
      third = c >>> shift | d << -shift;
    }
    free[to] = first ^ ROW_MASK;
    free[to + 1] = second ^ ROW_MASK;
    free[to + 2] = third ^ ROW_MASK;
    return first | second | third;
  }

  private boolean isInArea(int lowX, int lowY, int lowZ) {
    int room = AREA_EDGE - EDGE;
    return areaValid
        && lowX >= areaX
        && lowX <= areaX + room
        && lowY >= areaY
        && lowY <= areaY + room
        && lowZ >= areaZ
        && lowZ <= areaZ + room;
  }

  /** A multiple of 4 that leaves the window about as much room on either side. */
  private static int centred(int low) {
    return low - 1 & ~3;
  }

  private void copyArea(CollisionScene obstacles, int lowX, int lowY, int lowZ) {
    areaX = lowX;
    areaY = lowY;
    areaZ = lowZ;
    areaValid = true;
    for (int z = 0; z < AREA_BRICKS; z++) {
      for (int y = 0; y < AREA_BRICKS; y++) {
        copyRowOfBricks(obstacles, y, z);
      }
    }
  }

  private void copyRowOfBricks(CollisionScene obstacles, int y, int z) {
    int brickX = areaX >> 2;
    int brickY = (areaY >> 2) + y;
    int brickZ = (areaZ >> 2) + z;
    long a = obstacles.brick(brickX, brickY, brickZ);
    long b = obstacles.brick(brickX + 1, brickY, brickZ);
    long c = obstacles.brick(brickX + 2, brickY, brickZ);
    long d = obstacles.brick(brickX + 3, brickY, brickZ);
    boolean empty = (a | b | c | d) == 0;
    for (int layer = 0; layer < 4; layer++) {
      area[(4 * z + layer) * AREA_BRICKS + y] =
          empty ? 0 : rowsOfBricks(a, b, c, d, AREA_EDGE * layer);
    }
  }

  /**
   * Four rows of 16 voxels from one layer of four bricks side by side: a transposition of 4 by 4
   * nibbles.
   */
  private static long rowsOfBricks(long a, long b, long c, long d, int shift) {
    long bricks =
        (a >>> shift & 0xFFFF)
            | (b >>> shift & 0xFFFF) << 16
            | (c >>> shift & 0xFFFF) << 32
            | (d >>> shift) << 48;
    long swap = (bricks ^ bricks >>> 12) & 0x0000_F0F0_0000_F0F0L;
    bricks ^= swap ^ swap << 12;
    swap = (bricks ^ bricks >>> 24) & 0x0000_0000_FF00_FF00L;
    return bricks ^ swap ^ swap << 24;
  }

  /** Whether any voxel of the window is solid. */
  boolean anySolid() {
    return anySolid;
  }

  /** Whether the voxel (x,y,z) of the window is empty and counts as reached. */
  boolean isReached(int x, int y, int z) {
    return (inside[z * WORDS + (y >> 2)] >>> ((y & 3) << 4 | x) & 1) != 0;
  }

  /** Whether the voxel (x,y,z) of the window is empty. */
  boolean isFree(int x, int y, int z) {
    return (free[z * WORDS + (y >> 2)] >>> ((y & 3) << 4 | x) & 1) != 0;
  }

  /** Whether some empty voxels do not count as reached. */
  boolean anyUnreached() {
    return inside != free && !isAllReached();
  }

  /** The empty voxels of a row that do not count as reached, a bit a voxel. */
  int unreachedOfRow(int y, int z) {
    int word = z * WORDS + (y >> 2);
    return (int) ((free[word] & ~inside[word]) >>> ((y & 3) << 4)) & ROW_OF_WORD;
  }

  /** The voxels that count as reached, as words; good until the next {@link #load}. */
  long[] reachedWords() {
    return inside;
  }

  /** Floods from the voxel (x,y,z) if it lies in the window and is empty; else all is reached. */
  void floodFrom(int x, int y, int z) {
    if (isSeed(x, y, z)) {
      joined = isPlainlyJoined();
      if (!joined) {
        flood(x, y, z);
      }
    }
  }

  /**
   * Whether all free voxels are joined for a reason that is quickly seen, as it is beside one
   * surface: from each of them free voxels lead straight to one face of the window, and those of
   * that face are joined in it.
   */
  private boolean isPlainlyJoined() {
    int face = SCRATCH_LAYER * WORDS;
    if (!faces.findOpenFace(face)) {
      return false;
    }
    long a = free[face];
    long b = free[face + 1];
    long c = free[face + 2];
    if ((a & b & c) == ROW_MASK) {
      return true;
    }
    reached[face] = Long.lowestOneBit(a);
    reached[face + 1] = a == 0 ? Long.lowestOneBit(b) : 0;
    reached[face + 2] = (a | b) == 0 ? Long.lowestOneBit(c) : 0;
    spreadLayer(face, 0, 0, 0);
    return reached[face] == a && reached[face + 1] == b && reached[face + 2] == c;
  }

  /** Whether a flood from the voxel (x,y,z) would reach the same, as far as it is in the window. */
  boolean holdsFor(int x, int y, int z) {
    if (inside != free) {
      return isSeed(x, y, z) ? isReached(x, y, z) : isAllReached();
    }
    return joined || !isSeed(x, y, z);
  }

  private boolean isSeed(int x, int y, int z) {
    return isInside(x, y, z) && isFree(x, y, z);
  }

  private static boolean isInside(int x, int y, int z) {
    return x >= 0 && x < EDGE && y >= 0 && y < EDGE && z >= 0 && z < EDGE;
  }

  /**
   * Keeps as reached only what is joined to the empty voxel (x,y,z) by faces inside the window:
   * fills runs of free voxels along an axis after the other, until two axes add nothing to the
   * third.
   */
  private void flood(int x, int y, int z) {
    inside = reached;
    Arrays.fill(reached, 0);
    reached[z * WORDS + (y >> 2)] = 1L << ((y & 3) << 4 | x);
    int idle = 0;
    for (int axis = 0; idle < 3; axis = axis == 2 ? 0 : axis + 1) {
      idle = spreadAlong(axis) ? 1 : idle + 1;
    }
  }

  private boolean spreadAlong(int axis) {
    return axis == 0 ? spreadAlongZ() : axis == 1 ? spreadAlongY() : spreadAlongX();
  }

  private boolean spreadAlongX() {
    long more = 0;
    for (int word = 0; word < EDGE * WORDS; word++) {
      long before = reached[word];
      long after = spreadRows(before, free[word]);
      more |= before ^ after;
      reached[word] = after;
    }
    return more != 0;
  }

  private boolean spreadAlongY() {
    long more = 0;
    for (int layer = 0; layer < EDGE * WORDS; layer += WORDS) {
      long freeA = free[layer];
      long freeB = free[layer + 1];
      long freeC = free[layer + 2];
      long a = spreadUp(reached[layer], freeA);
      long b = spreadUp(reached[layer + 1] | (freeB & a >>> 48), freeB);
      long c = spreadDown(spreadUp(reached[layer + 2] | (freeC & b >>> 48), freeC), freeC);
      b = spreadDown(b | (freeB & c << 48), freeB);
      a = spreadDown(a | (freeA & b << 48), freeA);
      more |= (a ^ reached[layer]) | (b ^ reached[layer + 1]) | (c ^ reached[layer + 2]);
      reached[layer] = a;
      reached[layer + 1] = b;
      reached[layer + 2] = c;
    }
    return more != 0;
  }

  private boolean spreadAlongZ() {
    long more = 0;
    long a = 0;
    long b = 0;
    long c = 0;
    for (int layer = 0; layer < EDGE * WORDS; layer += WORDS) {
      long addA = a & free[layer] & ~reached[layer];
      long addB = b & free[layer + 1] & ~reached[layer + 1];
      long addC = c & free[layer + 2] & ~reached[layer + 2];
      more |= addA | addB | addC;
      reached[layer] = a = reached[layer] | addA;
      reached[layer + 1] = b = reached[layer + 1] | addB;
      reached[layer + 2] = c = reached[layer + 2] | addC;
    }
    for (int layer = (EDGE - 2) * WORDS; layer >= 0; layer -= WORDS) {
      long addA = a & free[layer] & ~reached[layer];
      long addB = b & free[layer + 1] & ~reached[layer + 1];
      long addC = c & free[layer + 2] & ~reached[layer + 2];
      more |= addA | addB | addC;
      reached[layer] = a = reached[layer] | addA;
      reached[layer + 1] = b = reached[layer + 1] | addB;
      reached[layer + 2] = c = reached[layer + 2] | addC;
    }
    return more != 0;
  }

  private boolean isAllReached() {
    long missing = 0;
    for (int word = 0; word < EDGE * WORDS; word++) {
      missing |= free[word] ^ reached[word];
    }
    return missing == 0;
  }

  /** Adds three words to a layer's reached voxels and spreads them inside the layer until idle. */
  private void spreadLayer(int layer, long addA, long addB, long addC) {
    long freeA = free[layer];
    long freeB = free[layer + 1];
    long freeC = free[layer + 2];
    long a = reached[layer] | addA;
    long b = reached[layer + 1] | addB;
    long c = reached[layer + 2] | addC;
    boolean idle = a == freeA && b == freeB && c == freeC;
    while (!idle) {
      long nextA = spreadColumns(spreadRows(a | b << 48, freeA), freeA);
      long nextB = spreadColumns(spreadRows(b | nextA >>> 48 | c << 48, freeB), freeB);
      long nextC = spreadColumns(spreadRows(c | nextB >>> 48, freeC), freeC);
      boolean all = nextA == freeA && nextB == freeB && nextC == freeC;
      idle = all || (nextA == a && nextB == b && nextC == c);
      a = nextA;
      b = nextB;
      c = nextC;
    }
    reached[layer] = a;
    reached[layer + 1] = b;
    reached[layer + 2] = c;
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
