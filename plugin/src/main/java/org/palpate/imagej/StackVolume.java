package org.palpate.imagej;

import ij.ImagePlus;
import ij.ImageStack;
import ij.process.ImageProcessor;

/**
 * The z-stack of an image that is touched: one channel at one time, grey values of 8, 16 or 32 bit.
 * Reads and writes single slices; the stack's pixels belong to ImageJ and may change at any time.
 *
 * @param image what the user sees
 * @param channel which of its channels, from 1
 * @param frame which of its times, from 1
 */
record StackVolume(ImagePlus image, int channel, int frame) {

  /**
   * The volume of an image at the channel and time that it shows.
   *
   * @throws StackRefused where it is no grey stack
   */
  static StackVolume shownIn(ImagePlus image) throws StackRefused {
    if (image.getType() == ImagePlus.COLOR_RGB || image.getType() == ImagePlus.COLOR_256) {
      throw new StackRefused(
          "Palpate touches grey values and labels, and this is a colour image: convert it by Image > Type > 8-bit first.");
    }
    if (image.getNSlices() == 1 && image.getStackSize() > 1) {
      throw new StackRefused(
          "This stack has "
              + image.getNChannels()
              + " channels and "
              + image.getNFrames()
              + " times but one slice: if its images are slices, say so by Image > Properties...");
    }
    if (image.getNSlices() < 2) {
      throw new StackRefused("Palpate needs a stack of slices, and this is a single image.");
    }
    return new StackVolume(image, image.getC(), image.getT());
  }

  /** Whether the image has more channels or times than the one that is touched. */
  boolean isOneOfSeveral() {
    return image.getNChannels() > 1 || image.getNFrames() > 1;
  }

  int width() {
    return image.getWidth();
  }

  int height() {
    return image.getHeight();
  }

  int slices() {
    return image.getNSlices();
  }

  /** The pixels of slice k, from 0; written pixels are the stack's own. */
  ImageProcessor slice(int k) {
    ImageStack stack = image.getStack();
    return stack.getProcessor(image.getStackIndex(channel, k + 1, frame));
  }
}
