package org.palpate.proxy.smooth.field;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.Set;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.IntBox;
import org.palpate.testing.Seeds;

/** Distances to outlines, against a search of all pixels within reach. */
class SliceOutlineTest {
  private static final int TILES = 60;
  private static final int ALL = 0xFFFF;
  private static final int AXIS_Z = 2;

  @ParameterizedTest
  @CsvSource({
    "1, 1, 12",
    "1, 1, 16",
    "1, 1, 20",
    "1, 1, 24",
    "1, 3, 12",
    "2.5, 1, 24",
    "1, 1.2, 16",
    "10, 1, 20",
    "2, 2, 16"
  })
  void distancesAreThoseOfASearchOfAllPixels(double edgeU, double edgeV, int reach) {
    PixelEdges edges = new PixelEdges(edgeU, edgeV);
    SplittableRandom random = new SplittableRandom(Seeds.seed());
    Set<Integer> ringsOfFarthest = new HashSet<>();
    for (int oneOf : new int[] {2, 8, 40, 150, 600, 1_000_000}) {
      RandomSlices source = new RandomSlices(random.nextLong(), oneOf);
      SliceBits bits = new SliceBits(source, AXIS_Z);
      SliceOutline outline = new SliceOutline(bits, edges, reach);
      for (int n = 0; n < TILES; n++) {
        int u = random.nextInt(-6, 6);
        int v = random.nextInt(-6, 6);
        int slice = random.nextInt(-8, 8);
        int other = random.nextBoolean() ? slice : slice + 1;
        int columns = source.emptyPixels(u, v, slice) & random.nextInt(1, ALL + 1);
        if (random.nextBoolean()) {
          columns &= 0x8421; // few columns are searched in another way
        }
        double[] distances = new double[ShapeInterpolation.COLUMNS];
        outline.measure(u, v, slice, other, true, columns, distances);
        for (int left = columns; left != 0; left &= left - 1) {
          int column = Integer.numberOfTrailingZeros(left);
          int pixelU = 4 * u + (column & 3);
          int pixelV = 4 * v + (column >> 2);
          double expected = source.distance(pixelU, pixelV, slice, other, edges, reach);
          assertEquals(expected, distances[column], () -> "one of " + oneOf);
          ringsOfFarthest.add((int) expected / 4);
        }
      }
    }
    assertTrue(ringsOfFarthest.size() > reach / 4, "near and far ones: " + ringsOfFarthest);
  }

  @Test
  void aNearOutlineNeedsOnlyTheBricksBesideTheTile() {
    RandomSlices source = new RandomSlices(Seeds.seed(), 2);
    SliceBits bits = new SliceBits(source, AXIS_Z);
    int columns = source.emptyPixels(0, 0, 0);
    double[] distances = new double[ShapeInterpolation.COLUMNS];
    new SliceOutline(bits, new PixelEdges(1, 1), 24).measure(0, 0, 0, 0, true, columns, distances);
    assertEquals(9, source.bricks);
  }

  /** Slices of which one pixel of some is solid, at random; the same at every look. */
  private static final class RandomSlices implements BrickSource {
    private final long seed;
    private final int oneOf;
    private int bricks;

    RandomSlices(long seed, int oneOf) {
      this.seed = seed;
      this.oneOf = oneOf;
    }

    private boolean isSolid(int u, int v, int w) {
      long at = (u * 4096L + v) * 4096L + w;
      return new SplittableRandom(seed + 7_919 * at).nextInt(oneOf) == 0;
    }

    int emptyPixels(int tileU, int tileV, int w) {
      int empty = 0;
      for (int n = 0; n < ShapeInterpolation.COLUMNS; n++) {
        empty |= isSolid(4 * tileU + (n & 3), 4 * tileV + (n >> 2), w) ? 0 : 1 << n;
      }
      return empty;
    }

    /**
     * Returns the distance to the outline before the nearest pixel that is solid in both slices. Of
     * equally near ones, takes the one the fewest rows away.
     */
    double distance(int u, int v, int w, int other, PixelEdges edges, int reach) {
      double nearest = (reach + 1) * (reach + 1);
      double distance = reach;
      for (int off = 0; off <= reach; off++) {
        for (int along = 0; along <= reach; along++) {
          if (edges.square(along, off) < nearest && isAnySolid(u, v, w, other, along, off)) {
            nearest = edges.square(along, off);
            distance = Math.min(reach, edges.toOutline(along, off));
          }
        }
      }
      return distance;
    }

    private boolean isAnySolid(int u, int v, int w, int other, int along, int off) {
      boolean any = false;
      for (int n = 0; n < 4; n++) {
        int atU = (n & 1) == 0 ? u + along : u - along;
        int atV = (n & 2) == 0 ? v + off : v - off;
        any |= isSolid(atU, atV, w) && isSolid(atU, atV, other);
      }
      return any;
    }

    @Override
    public long brick(CollisionScene scene, int x, int y, int z) {
      bricks++;
      long brick = 0;
      for (int n = 0; n < Long.SIZE; n++) {
        boolean solid = isSolid(4 * x + (n & 3), 4 * y + (n >> 2 & 3), 4 * z + (n >> 4));
        brick |= solid ? 1L << n : 0;
      }
      return brick;
    }

    @Override
    public void forget() {}

    @Override
    public void forget(IntBox changed) {}
  }
}
