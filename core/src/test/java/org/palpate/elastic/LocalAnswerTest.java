package org.palpate.elastic;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.palpate.elastic.lattice.ControlLattice;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;

class LocalAnswerTest {
  private final Random random = new Random(Seeds.seed());

  /** At the force that is found, the spring pulls as hard as the material is pressed. */
  @Test
  void theSpringAndTheMaterialBalance() {
    ControlLattice lattice =
        ElasticTouch.softCube(new BitCube(8, 8, 8), 2, new GridMetric(0.5, 1, 2), 2);
    for (int n = 0; n < 200; n++) {
      float[] values = new float[DeformationField.STRIDE];
      for (int i = 0; i < values.length; i++) {
        boolean diagonal = i == 3 || i == 7 || i == 11;
        values[i] = (float) ((diagonal ? 3 : 0) + random.nextDouble());
      }
      double[] base = {random.nextGaussian(), random.nextGaussian(), random.nextGaussian()};
      LocalAnswer answer = new LocalAnswer();
      answer.clear(base);
      answer.add(0.25, values, 0, lattice.layout());
      answer.add(0.75, values, 0, lattice.layout());
      Vec3 reach = new Vec3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian());
      double k = Math.pow(10, -1 + 2 * random.nextDouble());
      Vec3 force = new Vec3();
      answer.balance(reach, k, force);
      for (int row = 0; row < 3; row++) {
        double edge = lattice.layout().edgeMm(row);
        double moved = edge * values[row];
        for (int axis = 0; axis < 3; axis++) {
          moved += edge * values[3 + 3 * axis + row] * (force.get(axis) - base[axis]);
        }
        assertEquals(
            k * (reach.get(row) - moved), force.get(row), 1e-9 * k * (1 + Math.abs(moved)));
      }
    }
  }
}
