package org.palpate.scene;

import java.util.Locale;

/**
 * Colours of what surrounds the scan, 0xRRGGBB. The marks differ in lightness as well as in hue, so
 * that they can be told apart without seeing red or green.
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

  public int above() {
    return above;
  }

  public int below() {
    return below;
  }

  public int text() {
    return text;
  }

  public int quiet() {
    return quiet;
  }

  /** As a person types it. */
  @Override
  public String toString() {
    return name().toLowerCase(Locale.ROOT);
  }
}
