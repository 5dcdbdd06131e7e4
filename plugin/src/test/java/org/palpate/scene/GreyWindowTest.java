package org.palpate.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class GreyWindowTest {
  private final GreyWindow own = new GreyWindow("own", 100, 50);

  @Test
  void thePresetsEndWithTheVolumesOwnContrast() {
    GreyWindow bone = GreyWindow.next(own, own);
    assertEquals(-500, bone.black());
    assertEquals(1500, bone.white());
    assertEquals("window 2000 level 500.0 (bone)", bone.toString());
    GreyWindow shown = bone;
    for (int n = 0; n < 3; n++) {
      shown = GreyWindow.next(shown, own);
      assertTrue(!shown.equals(own));
    }
    assertEquals(own, GreyWindow.next(shown, own));
  }

  @Test
  void aDragToTheRightWidensAndADragUpwardsRaisesTheLevel() {
    assertEquals(own.width() * 8, own.dragged(1, 0).width(), 1e-9);
    assertEquals(own.level() + 25, own.dragged(0, 0.5).level(), 1e-9);
    assertEquals(own, GreyWindow.next(own.dragged(0.1, 0), own), "a dragged window ends too");
  }
}
