package org.palpate.benchmarks.stress;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.proxy.LegPath;
import org.palpate.raycast.Ray;
import org.palpate.volume.BitCube;

class ExactJudgeTest {
  private static final long SEED = Long.getLong("palpate.seed", 20_261_128);
  private static final int SIZE = 5;

  private final ExactJudge judge = new ExactJudge();

  private static BitCube dot() {
    BitCube bits = new BitCube(SIZE, SIZE, SIZE);
    bits.set(2, 2, 2);
    return bits;
  }

  private static Ray ray(double... ends) {
    return new Ray().from(ends[0], ends[1], ends[2]).to(ends[3], ends[4], ends[5]);
  }

  private boolean touchesDot(double... ends) {
    return judge.touches(dot(), ray(ends));
  }

  @Test
  void agreesWithClippingInExactFractionsOnHostileSegments() {
    SplittableRandom random = new SplittableRandom(SEED);
    ExactJudge unfiltered = ExactJudge.unfiltered();
    int touching = 0;
    for (int n = 0; n < 4_000; n++) {
      BitCube bits = new BitCube(random.nextInt(1, 6), random.nextInt(1, 6), random.nextInt(1, 6));
      for (int solid = 0; solid < 3; solid++) {
        bits.set(
            random.nextInt(bits.sizeX()),
            random.nextInt(bits.sizeY()),
            random.nextInt(bits.sizeZ()));
      }
      Ray ray =
          ray(
              hostile(random),
              hostile(random),
              hostile(random),
              hostile(random),
              hostile(random),
              hostile(random));
      boolean expected = NaiveSegment.touches(bits, ray);
      touching += expected ? 1 : 0;
      assertEquals(expected, judge.touches(bits, ray), () -> ray + " seed=" + SEED);
      assertEquals(expected, unfiltered.touches(bits, ray), () -> ray + " seed=" + SEED);
    }
    assertTrue(touching > 300 && touching < 3_700, "touching=" + touching);
    assertTrue(judge.exactDecisions() > 100, "few segments were close");
    assertTrue(unfiltered.exactDecisions() > judge.exactDecisions());
  }

  private static double hostile(SplittableRandom random) {
    double plane = random.nextInt(-1, SIZE + 2);
    return switch (random.nextInt(9)) {
      case 0, 1 -> plane;
      case 2 -> Math.nextUp(plane);
      case 3 -> Math.nextDown(plane);
      case 4 -> plane + 0.5;
      case 5 -> plane + random.nextInt(-2, 3) * 0x1p-40;
      case 6 -> random.nextInt(4) == 0 ? Math.scalb(random.nextDouble(-1, 1), 300) : plane;
      case 7 -> random.nextInt(4) == 0 ? Double.MIN_VALUE : -0.0;
      default -> random.nextDouble(-1, SIZE + 1);
    };
  }

  @Test
  void agreesOnSegmentsThatPassAnEdgeWithinRoundingErrors() {
    SplittableRandom random = new SplittableRandom(SEED);
    int touching = 0;
    for (int n = 0; n < 2_000; n++) {
      double x = random.nextDouble(0.1, 1.9);
      double y = random.nextDouble(0.1, 1.9);
      double back = random.nextDouble(0.1, 3);
      // a line through the edge at (2, 3), as far as doubles allow
      Ray ray = ray(2 - x, 3 - y, 2.25, 2 + back * x, 3 + back * y, 2.75);
      boolean expected = NaiveSegment.touches(dot(), ray);
      touching += expected ? 1 : 0;
      assertEquals(expected, judge.touches(dot(), ray), () -> ray + " seed=" + SEED);
    }
    assertTrue(touching > 300 && touching < 1_700, "touching=" + touching);
  }

