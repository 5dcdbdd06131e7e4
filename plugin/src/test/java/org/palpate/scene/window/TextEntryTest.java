package org.palpate.scene.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.jogamp.newt.event.KeyEvent;
import java.util.List;
import org.junit.jupiter.api.Test;

class TextEntryTest {
  private String taken = "nothing";
  private final TextEntry entry = new TextEntry("Name:", "L1", text -> taken = text);

  @Test
  void theFirstLetterReplacesTheFirstText() {
    assertEquals(List.of("Name:", "L1_", "Enter: keep"), entry.lines());
    type("nose");
    assertTrue(entry.type(KeyEvent.VK_BACK_SPACE, '\b', false));
    type("e tip");
    assertEquals("nose tip_", entry.lines().get(1));
    assertFalse(entry.type(KeyEvent.VK_ENTER, '\r', false));
    assertEquals("nose tip", taken);
  }

  @Test
  void enterWithoutATextAndEscapeKeepTheFirstText() {
    assertFalse(entry.type(KeyEvent.VK_ENTER, '\r', false));
    assertEquals("L1", taken);
    type("x");
    assertFalse(entry.type(KeyEvent.VK_ESCAPE, (char) 27, false));
    assertEquals("L1", taken);
  }

  private void type(String text) {
    text.chars().forEach(c -> assertTrue(entry.type((short) c, (char) c, true)));
  }
}
