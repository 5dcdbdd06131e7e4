package org.palpate.volume;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.testing.SameVoxels;
import org.palpate.testing.Seeds;

/** Compares repairs and smoothing with plain references over arrays. */
class SegmentRepairTest {
  private static final int EDGE = 13;

  private final SplittableRandom random = new SplittableRandom(Seeds.seed());

  @Test
  void islandsAreRemovedAsAPlainFloodFillFindsThem() {
    for (int run = 0; run < 30; run++) {
      BitCube bits = noise(0.02 + 0.25 * random.nextDouble());
      int least = 1 + random.nextInt(12);
      List<List<int[]>> parts = parts(bits, true, 3);
      int largest = parts.stream().mapToInt(List::size).max().orElse(0);
      boolean keptOne = false;
      BitCube expected = bits.copy();
      for (List<int[]> part : parts) {
        boolean isLargest = part.size() == largest && !keptOne;
        keptOne |= isLargest;
        if (part.size() < least && !isLargest) {
          part.forEach(v -> expected.clear(v[0], v[1], v[2]));
        }
      }
      BitCube found = SegmentRepair.withoutIslands(bits, least);
      if (largest >= least) {
        SameVoxels.require(expected, found, "seed " + Seeds.seed());
      } else {
        assertEquals(largest, found.solidCount()); // which of equals stays is not stated
      }
    }
  }

  @Test
  void holesAreFilledAsAPlainFloodFillFindsThem() {
    long filled = 0;
    for (int run = 0; run < 30; run++) {
      BitCube bits = noise(0.6 + 0.35 * random.nextDouble());
      int most = 1 + random.nextInt(12);
      BitCube expected = bits.copy();
      for (List<int[]> part : parts(bits, false, 1)) {
        boolean isOpen = part.stream().anyMatch(SegmentRepairTest::isAtFace);
        if (part.size() < most && !isOpen) {
          part.forEach(v -> expected.set(v[0], v[1], v[2]));
        }
      }
      BitCube found = SegmentRepair.withoutHoles(bits, most);
      SameVoxels.require(expected, found, "seed " + Seeds.seed());
      filled += found.solidCount() - bits.solidCount();
    }
    assertTrue(filled > 100, "filled " + filled);
  }

  @Test
  void smoothingIsAnOpeningAndAClosingByTheirDefinitions() {
    for (int run = 0; run < 8; run++) {
      GridMetric metric = new GridMetric(1, 1.25, run % 2 == 0 ? 0.75 : 2.5);
      double radiusMm = 1 + random.nextDouble(0.9);
      BitCube bits = noise(0.3 + 0.4 * random.nextDouble());
      Vec3 centre = new Vec3(random.nextDouble(EDGE), random.nextDouble(EDGE), 5);
      double withinMm = 2 + random.nextDouble(4);
      BitCube opened = filter(filter(bits, metric, radiusMm, true), metric, radiusMm, false);
      BitCube closed = filter(filter(opened, metric, radiusMm, false), metric, radiusMm, true);
      BitCube found = new Smoothing(metric, radiusMm).smoothed(bits, centre, withinMm);
      for (int n = 0; n < EDGE * EDGE * EDGE; n++) {
        int i = n % EDGE;
        int j = n / EDGE % EDGE;
        int k = n / (EDGE * EDGE);
        double square =
            metric.squaredDistance(centre.x, centre.y, centre.z, i + 0.5, j + 0.5, k + 0.5);
        BitCube expected = square <= withinMm * withinMm ? closed : bits;
        assertEquals(expected.get(i, j, k), found.get(i, j, k), "seed " + Seeds.seed());
      }
    }
  }

  /** Erodes or dilates by looking at every pair of voxels of the grid. */
  private static BitCube filter(BitCube bits, GridMetric metric, double radiusMm, boolean erodes) {
    BitCube result = new BitCube(EDGE, EDGE, EDGE);
    for (int n = 0; n < EDGE * EDGE * EDGE; n++) {
      int i = n % EDGE;
      int j = n / EDGE % EDGE;
      int k = n / (EDGE * EDGE);
      boolean solid = erodes;
      for (int m = 0; m < EDGE * EDGE * EDGE; m++) {
        int x = m % EDGE;
        int y = m / EDGE % EDGE;
        int z = m / (EDGE * EDGE);
        if (metric.squaredDistance(i, j, k, x, y, z) <= radiusMm * radiusMm) {
          solid = erodes ? solid && bits.get(x, y, z) : solid || bits.get(x, y, z);
        }
      }
      if (solid) {
        result.set(i, j, k);
      }
    }
    return result;
  }

  private BitCube noise(double share) {
    BitCube bits = new BitCube(EDGE, EDGE, EDGE);
    for (int n = 0; n < EDGE * EDGE * EDGE; n++) {
      if (random.nextDouble() < share) {
        bits.set(n % EDGE, n / EDGE % EDGE, n / (EDGE * EDGE));
      }
    }
    return bits;
  }

  private static List<List<int[]>> parts(BitCube bits, boolean solid, int mostSteps) {
    boolean[] seen = new boolean[EDGE * EDGE * EDGE];
    List<List<int[]>> parts = new ArrayList<>();
    for (int n = 0; n < seen.length; n++) {
      Deque<int[]> open = new ArrayDeque<>();
      List<int[]> part = new ArrayList<>();
      visit(bits, solid, n % EDGE, n / EDGE % EDGE, n / (EDGE * EDGE), seen, open);
      while (!open.isEmpty()) {
        int[] v = open.pop();
        part.add(v);
        for (int m = 0; m < 27; m++) {
          int x = m % 3 - 1;
          int y = m / 3 % 3 - 1;
          int z = m / 9 - 1;
          if (Math.abs(x) + Math.abs(y) + Math.abs(z) <= mostSteps) {
            visit(bits, solid, v[0] + x, v[1] + y, v[2] + z, seen, open);
          }
        }
      }
      if (!part.isEmpty()) {
        parts.add(part);
      }
    }
    return parts;
  }

  private static void visit(
      BitCube bits, boolean solid, int i, int j, int k, boolean[] seen, Deque<int[]> open) {
    boolean inGrid = Math.min(i, Math.min(j, k)) >= 0 && Math.max(i, Math.max(j, k)) < EDGE;
    int n = i + EDGE * (j + EDGE * k);
    if (inGrid && bits.get(i, j, k) == solid && !seen[n]) {
      seen[n] = true;
      open.push(new int[] {i, j, k});
    }
  }

  private static boolean isAtFace(int[] v) {
    return Math.min(v[0], Math.min(v[1], v[2])) == 0
        || Math.max(v[0], Math.max(v[1], v[2])) == EDGE - 1;
  }
}
