package org.palpate.scene.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.jogamp.newt.event.InputEvent;
import com.jogamp.newt.event.MouseEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.scene.Camera;
import org.palpate.scene.SceneModel;
import org.palpate.scene.Theme;
import org.palpate.scene.WorldAxes;
import org.palpate.scene.gl.LegendArea;
import org.palpate.scene.gl.PickedPoint;

class WindowMouseTest {
  private static final int HEIGHT = 200;
  private static final short LEFT = MouseEvent.BUTTON1;
  private static final short MIDDLE = MouseEvent.BUTTON2;
  private static final short RIGHT = MouseEvent.BUTTON3;

  private final SceneModel model = new SceneModel(WorldAxes.RAS, Theme.DARK);
  private LegendArea area = LegendArea.NONE;
  private final WindowInput input = new WindowInput(model, () -> 400, () -> HEIGHT, () -> area);
  private final List<String> heard = new ArrayList<>();
  private Optional<PickedPoint> underMouse = Optional.empty();
  private boolean touches = true;

  /** Writes down what the mouse as a device is told. */
  private final class Pointer implements PointerListener {
    @Override
    public boolean press(PointerSpot spot) {
      heard.add(
          (spot.begins() ? "begins " : "goes on ") + spot.surfaceMm() + " from " + spot.eyeMm());
      depths.add(spot.depthMm());
      return touches;
    }

    @Override
    public void pressedBackground() {
      heard.add("background");
    }
  }

  private final List<Double> depths = new ArrayList<>();

  private static MouseEvent event(short type, int keys, int x, int y, short button, float wheel) {
    return new MouseEvent(
        type, "test", 0, keys, x, y, (short) 1, button, new float[] {0, wheel, 0}, 1);
  }

  private void press(int x, int y, short button, int keys) {
    input.mousePressed(event(MouseEvent.EVENT_MOUSE_PRESSED, keys, x, y, button, 0));
  }

  private void drag(int x, int y, short button) {
    input.mouseDragged(event(MouseEvent.EVENT_MOUSE_DRAGGED, 0, x, y, button, 0));
  }

  private void release(short button) {
    input.mouseReleased(event(MouseEvent.EVENT_MOUSE_RELEASED, 0, 0, 0, button, 0));
  }

  private void wheel(float steps) {
    input.mouseWheelMoved(event(MouseEvent.EVENT_MOUSE_WHEEL_MOVED, 0, 0, 0, (short) 0, steps));
  }

  private void draw() {
    input.pick(
        (x, y) -> {
          heard.add("looks at " + x + "," + y);
          return underMouse;
        });
  }

  private static boolean sameView(Camera a, Camera b) {
    return a.eye().sameBits(b.eye()) && a.up().sameBits(b.up());
  }

  @Test
  void aDragTurnsTheSceneByHalfATurnOverThePicturesHeight() {
    Camera before = model.camera();
    press(100, 100, LEFT, 0);
    drag(150, 100, LEFT);
    assertTrue(model.state().moving());
    assertTrue(sameView(before.orbit(Math.PI / 4, 0), model.camera()));
    drag(150, 80, LEFT);
    assertTrue(sameView(before.orbit(Math.PI / 4, 0).orbit(0, 0.1 * Math.PI), model.camera()));
    release(LEFT);
    assertFalse(model.state().moving());
    Camera released = model.camera();
    drag(10, 10, LEFT);
    assertTrue(sameView(released, model.camera()), "no button is held down");
  }

  @Test
  void aMiddleDragAndAShiftDragMoveTheScene() {
    Camera before = model.camera();
    press(100, 100, MIDDLE, 0);
    drag(120, 60, MIDDLE);
    release(MIDDLE);
    Camera moved = before.pan(0.1, 0.2);
    assertTrue(sameView(moved, model.camera()));
    press(0, 0, LEFT, InputEvent.SHIFT_MASK);
    drag(0, 20, LEFT);
    assertTrue(sameView(moved.pan(0, -0.1), model.camera()));
  }

  @Test
  void aRightDragTurnsEvenIfTheMouseIsADevice() {
    input.setPointer(new Pointer());
    Camera before = model.camera();
    press(100, 100, RIGHT, 0);
    drag(150, 100, RIGHT);
    assertTrue(sameView(before.orbit(Math.PI / 4, 0), model.camera()));
    draw();
    assertEquals(List.of(), heard);
  }

  @Test
  void theWheelZooms() {
    double before = model.camera().distanceMm();
    wheel(2);
    assertEquals(0.81 * before, model.camera().distanceMm(), 1e-12);
    wheel(-2);
    assertEquals(before, model.camera().distanceMm(), 1e-12);
  }

