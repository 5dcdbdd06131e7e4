package org.palpate.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class ChangedVoxelsTest {
  private final ChangedVoxels changed = new ChangedVoxels(3);
  private final List<String> seen = new ArrayList<>();

  private boolean remesh() {
    return changed.remesh((segment, box) -> seen.add(segment + ": " + box));
  }

  @Test
  void eachSegmentIsRebuiltOnceAroundWhatChanged() {
    assertFalse(remesh());
    changed.note(2, 5, 6, 7, true);
    changed.note(2, 1, 9, 7, false);
    changed.note(0, 3, 3, 3, true);
    assertTrue(remesh());
    assertEquals(List.of("0: x 3-3, y 3-3, z 3-3", "2: x 1-5, y 6-9, z 7-7"), seen);
    assertFalse(remesh());
    changed.note(2, 0, 0, 0, true);
    assertTrue(remesh());
    assertEquals("2: x 0-0, y 0-0, z 0-0", seen.get(2), "old changes are forgotten");
  }

  @Test
  void removedVoxelsCountAndAddedOnesCountAgainstThem() {
    changed.note(1, 0, 0, 0, false);
    changed.note(1, 1, 0, 0, false);
    changed.note(1, 2, 0, 0, true);
    remesh();
    changed.note(1, 3, 0, 0, false);
    assertEquals(2, changed.removed(1));
    assertEquals(0, changed.removed(0));
  }
}
