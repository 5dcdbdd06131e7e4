package org.palpate.raycast;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.geometry.IntBox;

/** The box is that of the voxels 4 to 7 of each axis; with its margin it reaches from 2 to 10. */
class RayClipTest {
  private final IntBox box = new IntBox();
  private final RayClip clip = new RayClip();

  RayClipTest() {
    box.include(4, 4, 4);
    box.include(7, 7, 7);
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2})
  void keepsThePartBetweenTheFacesOfTheBoxAndItsMargin(int axis) {
    assertTrue(clip.clip(ray(axis, -6, 26, 5.5), box));
    assertPart(8 / 32.0, 16 / 32.0);
    assertTrue(clip.clip(ray(axis, 26, -6, 5.5), box));
    assertPart(16 / 32.0, 24 / 32.0);
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2})
  void keepsTheEndsOfARayThatStartsOrEndsInside(int axis) {
    assertTrue(clip.clip(ray(axis, 5, 21, 5.5), box));
    assertPart(0, 5 / 16.0);
    assertTrue(clip.clip(ray(axis, -11, 5, 5.5), box));
    assertPart(13 / 16.0, 1);
    assertTrue(clip.clip(ray(axis, 5, 5, 5.5), box));
    assertPart(0, 1);
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2})
  void refusesARayThatEndsBeforeTheBoxOrStartsBehindIt(int axis) {
    assertFalse(clip.clip(ray(axis, -6, 1, 5.5), box));
    assertFalse(clip.clip(ray(axis, 26, 11, 5.5), box));
    assertFalse(clip.clip(ray(axis, 11, 26, 5.5), box));
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2})
  void refusesARayBesideTheBoxAndItsMargin(int axis) {
    assertTrue(clip.clip(ray(axis, -6, 26, 2), box));
    assertTrue(clip.clip(ray(axis, -6, 26, 10), box));
    assertFalse(clip.clip(ray(axis, -6, 26, Math.nextDown(2.0)), box));
    assertFalse(clip.clip(ray(axis, -6, 26, Math.nextUp(10.0)), box));
  }

  @Test
  void refusesADiagonalThatPassesACorner() {
    assertTrue(clip.clip(new Ray().from(-2, 6, 5).to(6, 14, 5), box));
    assertPart(0.5, 0.5);
    assertFalse(clip.clip(new Ray().from(-2, 6.5, 5).to(6, 14.5, 5), box));
  }

  @Test
  void refusesEveryRayIfTheBoxIsEmpty() {
    assertFalse(clip.clip(ray(0, -6, 26, 5.5), new IntBox()));
  }

  private void assertPart(double from, double to) {
    assertEquals(from, clip.from);
    assertEquals(to, clip.to);
  }

  /** Returns a ray along an axis whose other coordinates are both {@code beside}. */
  private static Ray ray(int axis, double from, double to, double beside) {
    return new Ray()
        .from(axis == 0 ? from : beside, axis == 1 ? from : beside, axis == 2 ? from : beside)
        .to(axis == 0 ? to : beside, axis == 1 ? to : beside, axis == 2 ? to : beside);
  }
}
