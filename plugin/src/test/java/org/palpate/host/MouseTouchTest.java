package org.palpate.host;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.device.DeviceState;
import org.palpate.device.HandTarget;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.scene.window.PointerSpot;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;

/** A mouse presses on solids of 40 voxels a side. Presses are 2 mm deep. */
class MouseTouchTest {
  private static final int EDGE = 40;
  private static final double DEPTH_MM = 2;
  private static final Vec3 ABOVE = new Vec3(20, 20, 60);
  private static final HandTarget REGION =
      new HandTarget(new Vec3(), new Vec3(EDGE, EDGE, EDGE), 1, List.of());

  /** More samples than the mouse needs to arrive to a thousandth of a millimetre. */
  private static final int SAMPLES_TO_ARRIVE = 2000;

  private final MouseDevice mouse = new MouseDevice(REGION, 1_000_000);
  private final DeviceState state = new DeviceState();
  private final List<String> hints = new ArrayList<>();

  @Test
  void aPressStartsInFrontOfTheFaceAndGoesStraightIntoTheSolid() {
    MouseTouch touch = touching(floor(20), 1);
    assertTrue(touch.press(spot(ABOVE, new Vec3(20, 20, 20), true)));
    assertJumpsTo(20, 20, 20 + 1.5);
    assertArrivesAt(20, 20, 20 - DEPTH_MM);
    assertEquals(List.of(""), hints);
  }

  @Test
  void anObliquePressStartsOnTheLineOfSightAndStillGoesStraightIntoTheSolid() {
    MouseTouch touch = touching(floor(20), 1);
    touch.press(spot(new Vec3(60, 20, 60), new Vec3(20, 20, 20), true));
    double aside = 1.5 * Math.sqrt(0.5);
    assertJumpsTo(20 + aside, 20, 20 + aside);
    assertArrivesAt(20, 20, 20 - DEPTH_MM);
  }

  /** The mean of the solids around leads almost across the line of sight. */
  @Test
  void aGrazingPressGoesAlongTheLineOfSight() {
    MouseTouch touch = touching(floor(20), 1);
    Vec3 eye = new Vec3(100, 20.5, 21);
    Vec3 face = new Vec3(20, 20.5, 20);
    touch.press(spot(eye, face, true));
    Vec3 sight = face.sub(eye, new Vec3());
    sight.mul(DEPTH_MM / sight.length(), sight);
    read(SAMPLES_TO_ARRIVE);
    assertNear(face.x + sight.x, face.y + sight.y, face.z + sight.z, 1e-2);
  }

  @Test
  void longVoxelsKeepThePressFartherInFront() {
    MouseTouch touch = touching(floor(10), 2);
    touch.press(spot(ABOVE, new Vec3(20, 20, 20), true));
    assertJumpsTo(20, 20, 20 + 3);
  }

  @Test
  void aViewerCloseToTheFaceIsNotPassed() {
    MouseTouch touch = touching(floor(20), 1);
    touch.press(spot(new Vec3(20, 20, 21), new Vec3(20, 20, 20), true));
    assertJumpsTo(20, 20, 20.5);
  }

  @Test
  void aDragMovesAlongTheSurfaceWithoutAJump() {
    MouseTouch touch = touching(floor(20), 1);
    touch.press(spot(ABOVE, new Vec3(20, 20, 20), true));
    read(1);
    assertTrue(touch.press(spot(ABOVE, new Vec3(22, 21, 20), false)));
    read(1);
    assertFalse(state.relocated);
    assertArrivesAt(22, 21, 20 - DEPTH_MM);
  }

  @Test
  void aDragToAnotherSurfaceFarBehindJumpsThere() {
    BitCube cliff = floor(5);
    fill(cliff, 25, EDGE, 20);
    MouseTouch touch = touching(cliff, 1);
    Vec3 eye = new Vec3(25, 20, 100);
    touch.press(spot(eye, new Vec3(28, 20, 20), true));
    read(1);
    touch.press(spot(eye, new Vec3(25.5, 20, 20), false));
    read(1);
    assertFalse(state.relocated, "still on the cliff");
    touch.press(spot(eye, new Vec3(22, 20, 5), false));
    read(1);
    assertTrue(state.relocated, "at its foot");
  }

