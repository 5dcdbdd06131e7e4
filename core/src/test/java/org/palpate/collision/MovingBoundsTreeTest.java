package org.palpate.collision;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.Vec3;
import org.palpate.geometry.WorldBox;
import org.palpate.testing.RandomGeometry;
import org.palpate.testing.Seeds;

class MovingBoundsTreeTest {
  private final SplittableRandom random = new SplittableRandom(Seeds.seed());

  private WorldBox box(double reachMm, double sizeMm) {
    Vec3 centre = RandomGeometry.vector(random, reachMm);
    return new WorldBox().include(centre).grow(random.nextDouble(sizeMm));
  }

  @Test
  void findsExactlyTheBoxesThatALoopOverAllFindsWhereverTheyMove() {
    long found = 0;
    for (int round = 0; round < 60; round++) {
      int items = 1 + random.nextInt(150);
      double reachMm = Math.pow(10, random.nextDouble(0, 6));
      MovingBoundsTree tree = new MovingBoundsTree(items, random.nextDouble(0, 5));
      WorldBox[] boxes = new WorldBox[items];
      for (int step = 0; step < 400; step++) {
        int item = random.nextInt(items);
        boolean jumps = boxes[item] == null || random.nextInt(4) == 0;
        double smallMm = random.nextDouble(3);
        boxes[item] =
            jumps ? box(reachMm, 30) : new WorldBox().set(boxes[item]).grow(smallMm - 1.5);
        if (boxes[item].edgesMm() < 0) {
          boxes[item] = box(reachMm, 30);
        }
        tree.put(item, boxes[item]);
        WorldBox query = box(reachMm, random.nextBoolean() ? 5 : reachMm);
        found += check(tree, boxes, query);
      }
    }
    assertTrue(found > 10_000, "found " + found);
  }

  private static int check(MovingBoundsTree tree, WorldBox[] boxes, WorldBox query) {
    long[] expected = new long[boxes.length / 64 + 1];
    int count = 0;
    for (int n = 0; n < boxes.length; n++) {
      if (boxes[n] != null && boxes[n].meets(query)) {
        expected[n >> 6] |= 1L << n;
        count++;
      }
    }
    long[] found = new long[expected.length];
    tree.find(query, found);
    assertArrayEquals(expected, found);
    return count;
  }

  @Test
  void anEmptyTreeFindsNothingAndTouchingBoxesAreFound() {
    MovingBoundsTree tree = new MovingBoundsTree(2, 1);
    long[] found = new long[1];
    WorldBox one = new WorldBox().include(new Vec3(0, 0, 0)).include(new Vec3(1, 1, 1));
    tree.find(one, found);
    assertEquals(0, found[0]);
    tree.put(1, new WorldBox().include(new Vec3(1, 1, 1)).include(new Vec3(2, 2, 2)));
    tree.find(one, found);
    assertEquals(2, found[0]);
  }
}
