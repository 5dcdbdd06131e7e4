package org.palpate.imagej.stack;

import ij.ImagePlus;
import ij.ImageStack;
import ij.io.FileInfo;
import ij.process.ImageProcessor;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import org.palpate.io.VolumeFiles;
import org.palpate.io.volume.LabelTable;
import org.palpate.io.volume.ReadOptions;

/**
 * The z-stack of an image that is touched: one channel at one time, grey values of 8, 16 or 32 bit.
 * Reads and writes single slices; the stack's pixels belong to ImageJ and may change at any time.
 *
 * @param image what the user sees
 * @param channel which of its channels, from 1
 * @param frame which of its times, from 1
 * @param width of a slice when it was taken up, pixels; height and slices likewise
 */
public record StackVolume(
    ImagePlus image, int channel, int frame, int width, int height, int slices) {

  /**
   * The volume of an image at the channel and time that it shows.
   *
   * @throws TouchRefusedException where it is no grey stack
   */
  public static StackVolume shownIn(ImagePlus image) throws TouchRefusedException {
    if (image.getType() == ImagePlus.COLOR_RGB) {
      throw new TouchRefusedException(
          "Palpate touches grey values and labels, and this is a colour image: convert it by Image > Type > 8-bit first.");
    }
    if (image.getNSlices() == 1 && image.getStackSize() > 1) {
      throw new TouchRefusedException(
          "This stack has "
              + image.getNChannels()
              + " channels and "
              + image.getNFrames()
              + " times but one slice: if its images are slices, say so by Image > Properties...");
    }
    if (image.getNSlices() < 2) {
      throw new TouchRefusedException(
          "Palpate needs a stack of slices, and this is a single image.");
    }
    if (image.getStack().isVirtual()) {
      throw new TouchRefusedException(
          "This is a virtual stack, whose slices are read from disk each time: make it a real one by Image > Duplicate... first.");
    }
    return new StackVolume(
        image, image.getC(), image.getT(), image.getWidth(), image.getHeight(), image.getNSlices());
  }

  /** Whether the image has more channels or times than the one that is touched. */
  public boolean hasMoreChannelsOrTimes() {
    return image.getNChannels() > 1 || image.getNFrames() > 1;
  }

  /**
   * Names and colours of labels, from a table beside the image's file; none where there is none.
   */
  public LabelTable labelTable() {
    FileInfo file = image.getOriginalFileInfo();
    if (file == null || file.getFilePath() == null || file.getFilePath().isEmpty()) {
      return LabelTable.EMPTY;
    }
    try {
      Path path = Path.of(file.getFilePath());
      return Files.isRegularFile(path)
          ? VolumeFiles.open(path, ReadOptions.defaults())
              .header()
              .labels()
              .orElse(LabelTable.EMPTY)
          : LabelTable.EMPTY;
    } catch (InvalidPathException | IOException e) {
      // the image is open: what its file is like does not matter
      return LabelTable.EMPTY;
    }
  }

  /**
   * The stack's own pixels of slice k, from 0: bytes, shorts or floats, row by row.
   *
   * @throws TouchRefusedException where the image is no such stack any more
   */
  Object pixels(int k) throws TouchRefusedException {
    ImageStack stack = image.getStack();
    int number = image.getStackIndex(channel, k + 1, frame);
    Object pixels = number <= stack.size() ? stack.getPixels(number) : null;
    boolean grey =
        pixels instanceof byte[] || pixels instanceof short[] || pixels instanceof float[];
    boolean same = grey && pixelCount(pixels) == width * height && stack.getWidth() == width;
    if (!same || image.getNSlices() != slices) {
      throw new TouchRefusedException(
          "The stack got another size or type while it was touched: touch it again.");
    }
    return pixels;
  }

  static int pixelCount(Object pixels) {
    if (pixels instanceof byte[] bytes) {
      return bytes.length;
    }
    return pixels instanceof short[] shorts ? shorts.length : ((float[]) pixels).length;
  }

  /** The raw value of a pixel of {@link #pixels}. */
  static float value(Object pixels, int n) {
    if (pixels instanceof byte[] bytes) {
      return bytes[n] & 0xFF;
    }
    return pixels instanceof short[] shorts ? shorts[n] & 0xFFFF : ((float[]) pixels)[n];
  }

  /** The pixels of slice k, from 0; written pixels are the stack's own. */
  public ImageProcessor slice(int k) {
    ImageStack stack = image.getStack();
    return stack.getProcessor(image.getStackIndex(channel, k + 1, frame));
  }
}
