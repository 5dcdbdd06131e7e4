package org.palpate.io.format;

/**
 * Makes a grey value of a colour.
 *
 * <p>Source: ITU-R BT.601, the weights of luminance.
 */
public final class Luminance {
  /** The sentence by which a volume says that it was read from colours. */
  public static final String NOTE =
      "the voxels are colours: each is read as its luminance, 0.299 R + 0.587 G + 0.114 B";

  private Luminance() {}

  /**
   * Returns the luminance of a colour, rounded. It has the range of the parts, which must not be
   * negative.
   */
  public static int of(int red, int green, int blue) {
    return (int) ((299L * red + 587L * green + 114L * blue + 500) / 1000);
  }
}
