package org.palpate.imagej.dialog;

import ij.gui.GenericDialog;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;

/** What the help button of every dialog shows; needs no network. */
public final class HelpText {
  private static final String FILE = "help.html";

  private HelpText() {}

  /** Gives a dialog its help button. */
  public static void addTo(GenericDialog dialog) {
    dialog.addHelp(html());
  }

  /** A page that ImageJ shows in a window of its own. */
  static String html() {
    try (InputStream page = HelpText.class.getResourceAsStream(FILE)) {
      return new String(page.readAllBytes(), StandardCharsets.UTF_8).strip();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
