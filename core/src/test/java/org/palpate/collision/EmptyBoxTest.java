package org.palpate.collision;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;

/** Checks the quick test of short segments where cells have no number. */
class EmptyBoxTest {
  private final BitCube bits = new BitCube(8, 8, 8);

  @Test
  void aSegmentToACellWithoutANumberIsNotShort() {
    for (double start : new double[] {-3.5, 0.5, 3.5}) {
      Vec3 from = new Vec3(start, start, start);
      assertTrue(holds(from, from));
      for (double far : new double[] {-0x1p330, -1e12, -0x1p31, 0x1p31, 1e12, Double.MAX_VALUE}) {
        for (int axis = 0; axis < 3; axis++) {
          Vec3 to = new Vec3().set(from);
          to.set(axis, far);
          assertFalse(holds(from, to), from + " to " + to);
        }
      }
    }
  }

  private boolean holds(Vec3 from, Vec3 to) {
    return EmptyBox.holds(bits, from.x, from.y, from.z, to.x, to.y, to.z);
  }
}
