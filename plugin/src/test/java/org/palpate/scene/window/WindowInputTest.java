package org.palpate.scene.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.jogamp.newt.event.InputEvent;
import com.jogamp.newt.event.MouseEvent;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.Vec3;
import org.palpate.scene.SceneModel;
import org.palpate.scene.Theme;
import org.palpate.scene.WorldAxes;
import org.palpate.scene.gl.LegendArea;

class WindowInputTest {
  private static final int WIDTH = 400;
  private static final int HEIGHT = 200;

  private final SceneModel model = new SceneModel(WorldAxes.UNKNOWN, Theme.DARK);
  private final WindowInput input =
      new WindowInput(model, () -> WIDTH, () -> HEIGHT, () -> LegendArea.NONE);
  private final List<String> drags = new ArrayList<>();

  @Test
  void aDragWithControlAndShiftGoesToItsListenerInPictureHeights() {
    listenTo(WindowInput.DragKeys.CONTROL_AND_SHIFT);
    Vec3 back = model.camera().back();
    drag(InputEvent.CTRL_MASK | InputEvent.SHIFT_MASK, 50, -20);
    assertEquals(List.of("CONTROL_AND_SHIFT 0.25 0.1"), drags);
    assertTrue(back.sameBits(model.camera().back()), "the scene does not turn");
  }

  @Test
  void controlAloneAndBothKeysAreDifferentDrags() {
    listenTo(WindowInput.DragKeys.CONTROL);
    listenTo(WindowInput.DragKeys.CONTROL_AND_SHIFT);
    drag(InputEvent.CTRL_MASK, 20, 0);
    drag(InputEvent.CTRL_MASK | InputEvent.SHIFT_MASK, 0, -20);
    assertEquals(List.of("CONTROL 0.1 0.0", "CONTROL_AND_SHIFT 0.0 0.1"), drags);
  }

  @Test
  void withoutAListenerADragWithKeysTurnsOrMovesTheScene() {
    Vec3 back = new Vec3().set(model.camera().back());
    drag(InputEvent.CTRL_MASK, 50, 0);
    assertTrue(!back.sameBits(model.camera().back()), "turned");
    Vec3 turned = new Vec3().set(model.camera().back());
    drag(InputEvent.CTRL_MASK | InputEvent.SHIFT_MASK, 50, 0);
    assertTrue(turned.sameBits(model.camera().back()), "moved, not turned");
    assertEquals(List.of(), drags);
  }

  private void listenTo(WindowInput.DragKeys keys) {
    input.onDrag(
        keys, "test", (right, up) -> drags.add(keys + " " + (right + 0.0) + " " + (up + 0.0)));
  }

  private void drag(int keys, int dx, int dy) {
    input.mousePressed(event(MouseEvent.EVENT_MOUSE_PRESSED, keys, 100, 100));
    input.mouseDragged(event(MouseEvent.EVENT_MOUSE_DRAGGED, keys, 100 + dx, 100 + dy));
    input.mouseReleased(event(MouseEvent.EVENT_MOUSE_RELEASED, keys, 100 + dx, 100 + dy));
  }

  private static MouseEvent event(short type, int keys, int x, int y) {
    return new MouseEvent(
        type, "test", 0, keys, x, y, (short) 1, MouseEvent.BUTTON1, new float[3], 1);
  }
}
