package org.palpate.raycast;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.testing.RandomCases;
import org.palpate.testing.Seeds;

class AxisTraversalTest {
  private final AxisTraversal axis = new AxisTraversal();

  @Test
  void goesUpFromPlaneToPlane() {
    axis.begin(2.5, 6.5, 99);
    assertCell(1, 2, 0.5 / 4);
    axis.advance();
    assertCell(1, 3, 1.5 / 4);
    axis.advance();
    assertCell(1, 4, 2.5 / 4);
  }

  @Test
  void goesDownFromPlaneToPlane() {
    axis.begin(6.5, 2.5, 99);
    assertCell(-1, 6, 0.5 / 4);
    axis.advance();
    assertCell(-1, 5, 1.5 / 4);
  }

  @Test
  void startsInTheCellBehindAPlaneAndCrossesItAtOnce() {
    axis.begin(3, 7, 99);
    assertCell(1, 2, 0);
    axis.begin(3, -1, 99);
    assertCell(-1, 3, 0);
  }

  @Test
  void staysInItsLayerIfTheRayDoesNotMoveAlongTheAxis() {
    axis.begin(3, 3, 2);
    assertCell(0, 2, Double.POSITIVE_INFINITY);
    assertEquals(Double.POSITIVE_INFINITY, axis.exit(2));
    axis.skipTo(0.5, 2);
    axis.skipTo(0.5, 7, 9);
    assertCell(0, 2, Double.POSITIVE_INFINITY);
  }

  @Test
  void knowsWhichPlanesTheRayStartsBefore() {
    axis.begin(3, 7, 99);
    assertTrue(axis.startsBefore(4));
    assertFalse(axis.startsBefore(3));
    axis.begin(3, -1, 99);
    assertTrue(axis.startsBefore(2));
    assertFalse(axis.startsBefore(3));
  }

  @Test
  void leavesTheCubeOfItsCellAtTheFarFace() {
    axis.begin(2.5, 18.5, 99);
    assertEquals(1.5 / 16, axis.exit(2), "the brick ends at 4");
    assertEquals(13.5 / 16, axis.exit(4), "the block ends at 16");
    axis.begin(18.5, 2.5, 99);
    assertEquals(2.5 / 16, axis.exit(2), "the brick ends at 16");
    assertEquals(2.5 / 16, axis.exit(4), "so does the block");
    axis.advance();
    assertEquals(2.5 / 16, axis.exit(2));
  }

  /** Up from 0.5 by 16 voxels, plane n is crossed at (n - 0.5) / 16. */
  @Test
  void skipsUpToTheLastCellWhosePlaneAheadIsNotSurelyCrossed() {
    assertSkipsUpTo(0, 0);
    assertSkipsUpTo(2, 1.6);
    assertSkipsUpTo(2, 2.5);
    assertSkipsUpTo(2, 2.5 * (1 + 0x1p-50)); // a difference below the doubt
    assertSkipsUpTo(3, 2.5 * (1 + 0x1p-46));
    assertSkipsUpTo(3, 3.5);
    assertSkipsUpTo(3, 9); // the brick ends there
  }

  private void assertSkipsUpTo(int cell, double voxels) {
    axis.begin(0.5, 16.5, 99);
    axis.skipTo(voxels / 16, 2);
    assertCell(1, cell, (cell + 0.5) / 16);
  }

  /** Down from 15.5 by 16 voxels, plane n is crossed at (15.5 - n) / 16. */
  @Test
  void skipsDownToTheLastCellWhosePlaneAheadIsNotSurelyCrossed() {
    assertSkipsDownTo(15, 0);
    assertSkipsDownTo(13, 1.6);
    assertSkipsDownTo(13, 2.5);
    assertSkipsDownTo(12, 2.5 * (1 + 0x1p-46));
    assertSkipsDownTo(12, 9);
  }

  private void assertSkipsDownTo(int cell, double voxels) {
    axis.begin(15.5, -0.5, 99);
    axis.skipTo(voxels / 16, 2);
    assertCell(-1, cell, (15.5 - cell) / 16);
  }

  @Test
  void skipsNoFartherThanTheGivenPlanes() {
    axis.begin(0.5, 16.5, 99);
    axis.skipTo(0, 3, 6);
    assertCell(1, 2, 2.5 / 16);
    axis.skipTo(1, 3, 6);
    assertCell(1, 5, 5.5 / 16);
    axis.skipTo(4.2 / 16, 3, 6);
    assertCell(1, 4, 4.5 / 16);
    axis.begin(15.5, -0.5, 99);
    axis.skipTo(0, 12, 9);
    assertCell(-1, 12, 3.5 / 16);
    axis.skipTo(1, 12, 9);
    assertCell(-1, 9, 6.5 / 16);
  }

  /** The position at a crossing may round to either side of its plane. */
  @Test
  void skipsBeforeTheFirstPlaneThatIsNotSurelyCrossedAlthoughPositionsAreRounded() {
    long seed = Seeds.seed();
    SplittableRandom random = new SplittableRandom(seed);
    for (int n = 0; n < RandomCases.of(50_000); n++) {
      double from = random.nextDouble(-20, 20);
      double to = random.nextBoolean() ? random.nextDouble(21, 40) : random.nextDouble(-40, -21);
      int last = to > from ? 21 : -21;
      axis.begin(from, to, 99);
      int first = axis.step > 0 ? axis.cell + 1 : axis.cell;
      double crossing = axis.crossing(random.nextInt(Math.min(first, last), Math.max(first, last)));
      double roundings = random.nextInt(-3, 4) * Math.ulp(crossing);
      double t = crossing + AxisTraversal.doubt(crossing) + roundings;
      axis.skipTo(t, first, last);
      double sure = t - AxisTraversal.doubt(t);
      int plane = axis.step > 0 ? axis.cell + 1 : axis.cell;
      String what = "seed=" + seed + " case " + n;
      assertTrue(plane == last || axis.crossing(plane) >= sure, what);
      assertTrue(plane == first || axis.crossing(plane - axis.step) < sure, what);
    }
  }

  @Test
  void theDoubtGrowsWithTheParameter() {
    assertEquals(0x1p-48, AxisTraversal.doubt(1));
    assertEquals(0x1p-40, AxisTraversal.doubt(256));
    assertEquals(0x1p-1000, AxisTraversal.doubt(0));
  }

  private void assertCell(int step, int cell, double next) {
    assertEquals(step, axis.step);
    assertEquals(cell, axis.cell);
    assertEquals(next, axis.next + 0.0); // -0.0 is 0
  }
}
