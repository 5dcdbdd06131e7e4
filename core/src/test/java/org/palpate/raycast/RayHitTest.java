package org.palpate.raycast;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class RayHitTest {
  private final RayHit hit = new RayHit();

  @Test
  void aCellIsReadAndWrittenByItsAxis() {
    hit.set(0.25, 3, 4, 5, 2);
    assertEquals(3, hit.cell(0));
    assertEquals(4, hit.cell(1));
    assertEquals(5, hit.cell(2));
    hit.setCell(0, 13);
    assertHit(0.25, 13, 4, 5, 2);
    hit.setCell(1, 14);
    assertHit(0.25, 13, 14, 5, 2);
    hit.setCell(2, 15);
    assertHit(0.25, 13, 14, 15, 2);
  }

  @Test
  void aCopyHasAllComponents() {
    RayHit other = new RayHit();
    other.set(0.5, 1, 2, 3, RayHit.NO_AXIS);
    hit.set(other);
    assertHit(0.5, 1, 2, 3, RayHit.NO_AXIS);
  }

  private void assertHit(double t, int i, int j, int k, int axis) {
    assertEquals(t, hit.t);
    assertEquals(i, hit.i);
    assertEquals(j, hit.j);
    assertEquals(k, hit.k);
    assertEquals(axis, hit.axis);
  }
}
