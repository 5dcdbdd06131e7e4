package org.palpate.imagej.stack;

import java.util.Arrays;
import java.util.Optional;

/**
 * Colours for segments that colour-blind people can tell apart. Source: M. Okabe and K. Ito, Color
 * universal design, 2008; with one of bone in the place of black.
 */
public enum SegmentColour {
  BONE(0xE6C99F),
  SKY(0x56B4E9),
  ORANGE(0xE69F00),
  GREEN(0x009E73),
  PURPLE(0xCC79A7),
  YELLOW(0xF0E442),
  BLUE(0x0072B2),
  RED(0xD55E00);

  private final int rgb;

  SegmentColour(int rgb) {
    this.rgb = rgb;
  }

  /** 0xRRGGBB. */
  public int rgb() {
    return rgb;
  }

  /** The colour of one of many, in turn. */
  static SegmentColour byNumber(int number) {
    return values()[Math.floorMod(number, values().length)];
  }

  /** As in the dialog. */
  @Override
  public String toString() {
    return name().toLowerCase(java.util.Locale.ROOT);
  }

  public static Optional<SegmentColour> parse(String word) {
    return Arrays.stream(values()).filter(colour -> colour.toString().equals(word)).findFirst();
  }

  public static String[] words() {
    return Arrays.stream(values()).map(SegmentColour::toString).toArray(String[]::new);
  }
}
