package org.palpate.body;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.IntBox;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;

class GrownSolidsTest {
  private final SplittableRandom random = new SplittableRandom(Seeds.seed());

  @Test
  void holdsExactlyTheCellsThatAreNearerThanTheGrowth() {
    for (double cell = 2; cell > 0.2; cell /= 2) {
      for (double growth : new double[] {0.3, 0.866, 1, 1.2}) {
        for (GridMetric metric : metrics()) {
          BitCube bits = RandomSolids.clutter(random, 7, 8, 6);
          assertIsGrown(bits, new GrownSolids(bits, metric, growth, cell));
        }
      }
    }
  }

  @Test
  void growsByOneCellIfTheGrowthIsOneCell() {
    BitCube bits = new BitCube(3, 3, 3);
    bits.set(0, 1, 2);
    GrownSolids grown = new GrownSolids(bits, new GridMetric(1, 1, 1), 1, 1);
    assertEquals(27, grown.cells().solidCount());
    assertEquals(1, grown.padVoxels());
  }

  @Test
  void followsVoxelsThatAreAddedAndRemoved() {
    for (GridMetric metric : metrics()) {
      BitCube bits = RandomSolids.clutter(random, 12, 9, 8);
      GrownSolids grown = new GrownSolids(bits, metric, 0.9, 0.6);
      assertTrue(GrowthStencil.of(grown).isPresent());
      for (int edit = 0; edit < 10; edit++) {
        grown.update(editBox(bits));
        assertIsGrown(bits, grown);
      }
    }
  }

  @Test
  void followsVoxelsAlsoWhereTheStencilWouldBeTooLarge() {
    BitCube bits = RandomSolids.clutter(random, 5, 4, 4);
    GrownSolids grown = new GrownSolids(bits, new GridMetric(1, 1, 1), 0.3, 0.13);
    assertEquals(Optional.empty(), GrowthStencil.of(grown));
    for (int edit = 0; edit < 4; edit++) {
      grown.update(editBox(bits));
      assertIsGrown(bits, grown);
    }
  }

  private IntBox editBox(BitCube bits) {
    IntBox box = new IntBox();
    int i = random.nextInt(bits.sizeX() - 3);
    int j = random.nextInt(bits.sizeY() - 3);
    int k = random.nextInt(bits.sizeZ() - 3);
    box.include(i, j, k);
    box.include(i + 2, j + 2, k + 2);
    for (int n = 0; n < 27; n++) {
      if (random.nextBoolean()) {
        bits.set(i + n % 3, j + n / 3 % 3, k + n / 9);
      } else {
        bits.clear(i + n % 3, j + n / 3 % 3, k + n / 9);
      }
    }
    return box;
  }

  @Test
  void cutsLongEdgesSoThatCellsAreAboutCubes() {
    GrownSolids grown = new GrownSolids(new BitCube(3, 3, 3), new GridMetric(1, 2, 5), 0.9, 1);
    assertEquals(1, grown.parts(0));
    assertEquals(2, grown.parts(1));
    assertEquals(8, grown.parts(2));
    assertEquals(0.625, grown.cellMm(2));
  }

  @Test
  void rejectsWhatIsNoDistance() {
    GridMetric metric = new GridMetric(1, 1, 1);
    BitCube bits = new BitCube(3, 3, 3);
    assertThrows(IllegalArgumentException.class, () -> new GrownSolids(bits, metric, 0, 1));
    assertThrows(
        IllegalArgumentException.class, () -> new GrownSolids(bits, metric, Double.NaN, 1));
    assertThrows(IllegalArgumentException.class, () -> new GrownSolids(bits, metric, 1, 0));
  }

  private static GridMetric[] metrics() {
    return new GridMetric[] {
      new GridMetric(1, 1, 1), new GridMetric(1, 0.7, 5), new GridMetric(0.4, 0.4, 0.4)
    };
  }

  private static void assertIsGrown(BitCube bits, GrownSolids grown) {
    int padX = grown.padVoxels() * grown.parts(0);
    int padY = grown.padVoxels() * grown.parts(1);
    int padZ = grown.padVoxels() * grown.parts(2);
    BitCube cells = grown.cells();
    for (int k = 0; k < cells.sizeZ(); k++) {
      for (int j = 0; j < cells.sizeY(); j++) {
        for (int i = 0; i < cells.sizeX(); i++) {
          double distance = distance(bits, grown, i - padX, j - padY, k - padZ);
          boolean expected = distance < grown.growthMm();
          if (expected != cells.get(i, j, k)) {
            fail("cell " + i + " " + j + " " + k + " is " + !expected);
          }
        }
      }
    }
  }

  private static double distance(BitCube bits, GrownSolids grown, int cellX, int cellY, int cellZ) {
    double least = Double.POSITIVE_INFINITY;
    for (int k = 0; k < bits.sizeZ(); k++) {
      for (int j = 0; j < bits.sizeY(); j++) {
        for (int i = 0; i < bits.sizeX(); i++) {
          if (bits.get(i, j, k)) {
            double x = gapMm(grown, 0, cellX, i);
            double y = gapMm(grown, 1, cellY, j);
            double z = gapMm(grown, 2, cellZ, k);
            least = Math.min(least, Math.sqrt(x * x + y * y + z * z));
          }
        }
      }
    }
    return least;
  }

  private static double gapMm(GrownSolids grown, int axis, int cell, int voxel) {
    int first = voxel * grown.parts(axis);
    int last = first + grown.parts(axis) - 1;
    return grown.cellMm(axis) * Math.max(0, Math.max(cell - last, first - cell) - 1);
  }
}
