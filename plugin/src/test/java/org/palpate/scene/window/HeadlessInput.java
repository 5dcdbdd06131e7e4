package org.palpate.scene.window;

import com.jogamp.newt.event.InputEvent;
import com.jogamp.newt.event.KeyEvent;
import com.jogamp.newt.event.MouseEvent;
import org.palpate.scene.SceneModel;
import org.palpate.scene.gl.LegendArea;

/** The keys and the mouse of a window that is not there, for tests of other packages. */
public final class HeadlessInput {
  private static final int CONTROL_AND_SHIFT = InputEvent.CTRL_MASK | InputEvent.SHIFT_MASK;
  private static final int HEIGHT = 200;

  private final WindowInput input;

  /** Creates the keys of a window on a scene. */
  public HeadlessInput(SceneModel model) {
    input = new WindowInput(model, () -> 400, () -> HEIGHT, () -> LegendArea.NONE);
  }

  /** Returns what gives them actions. */
  public WindowInput input() {
    return input;
  }

  /** Presses a key that types a character. */
  public void type(char letter) {
    press((short) Character.toUpperCase(letter), letter);
  }

  /** Presses a key that types nothing. */
  public void press(short code) {
    press(code, (char) 0);
  }

  private void press(short code, char letter) {
    input
        .keys()
        .keyPressed(KeyEvent.create(KeyEvent.EVENT_KEY_PRESSED, this, 0, 0, code, code, letter));
  }

  /** Turns the wheel with Ctrl and Shift; with Shift, some systems turn it sideways. */
  public void wheel(float sideways, float upwards) {
    float[] turned = {sideways, upwards, 0};
    input.mouseWheelMoved(mouse(MouseEvent.EVENT_MOUSE_WHEEL_MOVED, 0, turned));
  }

  /** Drags to the right with Ctrl and Shift. */
  public void drag(double heights) {
    int pixels = (int) Math.round(heights * HEIGHT);
    input.mousePressed(mouse(MouseEvent.EVENT_MOUSE_PRESSED, 0, new float[3]));
    input.mouseDragged(mouse(MouseEvent.EVENT_MOUSE_DRAGGED, pixels, new float[3]));
    input.mouseReleased(mouse(MouseEvent.EVENT_MOUSE_RELEASED, pixels, new float[3]));
  }

  private MouseEvent mouse(short type, int x, float[] wheel) {
    return new MouseEvent(
        type, this, 0, CONTROL_AND_SHIFT, x, 100, (short) 1, MouseEvent.BUTTON1, wheel, 1);
  }
}
