package org.palpate.testing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.raycast.Ray;
import org.palpate.volume.BitCube;

/** The judge of the guarantee finds each way in which a frame can break it; one voxel is solid. */
class LegJudgeTest {
  private static final Vec3 START = new Vec3(0.5, 0.5, 0.5);

  private final BitCube bits = new BitCube(6, 6, 6);
  private final InteractionPoint point = new InteractionPoint();
  private final LegJudge judge;

  LegJudgeTest() {
    bits.set(2, 2, 2);
    point.position.set(START);
    judge = new LegJudge(bits, START);
  }

  private void leg(double x, double y, double z) {
    Vec3 p = point.position;
    point.legs.add(p.x, p.y, p.z, x, y, z, 1, false);
    p.set(x, y, z);
  }

  private String nextFault() {
    String fault = judge.faultOf(point);
    point.legs.clear();
    return fault;
  }

  @Test
  void aChainBesideTheVoxelIsFree() {
    leg(4.5, 0.5, 0.5);
    leg(4.5, 4.5, 0.5);
    assertNull(nextFault());
    leg(4.5, 4.5, 4.5);
    assertNull(nextFault());
    assertEquals(3, judge.legCount());
    assertNull(nextFault(), "a frame that rests");
    assertEquals(3, judge.legCount());
  }

  @Test
  void aLegThatTouchesTheVoxelAtACornerAloneIsFound() {
    leg(2, 2, 2);
    assertTrue(nextFault().startsWith("leg 0 touches a solid"));
  }

  @Test
  void aLegThatStopsOneStepBeforeTheCornerIsFree() {
    leg(2, 2, Math.nextDown(2.0));
    assertNull(nextFault());
  }

  @Test
  void theLegThatTouchesIsNamed() {
    leg(0.5, 2.5, 0.5);
    leg(0.5, 2.5, 2.5);
    leg(5, 2.5, 2.5);
    assertTrue(nextFault().startsWith("leg 2 touches a solid"));
  }

  @Test
  void aChainThatIsBrokenByOneStepOfADoubleIsFound() {
    leg(1, 0.5, 0.5);
    assertNull(nextFault());
    point.position.y = Math.nextUp(0.5);
    leg(1.5, 0.5, 0.5);
    assertTrue(nextFault().startsWith("leg 0 starts at"));
  }

  @Test
  void aChainThatIsBrokenWithinAFrameIsFound() {
    leg(1, 0.5, 0.5);
    point.position.z = 0.75;
    leg(1.5, 0.5, 0.75);
    assertTrue(nextFault().startsWith("leg 1 starts at"));
  }

  @Test
  void aPointThatIsNotAtTheEndOfItsLegsIsFound() {
    leg(1, 0.5, 0.5);
    point.position.x = Math.nextUp(1.0);
    assertTrue(nextFault().startsWith("point "));
  }

  @Test
  void zerosOfDifferentSignsAreDifferentEnds() {
    leg(0.0, 0.5, 0.5);
    assertNull(nextFault());
    point.position.x = -0.0;
    assertTrue(nextFault().startsWith("point "));
  }

  @Test
  void afterAFaultTheChainGoesOnWhereTheLastFreeLegEnded() {
    leg(2, 2, 2);
    assertNotNull(nextFault());
    leg(1, 0.5, 0.5);
    assertTrue(nextFault().startsWith("leg 0 starts at"), "the corner is not where it ended");
    point.position.set(START);
    leg(1, 0.5, 0.5);
    assertNull(nextFault());
  }

  /** Both oracles decide exactly, in different ways, whether one leg touches. */
  @Test
  void agreesWithTheOtherOracleOnLegsAnywhere() {
    SplittableRandom random = new SplittableRandom(Seeds.seed());
    FilteredOracle oracle = new FilteredOracle();
    for (int n = 0; n < 8; n++) {
      bits.set(random.nextInt(6), random.nextInt(6), random.nextInt(6));
    }
    int touching = 0;
    for (int n = 0; n < 3_000; n++) {
      Ray ray = new Ray().from(place(random), place(random), place(random));
      ray.to(place(random), place(random), place(random));
      Vec3 start = new Vec3(ray.fromX, ray.fromY, ray.fromZ);
      point.position.set(start);
      leg(ray.toX, ray.toY, ray.toZ);
      String fault = new LegJudge(bits, start).faultOf(point);
      point.legs.clear();
      boolean expected = oracle.touchesAny(bits, ray);
      touching += expected ? 1 : 0;
      assertEquals(expected, fault != null, ray::toString);
    }
    assertTrue(touching > 500 && touching < 2_500, "touching: " + touching);
  }

  private static double place(SplittableRandom random) {
    return random.nextInt(3) == 0 ? random.nextInt(-1, 8) : random.nextDouble(-1, 7);
  }
}
