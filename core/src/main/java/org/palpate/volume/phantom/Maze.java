package org.palpate.volume.phantom;

/**
 * Diagonal walls whose voxels share edges and corners but no face. Yet no path through faces passes
 * them.
 *
 * <p>The walls are planes across the four diagonals of a cube, {@link #PERIOD} apart. A voxel has
 * the sums s0 = i+j+k, s1 = j+k-i, s2 = i+k-j and s3 = i+j-k. It belongs to a wall if one of them
 * is a multiple of the period, which is even. All four sums have the parity of s0, so that s0 is
 * even in every wall voxel, while face neighbours differ in parity. A hash of the seed and the
 * piece leaves out half of the pieces into which the planes cut one another, as doors.
 *
 * @param seed selects the doors
 */
record Maze(long seed) implements BrickSource {
  private static final int PERIOD_SHIFT = 4;
  static final int PERIOD = 1 << PERIOD_SHIFT;

  /** The grey value that each adjacent wall voxel adds to an empty voxel; six stay below half. */
  private static final int PARTIAL_VOLUME_GREY = 75;

  private static final int FAMILIES = 4;
  private static final int DOOR_ONE_IN = 2;

  /** Whether voxel (i,j,k) belongs to a wall. */
  boolean isWall(int i, int j, int k) {
    int s0 = i + j + k;
    if ((s0 & 1) != 0) {
      return false;
    }
    for (int family = 0; family < FAMILIES; family++) {
      if ((sum(family, i, j, k) & PERIOD - 1) == 0 && !isDoor(family, i, j, k)) {
        return true;
      }
    }
    return false;
  }

  private static int sum(int family, int i, int j, int k) {
    int all = i + j + k;
    return switch (family) {
      case 0 -> all;
      case 1 -> all - 2 * i;
      case 2 -> all - 2 * j;
      default -> all - 2 * k;
    };
  }

  private boolean isDoor(int family, int i, int j, int k) {
    long hash = mix(seed + family);
    for (int other = 0; other < FAMILIES; other++) {
      hash = mix(hash + (sum(other, i, j, k) >> PERIOD_SHIFT));
    }
    return Long.remainderUnsigned(hash, DOOR_ONE_IN) == 0;
  }

  /** Mixes the bits of a value. Reference: Steele, Lea, Flood 2014, finalizer of SplitMix64. */
  private static long mix(long value) {
    long z = value + 0x9E3779B97F4A7C15L;
    z = (z ^ (z >>> 30)) * 0xBF58476D1CE4E5B9L;
    z = (z ^ (z >>> 27)) * 0x94D049BB133111EBL;
    return z ^ (z >>> 31);
  }

  @Override
  public void enterRow(int brickX, int brickY, int brickZ) {}

  @Override
  public int labels(int brickX, int brickY, int brickZ, int[] dest) {
    for (int bit = 0; bit < 64; bit++) {
      boolean wall =
          isWall(4 * brickX + (bit & 3), 4 * brickY + (bit >> 2 & 3), 4 * brickZ + (bit >> 4));
      dest[bit] = wall ? 1 : 0;
    }
    return MIXED;
  }

  @Override
  public int greys(int brickX, int brickY, int brickZ, int[] dest) {
    for (int bit = 0; bit < 64; bit++) {
      dest[bit] =
          grey(4 * brickX + (bit & 3), 4 * brickY + (bit >> 2 & 3), 4 * brickZ + (bit >> 4));
    }
    return MIXED;
  }

  private int grey(int i, int j, int k) {
    if (((i + j + k) & 1) == 0) {
      return isWall(i, j, k) ? Phantom.SOLID_GREY : 0;
    }
    int walls = 0;
    for (int side = -1; side <= 1; side += 2) {
      walls += isWall(i + side, j, k) ? 1 : 0;
      walls += isWall(i, j + side, k) ? 1 : 0;
      walls += isWall(i, j, k + side) ? 1 : 0;
    }
    return walls * PARTIAL_VOLUME_GREY;
  }
}
