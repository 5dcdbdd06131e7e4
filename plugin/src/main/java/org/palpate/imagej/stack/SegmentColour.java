package org.palpate.imagej.stack;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import org.palpate.scene.Palette;

/**
 * Colours of segments that people with any colour vision can distinguish.
 *
 * <p>Source: Okabe and Ito, Color universal design (2008), see {@link Palette}; the colour of bone
 * replaces black.
 */
public enum SegmentColour {
  BONE(0xE6C99F),
  SKY(Palette.SKY_BLUE),
  ORANGE(Palette.ORANGE),
  GREEN(Palette.BLUISH_GREEN),
  PURPLE(Palette.REDDISH_PURPLE),
  YELLOW(Palette.YELLOW),
  BLUE(Palette.BLUE),
  RED(Palette.VERMILION);

  private final int rgb;

  SegmentColour(int rgb) {
    this.rgb = rgb;
  }

  /** Returns the colour as 0xRRGGBB. */
  public int rgb() {
    return rgb;
  }

  /** Returns the colour of a segment by its number; the colours repeat. */
  static SegmentColour byNumber(int number) {
    return values()[Math.floorMod(number, values().length)];
  }

  /** Returns the word in the dialog. */
  @Override
  public String toString() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** Parses a word of the dialog; empty if there is no such colour. */
  public static Optional<SegmentColour> parse(String word) {
    return Arrays.stream(values()).filter(colour -> colour.toString().equals(word)).findFirst();
  }

  /** Returns the words of all colours. */
  public static String[] words() {
    return Arrays.stream(values()).map(SegmentColour::toString).toArray(String[]::new);
  }
}
