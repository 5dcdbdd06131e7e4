package org.palpate.host.placing;

import java.util.function.Consumer;
import org.palpate.geometry.Vec3;
import org.palpate.host.TouchSession;
import org.palpate.scene.window.WindowInput;

/**
 * The keys, the wheel and the drag that turn the body in hand about the axes of the picture, for a
 * device without orientation. Any thread.
 */
final class TurningKeys {
  /**
   * The turn of a press, rad: so small that the hand follows a key that repeats 30 times a second.
   */
  static final double STEP = Math.toRadians(3);

  private static final Vec3 TOWARDS_VIEWER = new Vec3(0, 0, STEP);

  private final TouchSession session;
  private final Consumer<String> hint;

  /**
   * Creates the keys of a session.
   *
   * @param session turns the body in hand
   * @param hint shows a line to the user
   */
  TurningKeys(TouchSession session, Consumer<String> hint) {
    this.session = session;
    this.hint = hint;
  }

  /**
   * Adds keys, wheel and drag to a window, or a note if the device itself turns the body.
   *
   * @param input the keys of the window
   */
  void addTo(WindowInput input) {
    if (!session.canTurnHeld()) {
      input.addNote("the body in hand turns with the device");
      return;
    }
    addPair(input, WindowInput.LEFT, WindowInput.RIGHT, "upright axis", new Vec3(0, STEP, 0));
    addPair(input, WindowInput.UP, WindowInput.DOWN, "level axis", new Vec3(STEP, 0, 0));
    addPair(input, WindowInput.PAGE_DOWN, WindowInput.PAGE_UP, "line of sight", TOWARDS_VIEWER);
    input.onWheelWithKeys(
        "turn the body in hand about the line of sight",
        steps -> turn(input, TOWARDS_VIEWER, steps));
    if (!input.hasDrag(WindowInput.DragKeys.CONTROL_AND_SHIFT)) {
      input.onDrag(
          WindowInput.DragKeys.CONTROL_AND_SHIFT,
          "turn the body in hand",
          (right, up) -> turn(input, new Vec3(-Math.PI * up, Math.PI * right, 0), 1));
    }
  }

  /** Adds a key that turns backwards about an axis of the picture, and one that turns forwards. */
  private void addPair(WindowInput input, char backwards, char forwards, String axis, Vec3 seen) {
    input.onHeldKey(
        backwards, "turn the body in hand about the " + axis, () -> turn(input, seen, -1));
    input.onHeldKey(forwards, "turn it the other way", () -> turn(input, seen, 1));
  }

  /** Turns by some steps, each a rotation vector along the axes of the picture. */
  private void turn(WindowInput input, Vec3 seen, double steps) {
    if (!session.turnHeld(input.turnInView(seen.mul(steps, new Vec3())))) {
      hint.accept(
          session.isHolding()
              ? "the simulated hand turns it: press with the mouse to take over"
              : "take hold of a body first");
    }
  }
}
