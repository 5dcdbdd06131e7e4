package org.palpate.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.Set;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.testing.Seeds;

/** Compares boxes with the sets of their cells. */
class IntBoxTest {
  private static final int EDGE = 5;

  private final SplittableRandom random = new SplittableRandom(Seeds.seed());

  private static IntBox box(int lowX, int lowY, int lowZ, int highX, int highY, int highZ) {
    IntBox box = new IntBox();
    box.include(lowX, lowY, lowZ);
    box.include(highX, highY, highZ);
    return box;
  }

  private IntBox randomBox() {
    IntBox box = new IntBox();
    for (int n = random.nextInt(3); n > 0; n--) {
      box.include(random.nextInt(EDGE), random.nextInt(EDGE), random.nextInt(EDGE));
    }
    return box;
  }

  /** Returns the cells between the ends of a box, each as one number. */
  private static Set<Integer> cells(IntBox box) {
    Set<Integer> cells = new HashSet<>();
    for (int cell = 0; cell < EDGE * EDGE * EDGE; cell++) {
      int i = cell % EDGE;
      int j = cell / EDGE % EDGE;
      int k = cell / (EDGE * EDGE);
      boolean x = box.lowX <= i && i <= box.highX;
      boolean y = box.lowY <= j && j <= box.highY;
      boolean z = box.lowZ <= k && k <= box.highZ;
      if (x && y && z) {
        cells.add(cell);
      }
      assertEquals(x && y && z, box.contains(i, j, k));
    }
    return cells;
  }

  @Test
  void holdsTheCellsBetweenThoseThatWereIncluded() {
    assertTrue(new IntBox().isEmpty());
    assertEquals(Set.of(), cells(new IntBox()));
    assertEquals(Set.of(0), cells(box(0, 0, 0, 0, 0, 0)));
    IntBox box = box(3, 1, 4, 2, 2, 0);
    assertFalse(box.isEmpty());
    assertEquals(2 * 2 * 5, cells(box).size());
    assertEquals("x 2-3, y 1-2, z 0-4", box.toString());
    box.clear();
    assertTrue(box.isEmpty());
    assertEquals("empty", box.toString());
  }

  @Test
  void meetsAnotherIfTheyShareACellAndIncludesAllOfIt() {
    for (int n = 0; n < 3000; n++) {
      IntBox a = randomBox();
      IntBox b = randomBox();
      Set<Integer> shared = cells(a);
      shared.retainAll(cells(b));
      assertEquals(!shared.isEmpty(), a.meets(b), () -> Seeds.seed() + ": " + a + " and " + b);
      IntBox sum = new IntBox();
      assertSame(sum, sum.set(a));
      assertEquals(cells(a), cells(sum));
      sum.include(b);
      assertTrue(cells(sum).containsAll(cells(a)));
      assertTrue(cells(sum).containsAll(cells(b)));
      if (b.isEmpty()) {
        assertEquals(cells(a), cells(sum));
      }
    }
  }

  @Test
  void growsOnEachSideUpToTheEndsOfTheRange() {
    IntBox box = box(1, 2, 3, 4, 5, 6);
    assertSame(box, box.grow(2));
    assertEquals("x -1-6, y 0-7, z 1-8", box.toString());
    int least = Integer.MIN_VALUE;
    int most = Integer.MAX_VALUE;
    IntBox wide = box(least + 1, least + 1, least + 1, most - 1, most - 1, most - 1).grow(2);
    assertEquals(least, wide.lowX);
    assertEquals(least, wide.lowY);
    assertEquals(least, wide.lowZ);
    assertEquals(most, wide.highX);
    assertEquals(most, wide.highY);
    assertEquals(most, wide.highZ);
  }
}
