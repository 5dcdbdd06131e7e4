package org.palpate.imagej.dialog;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.device.DeviceSpecification;
import org.palpate.device.HandTarget;
import org.palpate.device.Workspace;
import org.palpate.geometry.Vec3;
import org.palpate.imagej.dialog.StackWorkspace.Kind;

/** The mapping from the hand's millimetres to those of the stack. */
class StackWorkspaceTest {
  private static final DeviceSpecification HAND =
      new DeviceSpecification("hand", "", 3, 0.5, 50, 1_000_000);
  private static final HandTarget BOX =
      new HandTarget(new Vec3(0, 0, 0), new Vec3(100, 200, 400), 1, List.of());

  @Test
  void fitsTheLongestSideOfTheBoxWithOneScale() {
    assertEquals("(250.0, 100.0, 200.0)", reached(Kind.FIT, 0, 1));
  }

  @Test
  void fitsEverySideWithAScaleForEachAxis() {
    assertEquals("(100.0, 100.0, 200.0)", reached(Kind.FIT_EACH, 0, 1));
    assertEquals("(50.0, 0.0, 200.0)", reached(Kind.FIT_EACH, 1, 1));
  }

  @Test
  void appliesAGivenScaleAboutTheMiddle() {
    assertEquals("(75.0, 100.0, 200.0)", reached(Kind.SCALE, 0, 0.5));
  }

  @Test
  void upIsUpOnTheScreenAndTowardsTheUserIsMinusZ() {
    assertEquals("(50.0, 75.0, 200.0)", reached(Kind.SCALE, 1, 0.5));
    assertEquals("(50.0, 100.0, 175.0)", reached(Kind.SCALE, 2, 0.5));
  }

  @Test
  void refusesAnInvalidScale() {
    for (double scale : new double[] {0, -1, Double.NaN, Double.POSITIVE_INFINITY}) {
      assertThrows(IllegalArgumentException.class, () -> new StackWorkspace(Kind.SCALE, scale));
    }
  }

  /** Returns where the device position is after moving the hand 50 mm along one of its axes. */
  private static String reached(Kind kind, int axis, double scale) {
    Workspace workspace = new StackWorkspace(kind, scale).of(HAND, BOX);
    Vec3 hand = new Vec3();
    hand.set(axis, 50);
    return workspace.toWorld(hand, new Vec3()).toString();
  }
}
