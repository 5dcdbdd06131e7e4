package org.palpate.reduction;

import org.junit.jupiter.api.Test;
import org.palpate.testing.HollowShaft;
import org.palpate.volume.fracture.FractureSpec;
import org.palpate.volume.fracture.FragmentCutter;
import org.palpate.volume.phantom.FracturePhantom;

/** Guided hands place the fragments of a tube and of the phantom's arch. */
class GuidedPlacementTest {
  private static final int PARTS = 4;

  @Test
  void aGuideLeadsAWrongHandToThePlaceInATubeAndLeavesARightOneThere() {
    GuidedHands.check(
        "tube",
        seed ->
            FragmentCutter.cut(
                HollowShaft.bits(), HollowShaft.GRID, new FractureSpec(PARTS, seed, 0)),
        0.3,
        1);
  }

  @Test
  void aGuideLeadsAWrongHandToThePlaceInAnArchAndLeavesARightOneThere() {
    GuidedHands.check(
        "arch",
        seed ->
            new FracturePhantom(FracturePhantom.DEFAULT_EDGE, new FractureSpec(PARTS, seed, 0))
                .fragments(),
        0.5,
        1.5);
  }
}
