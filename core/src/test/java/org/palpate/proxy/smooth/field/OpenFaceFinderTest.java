package org.palpate.proxy.smooth.field;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.testing.RandomCases;
import org.palpate.testing.Seeds;

/** Compares the finder with a search voxel by voxel, in windows with few or no open faces. */
class OpenFaceFinderTest {
  private static final int EDGE = BinaryWindow.EDGE;
  private static final int WORDS = BinaryWindow.WORDS;
  private static final int DEST = EDGE * WORDS;

  private final SplittableRandom random = new SplittableRandom(Seeds.seed());
  private final boolean[][][] window = new boolean[EDGE][EDGE][EDGE];
  private final long[] free = new long[DEST + WORDS];
  private final OpenFaceFinder finder = new OpenFaceFinder(free);
  private int lastFace = 5;

  @Test
  void findsTheNextFaceThatEveryFreeVoxelSeesAndCopiesIt() {
    int[] found = new int[7];
    for (int n = 0; n < RandomCases.of(40_000); n++) {
      openTo(random.nextInt(6));
      if (random.nextInt(3) == 0) {
        spoil();
      }
      write();
      String what = "seed=" + Seeds.seed() + " window " + n;
      int face = nextOpenFace();
      found[face + 1]++;
      if (face < 0) {
        assertFalse(finder.findOpenFace(DEST), what);
      } else {
        assertTrue(finder.findOpenFace(DEST), what);
        lastFace = face;
        assertCopied(face, what);
      }
    }
    for (int face = -1; face < 6; face++) {
      assertTrue(found[face + 1] > RandomCases.of(1_000), "face " + face + ": " + found[face + 1]);
    }
  }

  private boolean at(int face, int u, int v, int depth) {
    int along = face % 2 == 0 ? depth : EDGE - 1 - depth;
    return switch (face / 2) {
      case 0 -> window[v][u][along];
      case 1 -> window[v][along][u];
      default -> window[along][v][u];
    };
  }

  private void set(int face, int u, int v, int depth, boolean isFree) {
    int along = face % 2 == 0 ? depth : EDGE - 1 - depth;
    switch (face / 2) {
      case 0 -> window[v][u][along] = isFree;
      case 1 -> window[v][along][u] = isFree;
      default -> window[along][v][u] = isFree;
    }
  }

  /** Frees columns of random lengths behind a face; at times all voxels but a few columns. */
  private void openTo(int face) {
    boolean isWide = random.nextBoolean();
    for (int u = 0; u < EDGE; u++) {
      for (int v = 0; v < EDGE; v++) {
        int length = isWide && random.nextInt(60) != 0 ? EDGE : random.nextInt(EDGE + 1);
        for (int depth = 0; depth < EDGE; depth++) {
          set(face, u, v, depth, depth < length);
        }
      }
    }
  }

  /** Changes a voxel. */
  private void spoil() {
    int x = random.nextInt(EDGE);
    int y = random.nextInt(EDGE);
    int z = random.nextInt(EDGE);
    window[z][y][x] = !window[z][y][x];
  }

  private void write() {
    for (int z = 0; z < EDGE; z++) {
      for (int word = 0; word < WORDS; word++) {
        long rows = 0;
        for (int bit = 0; bit < 64; bit++) {
          boolean isVoxel = bit % 16 < EDGE;
          rows |= isVoxel && window[z][4 * word + bit / 16][bit % 16] ? 1L << bit : 0;
        }
        free[z * WORDS + word] = rows;
      }
    }
  }

  private int nextOpenFace() {
    for (int n = 0; n < 6; n++) {
      int face = (lastFace + n) % 6;
      if (isOpen(face)) {
        return face;
      }
    }
    return -1;
  }

  private boolean isOpen(int face) {
    for (int u = 0; u < EDGE; u++) {
      for (int v = 0; v < EDGE; v++) {
        for (int depth = 1; depth < EDGE; depth++) {
          if (at(face, u, v, depth) && !at(face, u, v, depth - 1)) {
            return false;
          }
        }
      }
    }
    return true;
  }

  private void assertCopied(int face, String what) {
    for (int v = 0; v < EDGE; v++) {
      for (int u = 0; u < EDGE; u++) {
        boolean copied = (free[DEST + v / 4] >>> (16 * (v % 4) + u) & 1) != 0;
        assertEquals(at(face, u, v, 0), copied, what + " face " + face + " " + u + " " + v);
      }
    }
  }
}
