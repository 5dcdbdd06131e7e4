package org.palpate.elastic.lattice;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;

class CellMatterTest {
  private static final LatticeLayout LAYOUT =
      new LatticeLayout(
          new int[] {2, 0, 1}, new int[] {8, 5, 4}, new int[] {2, 2, 2}, new double[] {8, 5, 4});

  private final Random random = new Random(Seeds.seed());
  private final CellMatter matter = new CellMatter(LAYOUT);
  private final BitCube bits = new BitCube(24, 16, 16);

  private void fill(int x0, int x1, int y0, int y1, int z0, int z1) {
    for (int k = z0; k < z1; k++) {
      for (int j = y0; j < y1; j++) {
        for (int i = x0; i < x1; i++) {
          bits.set(i, j, k);
        }
      }
    }
  }

  @Test
  void aFullCellHasAllMomentsAndAnEmptyOneCountsAsFull() {
    fill(2, 10, 0, 5, 1, 5);
    matter.begin(0);
    matter.add(bits, 3);
    assertEquals(3, matter.modulus(), 1e-12);
    assertEquals(1, matter.share());
    for (int axis = 0; axis < 3; axis++) {
      assertEquals(1, matter.moment(axis), 1e-12);
    }
    matter.begin(1);
    matter.add(bits, 3);
    assertEquals(0, matter.modulus());
    assertEquals(1, matter.moment(2));
  }

  @Test
  void aLayerHasTheSquareOfItsPartWhereverItLies() {
    fill(5, 7, 0, 5, 1, 5);
    matter.begin(0);
    matter.add(bits, 2);
    assertEquals(0.5, matter.modulus(), 1e-12);
    assertEquals(Math.pow(2.0 / 8, 2), matter.moment(0), 1e-12);
    assertEquals(1, matter.moment(1), 1e-12);
    assertEquals(1, matter.moment(2), 1e-12);
  }

  @Test
  void twoLayersWithAGapDoNotBendAsASandwich() {
    fill(2, 3, 0, 5, 1, 5);
    fill(9, 10, 0, 5, 1, 5);
    matter.begin(0);
    matter.add(bits, 1);
    assertEquals(1, matter.moment(0));
  }

  /** The plain reference integrates the square of the distance from the centre over sub-voxels. */
  @Test
  void momentsAreThoseOfFineSamples() {
    for (int n = 0; n < 400; n++) {
      bits.set(2 + random.nextInt(8), random.nextInt(5), 1 + random.nextInt(4));
      matter.begin(0);
      matter.add(bits, 1.5);
      for (int axis = 0; axis < 3 && n % 40 == 0; axis++) {
        assertEquals(Math.min(1, sampled(axis)), matter.moment(axis), 1e-4, "axis " + axis);
      }
    }
  }

  private double sampled(int axis) {
    int parts = 100;
    double count = 0;
    double first = 0;
    double second = 0;
    for (int k = 1; k < 5; k++) {
      for (int j = 0; j < 5; j++) {
        for (int i = 2; i < 10; i++) {
          for (int part = 0; part < parts && bits.get(i, j, k); part++) {
            double at = new int[] {i, j, k}[axis] + (part + 0.5) / parts;
            count++;
            first += at;
            second += at * at;
          }
        }
      }
    }
    double mean = first / count;
    double edge = LAYOUT.voxelsPerCell(axis);
    return 12 * (second / count - mean * mean) / (edge * edge);
  }
}
