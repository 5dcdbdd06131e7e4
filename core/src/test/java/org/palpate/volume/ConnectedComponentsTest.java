package org.palpate.volume;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;
import org.palpate.testing.Seeds;
import org.palpate.volume.ConnectedComponents.Neighbours;

class ConnectedComponentsTest {
  private final SplittableRandom random = new SplittableRandom(Seeds.seed());

  @Test
  void agreesWithLabelsThatSpreadUntilNothingChanges() {
    for (int round = 0; round < 30; round++) {
      BitCube bits = scattered(3 + round % 9, 11, 6, 0.05 + 0.02 * round);
      for (Neighbours neighbours : Neighbours.values()) {
        List<BitCube> found = ConnectedComponents.of(bits, neighbours, 1);
        int[] labels = spreadLabels(bits, neighbours);
        long different = Arrays.stream(labels).filter(n -> n > 0).distinct().count();
        assertEquals(different, found.size());
        for (int v = 0; v < labels.length; v++) {
          int voxel = v;
          assertEquals(labels[v] > 0 ? 1 : 0, found.stream().filter(c -> at(c, voxel)).count());
        }
        for (BitCube component : found) {
          assertEquals(1, labelsIn(component, labels).distinct().count());
        }
      }
    }
  }

  @Test
  void ordersComponentsBySizeAndLeavesOutSmallOnes() {
    BitCube bits = scattered(20, 20, 20, 0.1);
    List<BitCube> all = ConnectedComponents.of(bits, Neighbours.FACES, 1);
    List<BitCube> some = ConnectedComponents.of(bits, Neighbours.FACES, 3);
    assertTrue(some.size() < all.size());
    for (int n = 0; n < some.size(); n++) {
      assertTrue(some.get(n).solidCount() >= 3);
      assertTrue(n == 0 || some.get(n).solidCount() <= some.get(n - 1).solidCount());
    }
    assertEquals(
        all.stream().filter(component -> component.solidCount() >= 3).count(), some.size());
    assertEquals(
        all.get(0).solidCount(), ConnectedComponents.largest(bits, Neighbours.FACES).solidCount());
  }

  @Test
  void voxelsThatShareACornerAreNeighboursOnlyOfTheWiderKind() {
    BitCube bits = new BitCube(4, 4, 4);
    bits.set(1, 1, 1);
    bits.set(2, 2, 2);
    assertEquals(2, ConnectedComponents.of(bits, Neighbours.FACES, 1).size());
    assertEquals(1, ConnectedComponents.of(bits, Neighbours.FACES_EDGES_CORNERS, 1).size());
  }

  @Test
  void theLargestComponentOfNothingIsEmpty() {
    BitCube bits = new BitCube(3, 4, 5);
    assertEquals(0, ConnectedComponents.largest(bits, Neighbours.FACES).solidCount());
    assertFalse(ConnectedComponents.of(bits, Neighbours.FACES, 0).iterator().hasNext());
  }

  private BitCube scattered(int sizeX, int sizeY, int sizeZ, double fraction) {
    BitCube bits = new BitCube(sizeX, sizeY, sizeZ);
    for (int v = 0; v < sizeX * sizeY * sizeZ; v++) {
      if (random.nextDouble() < fraction) {
        bits.set(v % sizeX, v / sizeX % sizeY, v / sizeX / sizeY);
      }
    }
    return bits;
  }

  private static boolean at(BitCube bits, int v) {
    return bits.get(
        v % bits.sizeX(), v / bits.sizeX() % bits.sizeY(), v / bits.sizeX() / bits.sizeY());
  }

  private static LongStream labelsIn(BitCube component, int[] labels) {
    return LongStream.range(0, labels.length)
        .filter(v -> at(component, (int) v))
        .map(v -> labels[(int) v]);
  }

  /** Returns the least number of a voxel that each solid voxel is connected to, from 1; else 0. */
  private static int[] spreadLabels(BitCube bits, Neighbours neighbours) {
    int count = bits.sizeX() * bits.sizeY() * bits.sizeZ();
    int[] labels = new int[count];
    for (int v = 0; v < count; v++) {
      labels[v] = at(bits, v) ? v + 1 : 0;
    }
    boolean changed = true;
    while (changed) {
      changed = false;
      for (int v = 0; v < count; v++) {
        for (int w = 0; w < count; w++) {
          if (labels[v] > 0
              && labels[w] > 0
              && labels[w] < labels[v]
              && near(bits, v, w, neighbours)) {
            labels[v] = labels[w];
            changed = true;
          }
        }
      }
    }
    return labels;
  }

  private static boolean near(BitCube bits, int v, int w, Neighbours neighbours) {
    int dx = Math.abs(v % bits.sizeX() - w % bits.sizeX());
    int dy = Math.abs(v / bits.sizeX() % bits.sizeY() - w / bits.sizeX() % bits.sizeY());
    int dz = Math.abs(v / bits.sizeX() / bits.sizeY() - w / bits.sizeX() / bits.sizeY());
    return neighbours == Neighbours.FACES ? dx + dy + dz == 1 : Math.max(dx, Math.max(dy, dz)) == 1;
  }
}
