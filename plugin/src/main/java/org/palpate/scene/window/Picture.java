package org.palpate.scene.window;

import java.awt.image.BufferedImage;

/** Pixels of a drawn scene, opaque, row by row from the top. Not to be changed. */
public final class Picture {
  private final int width;
  private final int height;
  private final int[] rgb;

  Picture(int width, int height, int[] rgb) {
    this.width = width;
    this.height = height;
    this.rgb = rgb;
  }

  public int width() {
    return width;
  }

  public int height() {
    return height;
  }

  /** A pixel as 0xRRGGBB. */
  public int rgb(int x, int y) {
    return rgb[y * width + x];
  }

  /** The same as an image that can be written to a file. */
  public BufferedImage toImage() {
    BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
    image.setRGB(0, 0, width, height, rgb, 0, width);
    return image;
  }
}
