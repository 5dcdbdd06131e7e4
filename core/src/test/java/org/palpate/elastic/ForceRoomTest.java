package org.palpate.elastic;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class ForceRoomTest {
  private final ForceRoom room = new ForceRoom();

  private double[] clipped(double... change) {
    assertTrue(room.clip(change));
    return change;
  }

  @Test
  void leavesAChangeWithinAConeAsItIs() {
    room.begin(0, 0, 1);
    room.add(0, 2, 1);
    double[] change = {0.25, 0, -1.5};
    assertFalse(room.clip(change));
    assertArrayEquals(new double[] {0.25, 0, -1.5}, change);
  }

  @Test
  void movesAChangeTowardsTheConeThatLosesTheLeast() {
    room.begin(0, 0, 1);
    room.add(0, 2, 1);
    room.add(2, 2, 1);
    assertArrayEquals(new double[] {0, 0, -2}, clipped(0, 0, -4));
    assertArrayEquals(new double[] {0, 0, 4}, clipped(0, 0, 7));
    assertArrayEquals(new double[] {1, 0, 2}, clipped(5, 0, 2));
  }

  @Test
  void keepsNoChangeWithoutACone() {
    room.begin(0, 0, 1);
    assertArrayEquals(new double[3], clipped(1, 2, 3));
  }

  @Test
  void noChangeIsNotMovedEvenWithoutACone() {
    room.begin(0, 0, 1);
    assertFalse(room.clip(new double[3]));
  }

  @Test
  void keepsNoChangeThatIsNotFinite() {
    room.begin(0, 0, 1);
    room.add(0, 2, 1);
    for (double bad : new double[] {Double.NaN, Double.POSITIVE_INFINITY, 1e200}) {
      assertArrayEquals(new double[3], clipped(bad, 0, 0));
      assertArrayEquals(new double[3], clipped(0, -bad, bad));
    }
  }
}
