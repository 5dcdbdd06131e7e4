package org.palpate.elastic;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.palpate.elastic.lattice.ControlLattice;
import org.palpate.elastic.lattice.LatticeLayout;
import org.palpate.geometry.GridMetric;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;

class CellBoundsTest {
  private final Random random = new Random(Seeds.seed());
  private final ControlLattice lattice =
      ElasticTouch.softCube(new BitCube(16, 16, 16), 2, new GridMetric(1, 1, 1), 4);
  private final LatticeLayout layout = lattice.layout();
  private final DeformationField field = new DeformationField(DeformationField.Layout.of(lattice));
  private final CellBounds bounds = new CellBounds(layout);

  /** Values of very different sizes, so that the longest edges differ from cell to cell. */
  private void randomField(int slideIntervals) {
    for (int n = 0; n < field.whole.values.length; n++) {
      field.whole.values[n] =
          (float) (random.nextGaussian() * Math.pow(10, -3 * random.nextDouble()));
      field.whole.earlier[n] =
          (float) (random.nextGaussian() * Math.pow(10, -3 * random.nextDouble()));
    }
    field.slideIntervals = slideIntervals;
  }

  @Test
  void theBoundsAreTheLongestEdgesOfACellAlongEachAxis() {
    for (int slideIntervals : new int[] {0, 2}) {
      randomField(slideIntervals);
      bounds.read(field.whole, field.slideIntervals > 0);
      for (int cell = 0; cell < lattice.cells().count(); cell++) {
        int first = lattice.cells().firstNode(cell);
        double deviation = longest(field.whole.values, first, 0, 3);
        double answers = longest(field.whole.values, first, 3, DeformationField.STRIDE);
        if (slideIntervals > 0) {
          deviation = Math.max(deviation, longest(field.whole.earlier, first, 0, 3));
          answers =
              Math.max(answers, longest(field.whole.earlier, first, 3, DeformationField.STRIDE));
        }
        assertEquals(deviation, bounds.squaredDeviation(first), 1e-5 * deviation);
        assertEquals(answers, bounds.squaredAnswers(first), 1e-5 * answers);
      }
    }
  }

  private double longest(float[] values, int firstNode, int begin, int end) {
    double sum = 0;
    for (int axis = 0; axis < 3; axis++) {
      double most = 0;
      for (int corner = 0; corner < LatticeLayout.CORNERS; corner++) {
        if ((corner >> axis & 1) == 0) {
          int from = firstNode + layout.cornerOffset(corner);
          most =
              Math.max(
                  most, squared(values, from, from + layout.cornerOffset(1 << axis), begin, end));
        }
      }
      sum += most;
    }
    return sum;
  }

  private static double squared(float[] values, int from, int to, int begin, int end) {
    double sum = 0;
    for (int n = begin; n < end; n++) {
      double difference =
          (double) values[DeformationField.STRIDE * to + n]
              - values[DeformationField.STRIDE * from + n];
      sum += difference * difference;
    }
    return sum;
  }

  @Test
  void aValueThatIsNotFiniteIsInTheBoundsOfEachCellAround() {
    for (int component : new int[] {1, 7}) {
      randomField(0);
      int cell = random.nextInt(lattice.cells().count());
      int node = lattice.cells().firstNode(cell) + layout.cornerOffset(random.nextInt(8));
      field.whole.values[DeformationField.STRIDE * node + component] = Float.NaN;
      bounds.read(field.whole, field.slideIntervals > 0);
      int first = lattice.cells().firstNode(cell);
      double found = component < 3 ? bounds.squaredDeviation(first) : bounds.squaredAnswers(first);
      assertTrue(Double.isNaN(found), "component " + component + ": " + found);
    }
  }
}