  @Test
  void aPressOnASurfaceTouchesItAndDragsGoOn() {
    input.setPointer(new Pointer());
    underMouse = Optional.of(new PickedPoint(new Vec3(1, 2, 3), new Vec3(7, 8, 9)));
    Camera before = model.camera();
    press(30, 40, LEFT, 0);
    drag(31, 41, LEFT);
    assertEquals(List.of(), heard, "nothing happens before the drawing thread has looked");
    draw();
    drag(50, 60, LEFT);
    draw();
    draw();
    release(LEFT);
    drag(90, 90, LEFT);
    draw();
    assertEquals(
        List.of(
            "looks at 30,40",
            "begins (-1.0, -2.0, 3.0) from (-7.0, -8.0, 9.0)",
            "looks at 50,60",
            "goes on (-1.0, -2.0, 3.0) from (-7.0, -8.0, 9.0)"),
        heard);
    assertTrue(sameView(before, model.camera()));
  }

  @Test
  void aPressOnTheBackgroundTurnsTheScene() {
    input.setPointer(new Pointer());
    Camera before = model.camera();
    press(100, 100, LEFT, 0);
    draw();
    drag(150, 100, LEFT);
    assertEquals(List.of("looks at 100,100", "background"), heard);
    assertTrue(sameView(before.orbit(Math.PI / 4, 0), model.camera()));
  }

  @Test
  void aPressThatTouchesNothingTurnsTheScene() {
    input.setPointer(new Pointer());
    touches = false;
    underMouse = Optional.of(new PickedPoint(new Vec3(), new Vec3(1, 1, 1)));
    Camera before = model.camera();
    press(100, 100, LEFT, 0);
    draw();
    drag(150, 100, LEFT);
    assertTrue(sameView(before.orbit(Math.PI / 4, 0), model.camera()));
  }

  @Test
  void aButtonThatWasReleasedMeanwhileLeavesNoGesture() {
    input.setPointer(new Pointer());
    Camera before = model.camera();
    press(100, 100, LEFT, 0);
    release(LEFT);
    draw();
    drag(150, 100, LEFT);
    assertTrue(sameView(before, model.camera()));
  }

  @Test
  void theWheelChangesThePressureWhileTouchingWithinItsLimits() {
    model.add("a", 0, RigidTransform.identity(), new Vec3(), new Vec3(6, 8, 0));
    input.setPointer(new Pointer());
    underMouse = Optional.of(new PickedPoint(new Vec3(), new Vec3(1, 1, 1)));
    press(30, 40, LEFT, 0);
    draw();
    double distance = model.camera().distanceMm();
    wheel(1);
    draw();
    wheel(1000);
    draw();
    wheel(-1000);
    draw();
    assertEquals(0.1, depths.get(0), 1e-12, "2 % of the radius of 5");
    assertEquals(0.1 / 0.9, depths.get(1), 1e-12);
    assertEquals(1, depths.get(2), 1e-12, "at most 20 %");
    assertEquals(0.01, depths.get(3), 1e-12, "at least 0.2 %");
    assertEquals(distance, model.camera().distanceMm());
  }

  @Test
  void aClickOnTheLegendHidesASegmentOrChangesItsColour() {
    model.add("a", 0x111111, RigidTransform.identity(), new Vec3(), new Vec3(1, 1, 1));
    model.add("b", 0x222222, RigidTransform.identity(), new Vec3(), new Vec3(1, 1, 1));
    area = new LegendArea(300, 10, 20, 15, 0, 2);
    press(340, 35, LEFT, 0);
    assertEquals(2, model.state().objects().size(), "the legend is not shown yet");
    input.addLegend();
    Camera before = model.camera();
    press(340, 35, LEFT, 0);
    drag(200, 35, LEFT);
    assertTrue(sameView(before, model.camera()), "a click on the legend is no drag");
    assertEquals("a", model.state().objects().get(0).object().name());
    assertEquals(1, model.state().objects().size());
    press(314, 12, LEFT, 0);
    assertTrue(model.state().objects().get(0).rgb() != 0x111111);
    assertTrue(model.state().legend().get(0).selected());
    press(340, 55, LEFT, 0);
    assertEquals(1, model.state().objects().size(), "below the last row");
  }

  @Test
  void rowsOfTheLegendCountFromItsFirst() {
    LegendArea scrolled = new LegendArea(300, 10, 20, 15, 4, 2);
    assertEquals(4, scrolled.segmentAt(300, 10));
    assertEquals(5, scrolled.segmentAt(399, 49));
    assertEquals(-1, scrolled.segmentAt(299, 20));
    assertEquals(-1, scrolled.segmentAt(300, 9));
    assertEquals(-1, scrolled.segmentAt(300, 50));
    assertTrue(scrolled.isColour(314));
    assertFalse(scrolled.isColour(315));
    assertEquals(-1, LegendArea.NONE.segmentAt(0, 0));
  }
}
