package org.palpate.elastic.lattice;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;

import java.util.Arrays;
import java.util.HashSet;
import java.util.Set;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class LatticeLayoutTest {
  private final LatticeLayout layout =
      new LatticeLayout(
          new int[3], new int[] {4, 4, 4}, new int[] {4, 3, 5}, new double[] {4, 4, 4});

  @Test
  void theNeighboursOfACellAreThoseThatShareANode() {
    int[] neighbours = new int[LatticeLayout.MOST_NEIGHBOURS];
    for (int cell = 0; cell < layout.cellCount(); cell++) {
      int count = layout.neighbours(cell, neighbours);
      Set<Integer> own = nodes(cell);
      int[] expected =
          IntStream.range(0, layout.cellCount())
              .filter(other -> nodes(other).stream().anyMatch(own::contains))
              .toArray();
      assertArrayEquals(expected, Arrays.copyOf(neighbours, count), "cell " + cell);
    }
  }

  private Set<Integer> nodes(int cell) {
    Set<Integer> nodes = new HashSet<>();
    for (int corner = 0; corner < LatticeLayout.CORNERS; corner++) {
      nodes.add(layout.firstNode(cell) + layout.cornerOffset(corner));
    }
    return nodes;
  }
}
