package org.palpate.imagej.stack;

import ij.IJ;
import ij.ImagePlus;
import ij.ImageStack;
import ij.io.FileInfo;
import ij.process.ImageProcessor;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.palpate.host.SolverKind;
import org.palpate.io.VolumeFiles;
import org.palpate.io.volume.LabelTable;
import org.palpate.io.volume.ReadOptions;

/**
 * The touched z-stack of an image: one channel at one time, grey values of 8, 16 or 32 bits.
 *
 * <p>Reads and writes single slices. The pixels belong to ImageJ and may change at any time.
 *
 * @param image the image that the user sees
 * @param channel channel, counted from 1
 * @param frame time, counted from 1
 * @param width width of a slice when the volume was created, pixels
 * @param height height of a slice, pixels
 * @param slices number of slices
 */
public record StackVolume(
    ImagePlus image, int channel, int frame, int width, int height, int slices) {
  /** The property of an image that holds the label table of the volume that was opened. */
  static final String LABELS = "palpate.labels";

  /**
   * Returns the volume of an image at the channel and time that it shows.
   *
   * @throws TouchRefusedException if the image is not a stack of grey values
   */
  public static StackVolume shownIn(ImagePlus image) throws TouchRefusedException {
    if (image.getType() == ImagePlus.COLOR_RGB) {
      throw new TouchRefusedException(
          "Palpate touches grey values and labels, but this is a colour image: convert it with"
              + " Image > Type > 8-bit first.");
    }
    if (image.getNSlices() == 1 && image.getStackSize() > 1) {
      throw new TouchRefusedException(
          "This stack has "
              + image.getNChannels()
              + " channels and "
              + image.getNFrames()
              + " times but one slice: if its images are slices, change this in Image >"
              + " Properties...");
    }
    if (image.getNSlices() < 2) {
      throw new TouchRefusedException(
          "Palpate needs a stack of slices, but this is a single image.");
    }
    if (image.getStack().isVirtual()) {
      throw new TouchRefusedException(
          "This is a virtual stack, whose slices are read from disk each time: copy it with Image >"
              + " Duplicate... first.");
    }
    return new StackVolume(
        image, image.getC(), image.getT(), image.getWidth(), image.getHeight(), image.getNSlices());
  }

  /**
   * Logs a warning if the voxels are too long for a solver. A dialog would hold macros up.
   *
   * @throws TouchRefusedException if a voxel edge is not positive and finite
   */
  public void logWarning(SolverKind solver) throws TouchRefusedException {
    solver
        .warning(image.getTitle(), List.of(StackGeometry.of(image).grid()))
        .ifPresent(line -> IJ.log("Palpate: " + line));
  }

  /** Whether the image has channels or times besides the touched one. */
  public boolean hasMoreChannelsOrTimes() {
    return image.getNChannels() > 1 || image.getNFrames() > 1;
  }

  /**
   * Returns names and colours of labels, from the volume that the image was opened from or from a
   * table beside the image's file; empty if there is none.
   */
  public LabelTable labelTable() {
    if (image.getProperty(LABELS) instanceof LabelTable opened) {
      return opened;
    }
    Optional<Path> file = file();
    try {
      return file.isPresent()
          ? VolumeFiles.open(file.get(), ReadOptions.defaults())
              .header()
              .labels()
              .orElse(LabelTable.EMPTY)
          : LabelTable.EMPTY;
    } catch (IOException e) {
      // the image is open, so the state of its file does not matter
      return LabelTable.EMPTY;
    }
  }

  /** Returns the file that the image was opened from, if there still is one. */
  public Optional<Path> file() {
    FileInfo info = image.getOriginalFileInfo();
    String path = info == null ? null : info.getFilePath();
    try {
      return path == null || path.isEmpty()
          ? Optional.empty()
          : Optional.of(Path.of(path)).filter(Files::isRegularFile);
    } catch (InvalidPathException e) {
      return Optional.empty();
    }
  }

  /**
   * Returns the stack's own pixels of slice k, counted from 0: bytes, shorts or floats, row by row.
   *
   * @throws TouchRefusedException if the size or type of the stack has changed
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
          "The size or type of the stack changed while it was touched: start again.");
    }
    return pixels;
  }

  /** Returns the number of pixels of a slice. */
  static int pixelCount(Object pixels) {
    if (pixels instanceof byte[] bytes) {
      return bytes.length;
    }
    return pixels instanceof short[] shorts ? shorts.length : ((float[]) pixels).length;
  }

  /** Returns the raw value of a pixel of a slice. */
  static float value(Object pixels, int n) {
    if (pixels instanceof byte[] bytes) {
      return bytes[n] & 0xFF;
    }
    return pixels instanceof short[] shorts ? shorts[n] & 0xFFFF : ((float[]) pixels)[n];
  }

  /** Returns a processor of slice k, counted from 0. It writes into the stack's own pixels. */
  public ImageProcessor slice(int k) {
    ImageStack stack = image.getStack();
    return stack.getProcessor(image.getStackIndex(channel, k + 1, frame));
  }
}
