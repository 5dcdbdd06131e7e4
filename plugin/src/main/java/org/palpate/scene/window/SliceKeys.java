package org.palpate.scene.window;

import java.util.function.Consumer;
import org.palpate.scene.MovableSlices;

/** The keys that show, move and colour slices of grey values. */
public final class SliceKeys {
  private SliceKeys() {}

  /**
   * Adds the keys.
   *
   * @param change applies a change and shows it
   */
  public static void add(WindowInput input, MovableSlices planes, Consumer<Runnable> change) {
    input.onKey(
        'g',
        "slices of grey values: off, fixed, at the point",
        () -> change.accept(planes::nextMode));
    input.onKey('p', "axis that [ and ] move: x, y, z", () -> change.accept(planes::nextAxis));
    input.onKey('w', "next window of the slices, for CT", () -> change.accept(planes::nextWindow));
    input.onDrag(
        WindowInput.DragKeys.CONTROL,
        "window and level of the slices",
        (right, up) -> change.accept(() -> planes.dragWindow(right, up)));
    input.onHeldKey('[', "move the slice back", () -> change.accept(() -> planes.move(-1)));
    input.onHeldKey(']', "move the slice forward", () -> change.accept(() -> planes.move(1)));
  }
}
