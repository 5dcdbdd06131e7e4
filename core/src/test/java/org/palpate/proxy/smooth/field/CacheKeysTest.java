package org.palpate.proxy.smooth.field;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.Set;
import org.junit.jupiter.api.Test;

class CacheKeysTest {
  private final CacheKeys keys = new CacheKeys(4);

  @Test
  void neighboursHaveDifferentSlots() {
    Set<Integer> slots = new HashSet<>();
    for (int n = 0; n < 64; n++) {
      int slot = keys.slot(-3 + (n & 3), 5 + (n >> 2 & 3), 7 + (n >> 4));
      assertTrue(slot >= 0 && slot < keys.slots());
      slots.add(slot);
    }
    assertEquals(64, slots.size());
    assertEquals(64, keys.slots());
  }

  @Test
  void thePositionThatWasSetLastHoldsItsSlot() {
    int slot = keys.slot(1, -2, 3);
    assertFalse(keys.holds(slot, 1, -2, 3));
    assertFalse(keys.holdsElseSet(slot, 1, -2, 3));
    assertTrue(keys.holds(slot, 1, -2, 3));
    assertTrue(keys.holdsElseSet(slot, 1, -2, 3));
    for (int axis = 0; axis < 3; axis++) {
      int x = 1 + (axis == 0 ? 4 : 0);
      int y = -2 + (axis == 1 ? 4 : 0);
      int z = 3 + (axis == 2 ? 4 : 0);
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
}