  @Test
  void aPressBesideTheSolidsTouchesNothingAndSaysSo() {
    MouseTouch touch = touching(floor(20), 1);
    Vec3 beside = new Vec3(60, 20, 20);
    assertFalse(touch.press(spot(new Vec3(60, 20, 60), beside, true)));
    assertEquals(List.of(MouseTouch.NOTHING_THERE), hints);
    read(1);
    assertFalse(state.relocated);
    assertFalse(touch.press(spot(new Vec3(60, 20, 60), beside, false)));
    assertEquals(1, hints.size(), "a drag says nothing");
    assertTrue(touch.press(spot(ABOVE, new Vec3(20, 20, 20), false)));
    read(1);
    assertTrue(state.relocated, "a drag that comes back begins anew");
  }

  /** A drawn surface may lie up to two voxels beside the solid that it shows. */
  @Test
  void aPressJustBesideASolidTouchesIt() {
    BitCube dot = new BitCube(EDGE, EDGE, EDGE);
    dot.set(20, 20, 20);
    dot.set(22, 21, 19); // also near, but farther from the spot
    MouseTouch touch = touching(dot, 1);
    Vec3 eye = new Vec3(20.5, 60, 21.3);
    assertTrue(touch.press(spot(eye, new Vec3(20.5, 21, 21.3), true)));
    read(1);
    assertTrue(state.relocated);
    assertEquals(20.5, state.positionMm.x, 0.01);
    assertEquals(21 + 1.5, state.positionMm.y, 0.01);
    assertFalse(touch.press(spot(eye, new Vec3(20.5, 21, 24.3), true)), "too far away");
  }

  @Test
  void aViewerInsideASolidTouchesNothing() {
    MouseTouch touch = touching(floor(20), 1);
    assertFalse(touch.press(spot(new Vec3(20, 20, 10.5), new Vec3(20, 20, 20), true)));
    assertEquals(List.of(MouseTouch.NOTHING_THERE), hints);
  }

  /** The radius of the region is half its diagonal; a freed point withdraws by 15 % of it. */
  @Test
  void aFreedPointWithdrawsInFrontOfThePressedFace() {
    MouseTouch touch = touching(floor(20), 1);
    touch.free();
    read(1);
    assertFalse(state.relocated, "nothing was pressed");
    touch.press(spot(ABOVE, new Vec3(20, 20, 20), true));
    read(100);
    touch.free();
    double withdrawn = 20 + 0.15 * Math.sqrt(3) * EDGE / 2;
    assertJumpsTo(20, 20, withdrawn);
    assertArrivesAt(20, 20, withdrawn);
  }

  private MouseTouch touching(BitCube bits, double spacingZ) {
    VoxelGrid grid =
        new VoxelGrid(EDGE, EDGE, EDGE, new Vec3(1, 1, spacingZ), RigidTransform.identity());
    SegmentedVolume volume =
        new SegmentedVolume(grid, List.of(new Segment("solid", bits, 0xffffff)));
    return new MouseTouch(new DrawnSolids(volume, List.of()), mouse, hints::add);
  }

  /** Returns a cube that is solid below a height, voxels. */
  private static BitCube floor(int height) {
    BitCube bits = new BitCube(EDGE, EDGE, EDGE);
    fill(bits, 0, EDGE, height);
    return bits;
  }

  private static void fill(BitCube bits, int fromX, int toX, int height) {
    for (int k = 0; k < height; k++) {
      for (int j = 0; j < EDGE; j++) {
        for (int i = fromX; i < toX; i++) {
          bits.set(i, j, k);
        }
      }
    }
  }

  private static PointerSpot spot(Vec3 eye, Vec3 surface, boolean begins) {
    return new PointerSpot(eye, surface, DEPTH_MM, begins);
  }

  private void assertJumpsTo(double x, double y, double z) {
    read(1);
    assertTrue(state.relocated);
    assertNear(x, y, z, 1e-9);
  }

  private void assertArrivesAt(double x, double y, double z) {
    read(SAMPLES_TO_ARRIVE);
    assertNear(x, y, z, 1e-3);
  }

  private void assertNear(double x, double y, double z, double mm) {
    Vec3 off = state.positionMm.sub(new Vec3(x, y, z), new Vec3());
    assertTrue(off.length() < mm, "at " + state.positionMm + ", off by " + off);
  }

  private void read(int samples) {
    for (int n = 0; n < samples; n++) {
      mouse.read(state);
    }
  }
}
