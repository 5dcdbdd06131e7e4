package org.palpate.scene.window;

import java.awt.image.BufferedImage;

/** The pixels of a drawn scene, opaque, row by row from the top. Read-only. */
public final class Picture {
  private final int width;
  private final int height;
  private final int[] rgb;

  Picture(int width, int height, int[] rgb) {
    this.width = width;
    this.height = height;
    this.rgb = rgb;
  }

  /** Returns the width in pixels. */
  public int width() {
    return width;
  }

  /** Returns the height in pixels. */
  public int height() {
    return height;
  }

  /** Returns a pixel as 0xRRGGBB. */
  public int rgb(int x, int y) {
    return rgb[y * width + x];
  }

  /** Returns the picture as an image that can be written to a file. */
  public BufferedImage toImage() {
    BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
    image.setRGB(0, 0, width, height, rgb, 0, width);
    return image;
  }
}