  @Test
  void aSegmentThatEndsOnAFaceAnEdgeOrACornerTouchesAndOneUlpBeforeItDoesNot() {
    double before = Math.nextDown(2.0);
    assertTrue(touchesDot(0, 2.5, 2.5, 2, 2.5, 2.5));
    assertFalse(touchesDot(0, 2.5, 2.5, before, 2.5, 2.5));
    assertTrue(touchesDot(0, 0, 2.5, 2, 2, 2.5));
    assertFalse(touchesDot(0, 0, 2.5, before, before, 2.5));
    assertTrue(touchesDot(0, 0, 0, 2, 2, 2));
    assertFalse(touchesDot(0, 0, 0, before, 2, 2));
  }

  @Test
  void theFacesOnTheFarSideAreClosedToo() {
    double beyond = Math.nextUp(3.0);
    assertTrue(touchesDot(3, 0, 2.5, 3, 5, 2.5));
    assertFalse(touchesDot(beyond, 0, 2.5, beyond, 5, 2.5));
    assertTrue(touchesDot(2.5, 3, 3, 2.5, 4, 4));
    assertFalse(touchesDot(2.5, beyond, 3, 2.5, 4, 4));
  }

  @Test
  void aDiagonalThatGrazesAnEdgeTouchesAndOneAnUlpFartherDoesNot() {
    assertTrue(touchesDot(1, 3, 2.5, 3, 1, 2.5)); // through (2, 2)
    assertFalse(touchesDot(1, Math.nextDown(3), 2.5, 3, 1, 2.5));
    assertTrue(touchesDot(1, Math.nextUp(3), 2.5, 3, 1, 2.5));
  }

  @Test
  void aSegmentThatPassesTheVoxelInOneProjectionAloneIsApart() {
    double[] from = {1, 2.4, 2.5};
    double[] to = {2.4, 4, 2.6}; // at x = 2 it is at y = 3.5
    for (int axis = 0; axis < 3; axis++) {
      int x = axis;
      int y = (axis + 1) % 3;
      int z = (axis + 2) % 3;
      assertFalse(touchesDot(from[x], from[y], from[z], to[x], to[y], to[z]), "axis=" + axis);
      assertFalse(touchesDot(from[y], from[x], from[z], to[y], to[x], to[z]), "axis=" + axis);
    }
    assertTrue(touchesDot(1, 2.4, 2.5, 2.4, 2.9, 2.6));
  }

  @Test
  void aSegmentWithoutLengthTouchesTheVoxelAroundItAlone() {
    assertTrue(touchesDot(2.5, 2.5, 2.5, 2.5, 2.5, 2.5));
    assertTrue(touchesDot(3, 3, 3, 3, 3, 3));
    assertFalse(touchesDot(1.5, 2.5, 2.5, 1.5, 2.5, 2.5));
  }

  @Test
  void solidsAtTheRimAreFoundFromOutsideTheGrid() {
    BitCube bits = new BitCube(SIZE, SIZE, SIZE);
    bits.set(0, 0, 0);
    bits.set(SIZE - 1, SIZE - 1, SIZE - 1);
    assertTrue(judge.touches(bits, ray(-9, 0.5, 0.5, 0, 0.5, 0.5)));
    assertFalse(judge.touches(bits, ray(-9, 0.5, 0.5, -Double.MIN_VALUE, 0.5, 0.5)));
    assertTrue(judge.touches(bits, ray(SIZE, 4.5, 4.5, 1e300, 4.5, 4.5)));
    assertFalse(judge.touches(bits, ray(Math.nextUp(SIZE), 4.5, 4.5, 1e300, 4.5, 4.5)));
  }

  @Test
  void aLegIsJudgedAsTheRayBetweenItsEnds() {
    LegPath legs = new LegPath();
    legs.add(0, 2.5, 2.5, 1, 2.5, 2.5, 1, false);
    legs.add(1, 2.5, 2.5, 4, 2.5, 2.5, 3, false);
    assertFalse(judge.touches(dot(), legs, 0));
    assertTrue(judge.touches(dot(), legs, 1));
  }

  @Test
  void doublesDecideAboutSegmentsThatAreNotClose() {
    assertTrue(touchesDot(0.3, 0.4, 0.2, 4.1, 4.3, 4.4));
    assertEquals(0, judge.exactDecisions());
  }
}
