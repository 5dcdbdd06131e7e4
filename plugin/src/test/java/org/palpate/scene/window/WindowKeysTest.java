package org.palpate.scene.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.jogamp.newt.event.InputEvent;
import com.jogamp.newt.event.KeyEvent;
import com.jogamp.newt.event.KeyListener;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.palpate.geometry.Vec3;
import org.palpate.scene.GreySlices;
import org.palpate.scene.MovableSlices;
import org.palpate.scene.SceneModel;
import org.palpate.scene.StandardView;
import org.palpate.scene.Stereo;
import org.palpate.scene.Theme;
import org.palpate.scene.WorldAxes;
import org.palpate.scene.gl.LegendArea;
import org.palpate.volume.ScalarVolume;
import org.palpate.volume.VoxelGrid;

class WindowKeysTest {
  private final SceneModel model = new SceneModel(WorldAxes.UNKNOWN, Theme.DARK);
  private final WindowInput input =
      new WindowInput(model, () -> 400, () -> 200, () -> LegendArea.NONE);
  private final KeyListener keys = input.keys();
  private final List<String> done = new ArrayList<>();

  private void press(char letter, int modifiers) {
    keys.keyPressed(event((short) Character.toUpperCase(letter), letter, modifiers));
  }

  private static KeyEvent event(short code, char letter, int modifiers) {
    return KeyEvent.create(
        KeyEvent.EVENT_KEY_PRESSED, new Object(), 0, modifiers, code, code, letter);
  }

  @ParameterizedTest
  @CsvSource({
    "f, FRONT",
    "b, BACK",
    "l, LEFT",
    "r, RIGHT",
    "t, HEAD",
    "u, FOOT",
    "o, OBLIQUE",
    "F, FRONT"
  })
  void aKeyShowsItsView(char key, StandardView view) {
    press('8', 0); // any other key before
    press(key, 0);
    Vec3 towardsEye = view.towardsEye();
    assertEquals(0, towardsEye.sub(model.camera().back(), towardsEye).length(), 1e-12);
  }

  @Test
  void themeAndStereoComeRound() {
    press('d', 0);
    assertEquals(Theme.LIGHT, model.state().look().theme());
    press('d', 0);
    assertEquals(Theme.DARK, model.state().look().theme());
    press('3', 0);
    assertEquals(Stereo.ANAGLYPH, model.state().look().stereo());
    press('3', 0);
    assertEquals(Stereo.SIDE_BY_SIDE, model.state().look().stereo());
    press('3', 0);
    assertEquals(Stereo.OFF, model.state().look().stereo());
  }

  @Test
  void theHelpListsEveryKeyWithItsWords() {
    input.onKey('q', "quit it", () -> done.add("q"));
    input.onKey(' ', "jump", () -> done.add("space"));
    input.onKey((char) KeyEvent.VK_ESCAPE, "end", () -> done.add("end"));
    input.onDrag(WindowInput.DragKeys.CONTROL, "pull", (right, up) -> {});
    press('h', 0);
    List<String> lines = model.state().help();
    assertTrue(
        lines.containsAll(
            List.of("q   quit it", "Space   jump", "Esc   end", "Ctrl and drag   pull")),
        lines.toString());
    assertTrue(lines.contains("drag   turn"));
    press('h', 0);
    assertEquals(List.of(), model.state().help());
    input.setPointer(new SilentPointer());
    press('h', 0);
    assertTrue(model.state().help().contains("left drag on a surface   touch"));
    assertFalse(model.state().help().contains("drag   turn"));
  }

  /** A mouse that touches nothing. */
  private static final class SilentPointer implements PointerListener {
    @Override
    public boolean press(PointerSpot spot) {
      return false;
    }

    @Override
    public void pressedBackground() {}
  }

  @Test
  void aLaterActionReplacesAnEarlierOneAndAnUnknownKeyDoesNothing() {
    input.onKey('q', "one", () -> done.add("one"));
    input.onKey('q', "two", () -> done.add("two"));
    press('q', 0);
    press('#', 0);
    press('Q', 0);
    keys.keyPressed(event(KeyEvent.VK_ESCAPE, (char) 27, 0));
    assertEquals(List.of("two", "two"), done);
    input.onKey((char) KeyEvent.VK_ESCAPE, "end", () -> done.add("end"));
    keys.keyPressed(event(KeyEvent.VK_ESCAPE, (char) 27, 0));
    assertEquals("end", done.get(2));
  }

  @Test
  void onlyAKeyThatMayRepeatsWhileItIsHeld() {
    input.onKey('q', "once", () -> done.add("once"));
    input.onHeldKey('w', "often", () -> done.add("often"));
    for (int n = 0; n < 3; n++) {
      int repeat = n == 0 ? 0 : InputEvent.AUTOREPEAT_MASK;
      press('q', repeat);
      press('w', repeat);
    }
    assertEquals(List.of("once", "often", "often", "often"), done);
  }

  @Test
  void whileATextIsTypedKeysAreLetters() {
    input.onKey('q', "quit", () -> done.add("q"));
    input.ask("Name:", "L1", done::add);
    assertEquals(List.of("Name:", "L1_", "Enter: keep"), model.state().help());
    press('q', 0);
    assertEquals("q_", model.state().help().get(1));
    assertEquals(List.of(), done);
    keys.keyPressed(event(KeyEvent.VK_ENTER, '\r', 0));
    assertEquals(List.of("q"), done, "the text");
    assertEquals(List.of(), model.state().help());
    press('h', 0);
    input.ask("Name:", "L2", done::add);
    keys.keyPressed(event(KeyEvent.VK_ESCAPE, (char) 27, 0));
    assertEquals("L2", done.get(1));
    assertTrue(model.state().help().contains("h   this help"), "the help comes back");
  }

  @Test
  void theKeysOfSlicesSwitchMoveAndColourThem() {
    GreySlices grey =
        new GreySlices(
            ScalarVolume.of(VoxelGrid.ofUnitVoxels(10, 10, 10), ScalarVolume.Storage.UINT8));
    MovableSlices slices =
        new MovableSlices(model, new MovableSlices.Start(grey, MovableSlices.Mode.OFF, 5, 5, 5));
    SliceKeys.add(
        input,
        slices,
        change -> {
          change.run();
          done.add(slices.line());
        });
    press('g', 0);
    press(']', 0);
    press(']', InputEvent.AUTOREPEAT_MASK);
    press('p', 0);
    press('[', 0);
    press('w', 0);
    assertEquals(
        List.of(
            "slices fixed 5, 5, 5   keys move x",
            "slices fixed 6, 5, 5   keys move x",
            "slices fixed 7, 5, 5   keys move x",
            "slices fixed 7, 5, 5   keys move y",
            "slices fixed 7, 4, 5   keys move y",
            "slices fixed 7, 4, 5   keys move y"),
        done.stream().map(line -> line.substring(0, line.indexOf("   window"))).toList());
    assertTrue(done.get(5).endsWith("(bone)"), done.get(5));
  }
}
