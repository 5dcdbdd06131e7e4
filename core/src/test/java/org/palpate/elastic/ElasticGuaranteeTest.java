package org.palpate.elastic;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.OptionalDouble;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.palpate.edit.BrushEdit;
import org.palpate.force.ForceSettings;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.testing.LegJudge;
import org.palpate.testing.Seeds;

/**
 * Attacks elastic segments with a wild hand that tears away, edits, and updates that stall. Legs
 * and tetrahedra are judged in exact arithmetic.
 */
class ElasticGuaranteeTest {
  private static final int FRAMES = 4000;
  private static final double TORN_AWAY = 1e9;

  private final Random random = new Random(Seeds.seed());

  @ParameterizedTest
  @CsvSource({
    "1, 1, 1, 20e3, 0.5, 8, , false, false",
    "1, 1, 1, 20e3, 0.5, 8, , true, false",
    "1, 1, 1, 5e3, 2, 8, , true, true",
    "1, 1, 1, 5e3, 2, 8, , false, true",
    "1, 1, 2, 20e3, 0.5, 9, , true, true",
    "0.4, 0.9, 0.7, 50e3, 1, 5, , false, true",
    "1, 1, 1, 20e3, 0.5, 8, 8, true, false",
    "1, 1, 1, 5e3, 2, 8, 8, false, true",
    "1, 1, 2, 20e3, 0.5, 8, 5, true, true",
  })
  void noLegTouchesAVoxelAndNoTetrahedronFolds(
      double sx,
      double sy,
      double sz,
      double young,
      double k,
      double edge,
      Double radius,
      boolean smooth,
      boolean edits) {
    ElasticTouch touch =
        new ElasticTouch(
            ElasticTouch.Scene.block(new GridMetric(sx, sy, sz)),
            young,
            ForceSettings.of(k, 0),
            edge,
            radius == null ? OptionalDouble.empty() : OptionalDouble.of(radius),
            smooth);
    touch.hand.set(48.3, 48.4, 55);
    touch.run();
    LegJudge judge = new LegJudge(touch.soft, touch.frame.point().position);
    LegJudge still = new LegJudge(touch.still, touch.frame.point().position);
    Vec3 goal = new Vec3().set(touch.hand);
    double speed = 0.1;
    int stalled = 0;
    long tetrahedra = 0;
    int windows = 0;
    for (int n = 0; n < FRAMES; n++) {
      if (random.nextInt(150) == 0) {
        goal.set(
            10 + 76 * random.nextDouble(), 10 + 76 * random.nextDouble(), 68 * random.nextDouble());
        speed = Math.pow(10, -2 + 2.2 * random.nextDouble());
      }
      if (random.nextInt(2000) == 0 || touch.hand.length() > TORN_AWAY / 2) {
        touch.hand.set(goal);
      }
      moveTowards(touch.hand, goal, speed);
      if (random.nextInt(2000) == 0) {
        touch.hand.set(-TORN_AWAY, touch.hand.y, TORN_AWAY);
      }
      if (stalled == 0 && random.nextInt(700) == 0) {
        stalled = random.nextInt(300);
      }
      if (edits && n % 97 == 96) {
        drillOrFill(touch);
      }
      if (stalled > 0) {
        stalled--;
        touch.runWithoutUpdate();
      } else {
        touch.run();
      }
      if (touch.frame.wasFreed()) {
        Vec3 start = startOfLegs(touch);
        judge = new LegJudge(touch.soft, start);
        still = new LegJudge(touch.still, start);
      }
      assertNull(judge.faultOf(touch.frame.point()), "frame " + n);
      assertNull(still.faultOf(touch.frame.point()), "frame " + n);
      if (n % 500 == 250) {
        assertEquals(0, TetrahedraJudge.folded(touch.lattice, touch.body.contact().map()));
        assertEquals(0, TetrahedraJudge.gaps(touch.lattice, touch.body.contact().map().field()));
        windows += touch.body.contact().map().field().hasWindow() ? 1 : 0;
        tetrahedra += 6L * touch.body.hexahedra();
      }
    }
    UpdateCounters counts = touch.body.counters();
    System.out.printf(
        "%d hexes, %d legs since the last release, %d tetrahedra, %d updates, %d scaled back, %d"
            + " refused, %d windowless, residual %.1e, clipped %d, %d windows%n",
        touch.body.hexahedra(),
        judge.legCount(),
        tetrahedra,
        counts.updates(),
        counts.scaledBack(),
        counts.refused(),
        counts.windowless(),
        counts.worstResidual(),
        touch.body.contact().clippedFrames(),
        windows);
    assertTrue(tetrahedra > 0);
    assertEquals(radius != null, windows > 0);
    assertEquals(0, counts.refused());
  }

  private static void moveTowards(Vec3 hand, Vec3 goal, double speed) {
    Vec3 way = goal.sub(hand, new Vec3());
    double length = way.length();
    way.mul(length < speed ? 1 : speed / length, way);
    hand.add(way, hand);
  }

  private void drillOrFill(ElasticTouch touch) {
    Vec3 p = touch.frame.point().position;
    boolean drill = random.nextInt(3) > 0;
    Vec3 centre =
        drill
            ? p
            : new Vec3(
                16 + 64 * random.nextDouble(),
                16 + 64 * random.nextDouble(),
                8 + 50 * random.nextDouble());
    touch.edits.offer(new BrushEdit(0, centre, 3, !drill));
  }

  private static Vec3 startOfLegs(ElasticTouch touch) {
    var legs = touch.frame.point().legs;
    return legs.count() == 0
        ? new Vec3().set(touch.frame.point().position)
        : new Vec3(legs.start(0, 0), legs.start(0, 1), legs.start(0, 2));
  }
}
