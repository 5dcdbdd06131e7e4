package org.palpate.scene;

import java.util.Locale;

/**
 * Colours of the background and the text, 0xRRGGBB. Marks differ in lightness as well as in hue, so
 * that people can distinguish them without seeing red or green.
 */
public enum Theme {
  DARK(0x1b2330, 0x0a0d13, 0xe8ecf2, 0x8b98a9),
  LIGHT(0xfbfcfd, 0xd5dce5, 0x1b2330, 0x5b6775);

  private final int above;
  private final int below;
  private final int text;
  private final int quiet;

  Theme(int above, int below, int text, int quiet) {
    this.above = above;
    this.below = below;
    this.text = text;
    this.quiet = quiet;
  }

  /** Returns the background colour in the middle of the picture. */
  public int above() {
    return above;
  }

  /** Returns the background colour at the edge of the picture. */
  public int below() {
    return below;
  }

  /** Returns the colour of text. */
  public int text() {
    return text;
  }

  /** Returns the colour of unobtrusive lines. */
  public int quiet() {
    return quiet;
  }

  /** Returns the name on the command line. */
  @Override
  public String toString() {
    return name().toLowerCase(Locale.ROOT);
  }
}
