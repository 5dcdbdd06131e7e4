package org.palpate.scene.window;

import com.jogamp.newt.event.KeyEvent;
import java.util.List;
import java.util.function.Consumer;

/**
 * A line of text that the user types in the window. Enter takes it, and Escape takes the first text
 * instead. The window's own thread alone.
 */
final class TextEntry {
  private static final int MAX_LENGTH = 60;

  private final String prompt;
  private final String first;
  private final Consumer<String> taker;
  private final StringBuilder text = new StringBuilder();

  /**
   * Begins with a text that the first letter replaces.
   *
   * @param taker receives the text at the end; the first text after Escape, or if none was typed
   */
  TextEntry(String prompt, String first, Consumer<String> taker) {
    this.prompt = prompt;
    this.first = first;
    this.taker = taker;
  }

  /** Returns the lines to show. */
  List<String> lines() {
    return List.of(prompt, (text.isEmpty() ? first : text.toString()) + "_", "Enter: keep");
  }

  /**
   * Handles a key.
   *
   * @return whether the entry goes on; false after Enter and Escape
   */
  boolean type(short code, char letter, boolean isPrintable) {
    if (code == KeyEvent.VK_ENTER || code == KeyEvent.VK_ESCAPE) {
      boolean kept = code == KeyEvent.VK_ENTER && !text.toString().isBlank();
      taker.accept(kept ? text.toString().strip() : first);
      return false;
    }
    if (code == KeyEvent.VK_BACK_SPACE && !text.isEmpty()) {
      text.setLength(text.length() - 1);
    } else if (isPrintable && letter >= ' ' && text.length() < MAX_LENGTH) {
      text.append(letter);
    }
    return true;
  }
}
