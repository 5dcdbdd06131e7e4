package org.palpate.fracture.fit;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.Vec3;

/** Compares the points that are found with those of a look at all of them. */
class PointGridTest {
  private static final long SEED = Long.getLong("palpate.seed", 20);

  @Test
  void findsAllPointsWithinARadius() {
    SplittableRandom random = new SplittableRandom(SEED);
    List<Vec3> points = new ArrayList<>();
    for (int n = 0; n < 3000; n++) {
      points.add(place(random));
    }
    PointGrid grid = new PointGrid(points, 3);
    int most = 0;
    for (int n = 0; n < 200; n++) {
      Vec3 middle = place(random);
      double mm = random.nextDouble(8);
      int[] near =
          IntStream.range(0, points.size())
              .filter(m -> points.get(m).sub(middle, new Vec3()).length() < mm)
              .toArray();
      assertArrayEquals(near, sorted(grid.around(middle, mm)), "seed " + SEED);
      most = Math.max(most, near.length);
    }
    assertTrue(most > 64, "the buffer grows");
  }

  private static int[] sorted(int[] indices) {
    Arrays.sort(indices);
    return indices;
  }

  private static Vec3 place(SplittableRandom random) {
    return new Vec3(
        random.nextDouble(-20, 20), random.nextDouble(-20, 20), random.nextDouble(-20, 20));
  }
}
