package org.palpate.elastic;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.IntBox;
import org.palpate.volume.BitCube;

class FreePartsTest {
  private static final double STIFFNESS = 0.5;
  private static final double TOP = 32;

  /** A block of 16 x 16 x 24 voxels on a floor, in cells of four voxels. */
  private final ElasticTouch touch = touch(true);

  private static ElasticTouch touch(boolean floor) {
    BitCube soft = new BitCube(48, 48, 48);
    BitCube still = new BitCube(48, 48, 48);
    ElasticTouch.fill(soft, 16, 32, 16, 32, 8, (int) TOP);
    if (floor) {
      ElasticTouch.fill(still, 8, 40, 8, 40, 4, 8);
    }
    ElasticTouch.Scene scene = new ElasticTouch.Scene(soft, still, new GridMetric(1, 1, 1));
    ElasticTouch touch = new ElasticTouch(scene, 20e3, STIFFNESS, 4, false);
    touch.hand.set(24.3, 24.4, TOP + 3);
    touch.run();
    return touch;
  }

  /** Empties or fills voxels of the block from a height up to another. */
  private void edit(int low, int high, boolean solid) {
    for (int k = low; k < high; k++) {
      for (int j = 16; j < 32; j++) {
        for (int i = 16; i < 32; i++) {
          if (solid) {
            touch.soft.set(i, j, k);
          } else {
            touch.soft.clear(i, j, k);
          }
        }
      }
    }
    IntBox box = new IntBox();
    box.include(16, 16, low);
    box.include(31, 31, high - 1);
    touch.body.contact().edited(box);
  }

  /** Presses anew; the energy tank would lower the force of a hand that stays. */
  private void press(double depth) {
    touch.moveTo(24.3, 24.4, TOP + 3, 40);
    touch.moveTo(24.3, 24.4, TOP - depth, 70);
    touch.moveTo(24.3, 24.4, TOP - depth, 70);
  }

  @Test
  void aBlockThatIsCutFromItsFloorStandsStill() {
    press(3);
    double held = touch.frame.forceNewton().z;
    assertTrue(held < 0.8 * STIFFNESS * 3, "gives way, force " + held);
    assertEquals(0, touch.body.freeParts());
    edit(8, 16, false);
    press(3);
    assertEquals(1, touch.body.freeParts());
    assertEquals(STIFFNESS * 3, touch.frame.forceNewton().z, 0.05);
    assertEquals(0, TetrahedraJudge.folded(touch.lattice, touch.body.contact().map()));
    assertEquals(0, touch.body.counters().refused());
    assertTrue(touch.body.counters().worstResidual() < 2e-3);
  }

  @Test
  void aPartThatIsJoinedAgainGivesWayAgain() {
    press(3);
    double held = touch.frame.forceNewton().z;
    edit(8, 16, false);
    press(3);
    edit(8, 16, true);
    press(3);
    press(3); // The moduli of filled cells come back over several updates.
    assertEquals(0, touch.body.freeParts());
    assertEquals(held, touch.frame.forceNewton().z, 0.02);
  }

  @Test
  void bothHalvesOfACutAreCountedByTheirOwnSupport() {
    press(1);
    edit(20, 28, false);
    press(1);
    assertEquals(1, touch.body.freeParts());
    edit(8, 16, false);
    press(1);
    assertEquals(2, touch.body.freeParts());
  }

  @Test
  void aBodyWithoutSupportFromTheStartIsNotHeld() {
    ElasticTouch floating = touch(false);
    floating.soft.clear(16, 16, 8);
    IntBox box = new IntBox();
    box.include(16, 16, 8);
    floating.body.contact().edited(box);
    floating.moveTo(24.3, 24.4, TOP - 2, 70);
    floating.moveTo(24.3, 24.4, TOP - 2, 140);
    assertEquals(0, floating.body.freeParts());
    assertTrue(floating.frame.forceNewton().z < 0.8 * STIFFNESS * 2);
  }
}
