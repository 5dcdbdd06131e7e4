package org.palpate.imagej.stack;

import ij.ImagePlus;
import ij.ImageStack;
import ij.process.ByteProcessor;
import ij.process.FloatProcessor;
import ij.process.ImageProcessor;
import ij.process.ShortProcessor;

/** Makes stacks for tests. */
public final class Stacks {
  private Stacks() {}

  /** The value of a voxel. */
  @FunctionalInterface
  public interface Values {
    /** Returns the raw value of voxel (i,j,k). */
    double at(int i, int j, int k);
  }

  /** Returns a stack of 8, 16 or 32 bits with these raw values. */
  public static ImagePlus of(int bits, int width, int height, int slices, Values values) {
    ImageStack stack = new ImageStack(width, height);
    for (int k = 0; k < slices; k++) {
      ImageProcessor slice = slice(bits, width, height);
      for (int j = 0; j < height; j++) {
        for (int i = 0; i < width; i++) {
          slice.setf(i, j, (float) values.at(i, j, k));
        }
      }
      stack.addSlice(slice);
    }
    ImagePlus image = new ImagePlus("stack", stack);
    image.setDimensions(1, slices, 1);
    return image;
  }

  private static ImageProcessor slice(int bits, int width, int height) {
    return switch (bits) {
      case 8 -> new ByteProcessor(width, height);
      case 16 -> new ShortProcessor(width, height);
      default -> new FloatProcessor(width, height);
    };
  }
}
