package org.palpate.imagej.dialog;

import ij.gui.GenericDialog;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;

/** The help page of every dialog. It needs no network. */
public final class HelpText {
  private static final String FILE = "help.html";

  private HelpText() {}

  /** Adds a help button to a dialog. */
  public static void addTo(GenericDialog dialog) {
    dialog.addHelp(html());
  }

  /** Returns the page, which ImageJ shows in its own window. */
  private static String html() {
    try (InputStream page = HelpText.class.getResourceAsStream(FILE)) {
      return new String(page.readAllBytes(), StandardCharsets.UTF_8).strip();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
