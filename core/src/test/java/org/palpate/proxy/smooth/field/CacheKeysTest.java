package org.palpate.proxy.smooth.field;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.IntBox;

class CacheKeysTest {
  private static final int EDGE = 16;

  private final CacheKeys keys = new CacheKeys(EDGE);

  @Test
  void neighboursHaveDifferentSlotsWhereverTheyLie() {
    Set<Integer> slots = new HashSet<>();
    for (int corner = 0; corner < EDGE * EDGE * EDGE; corner++) {
      slots.clear();
      for (int n = 0; n < 64; n++) {
        int x = corner % EDGE - 19 + (n & 3);
        int y = corner / EDGE % EDGE - 3 + (n >> 2 & 3);
        int z = corner / EDGE / EDGE + 29 + (n >> 4);
        int slot = keys.slot(x, y, z);
        assertTrue(slot >= 0 && slot < keys.slots());
        slots.add(slot);
      }
      assertEquals(64, slots.size(), "corner " + corner);
    }
  }

  @Test
  void aBlockHasAsManySlotsAsPositions() {
    Set<Integer> slots = new HashSet<>();
    for (int n = 0; n < EDGE * EDGE * EDGE; n++) {
      slots.add(keys.slot(n % EDGE - EDGE, n / EDGE % EDGE, n / EDGE / EDGE + 2 * EDGE));
    }
    assertEquals(keys.slots(), slots.size());
  }

  @Test
  void oppositeSidesOfAWideSolidHaveDifferentSlots() {
    for (int blocks = 1; blocks < EDGE; blocks++) {
      int far = blocks * EDGE;
      assertNotEquals(keys.slot(3, 5, 7), keys.slot(3 + far, 5, 7));
      assertNotEquals(keys.slot(3, 5, 7), keys.slot(3, 5 + far, 7));
      assertNotEquals(keys.slot(3, 5, 7), keys.slot(3, 5, 7 + far));
    }
  }

  @Test
  void thePositionThatWasSetLastHoldsItsSlot() {
    int slot = keys.slot(1, -2, 3);
    assertFalse(keys.holds(slot, 1, -2, 3));
    assertFalse(keys.holdsElseSet(slot, 1, -2, 3));
    assertTrue(keys.holds(slot, 1, -2, 3));
    assertTrue(keys.holdsElseSet(slot, 1, -2, 3));
    int far = EDGE * EDGE;
    for (int axis = 0; axis < 3; axis++) {
      int x = 1 + (axis == 0 ? far : 0);
      int y = -2 + (axis == 1 ? far : 0);
      int z = 3 + (axis == 2 ? far : 0);
      assertEquals(slot, keys.slot(x, y, z));
      assertFalse(keys.holds(slot, x, y, z));
      assertFalse(keys.holdsElseSet(slot, x, y, z));
      assertFalse(keys.holdsElseSet(slot, 1, -2, 3));
    }
  }

  @Test
  void noPositionOutlastsForget() {
    int slot = keys.slot(0, 0, 0);
    keys.holdsElseSet(slot, 0, 0, 0);
    keys.forget();
    assertFalse(keys.holdsElseSet(slot, 0, 0, 0));
  }

  @Test
  void aBoxForgetsItsPositionsAndKeepsTheOthers() {
    setAll();
    IntBox box = new IntBox();
    box.include(-1, 0, 1);
    box.include(0, 1, 1);
    keys.forget(box);
    for (int n = 0; n < 64; n++) {
      assertEquals(!box.contains(x(n), y(n), z(n)), holds(n), "position " + n);
    }
    setAll();
    for (int n = 0; n < 64; n++) {
      assertTrue(holds(n), "position " + n);
    }
  }

  @Test
  void aLargeBoxForgetsAllPositionsWhereverItLies() {
    setAll();
    IntBox box = new IntBox();
    box.include(1000, 1000, 1000);
    box.include(1015, 1015, 1015);
    assertFalse(CacheKeys.isLarge(box));
    box.include(1016, 1016, 1016);
    assertTrue(CacheKeys.isLarge(box));
    keys.forget(box);
    for (int n = 0; n < 64; n++) {
      assertFalse(holds(n), "position " + n);
    }
  }

  /** Sets 4x4x4 positions, which have different slots. */
  private void setAll() {
    for (int n = 0; n < 64; n++) {
      keys.holdsElseSet(keys.slot(x(n), y(n), z(n)), x(n), y(n), z(n));
    }
  }

  private boolean holds(int n) {
    return keys.holds(keys.slot(x(n), y(n), z(n)), x(n), y(n), z(n));
  }

  private static int x(int n) {
    return (n & 3) - 2;
  }

  private static int y(int n) {
    return n >> 2 & 3;
  }

  private static int z(int n) {
    return n >> 4;
  }
}
