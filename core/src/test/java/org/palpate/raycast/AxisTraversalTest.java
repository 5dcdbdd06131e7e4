package org.palpate.raycast;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

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

  /** Far out the position is a guess that is wrong by several cells. */
  @Test
  void crossingsCorrectAPositionThatRoundingMoves() {
    double from = 0x1p52 + 1;
    axis.begin(from, -from, 99);
    for (int plane = 20; plane >= -20; plane--) {
      double t = axis.crossing(plane);
      axis.skipTo(t, 20, -20);
      assertTrue(axis.next >= t - AxisTraversal.doubt(t), "plane " + plane);
      assertTrue(
          axis.cell == 20 || axis.crossing(axis.cell + 1) < t - AxisTraversal.doubt(t),
          "plane " + plane);
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
