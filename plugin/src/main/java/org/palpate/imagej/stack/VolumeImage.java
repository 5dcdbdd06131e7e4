package org.palpate.imagej.stack;

import ij.IJ;
import ij.ImagePlus;
import ij.ImageStack;
import ij.measure.Calibration;
import ij.process.LUT;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.palpate.geometry.Vec3;
import org.palpate.io.OrientationText;
import org.palpate.io.format.MemoryCheck;
import org.palpate.io.tiff.ImagejTiffWriter;
import org.palpate.io.tiff.StackValues;
import org.palpate.io.volume.LabelTable;
import org.palpate.io.volume.LabelTable.Label;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeHeader;
import org.palpate.io.volume.VolumeReader;
import org.palpate.io.volume.VoxelSlice;
import org.palpate.volume.VoxelGrid;

/**
 * Makes an ImageJ stack from a volume file, with its spacing, unit and origin, and with the names
 * and colours of its labels. One thread.
 */
public final class VolumeImage {
  private static final int LUT_SIZE = 256;

  private final VolumeHeader header;
  private final StackValues values;
  private final ImageStack stack;
  private double low = Double.POSITIVE_INFINITY;
  private double high = Double.NEGATIVE_INFINITY;

  private VolumeImage(VolumeHeader header, StackValues values) {
    this.values = values;
    this.header = header;
    stack = new ImageStack(header.grid().sizeX(), header.grid().sizeY());
  }

  /**
   * Reads a volume into a stack, which is not shown yet.
   *
   * @param file the file of the volume, which names the stack
   * @throws VolumeFormatException if the volume cannot be read, or does not fit in memory
   * @throws TouchRefusedException if the user pressed Escape
   */
  public static ImagePlus read(VolumeReader volume, Path file)
      throws VolumeFormatException, TouchRefusedException {
    VolumeImage image = new VolumeImage(volume.header(), StackValues.of(volume));
    VoxelGrid grid = volume.header().grid();
    double bytes = (double) grid.voxelCount() * image.values.bytes();
    MemoryCheck.require(bytes, "the stack", volume.sourceName());
    try {
      volume.read(image::addSlice);
    } catch (EscapeException e) {
      throw new TouchRefusedException("Escape was pressed: the volume was not opened.");
    }
    return image.finished(file);
  }

  /** Ends a read that the user no longer wants. */
  private static final class EscapeException extends RuntimeException {
    private static final long serialVersionUID = 1L;
  }

  private void addSlice(int k, VoxelSlice slice) {
    if (IJ.escapePressed()) {
      throw new EscapeException();
    }
    for (int n = 0; n < slice.count(); n++) {
      double value = slice.value(n);
      low = value < low ? value : low; // NaN is neither
      high = value > high ? value : high;
    }
    stack.addSlice("", pixels(slice));
    IJ.showProgress(k + 1, header.grid().sizeZ());
  }

  private Object pixels(VoxelSlice slice) {
    byte[] bytes = new byte[Math.multiplyExact(slice.count(), values.bytes())];
    ByteBuffer buffer = ByteBuffer.wrap(bytes).order(ByteOrder.nativeOrder());
    values.put(slice, buffer);
    buffer.rewind();
    if (values.bytes() == 1) {
      return bytes;
    }
    if (values.isFloat()) {
      float[] floats = new float[slice.count()];
      buffer.asFloatBuffer().get(floats);
      return floats;
    }
    short[] shorts = new short[slice.count()];
    buffer.asShortBuffer().get(shorts);
    return shorts;
  }

  private ImagePlus finished(Path file) {
    String name = file.getFileName().toString();
    ImagePlus image = new ImagePlus(name, stack);
    image.setDimensions(1, stack.size(), 1);
    calibrate(image);
    image.setProperty("Info", String.join("\n", info()) + "\n");
    double raw = values.isOffset() ? Short.MAX_VALUE + 1.0 : 0;
    if (low <= high) {
      image.setDisplayRange(low + raw, Math.max(high, low + 1) + raw);
    }
    header.labels().ifPresent(table -> name(image, table));
    return image;
  }

  private void calibrate(ImagePlus image) {
    VoxelGrid grid = header.grid();
    Calibration calibration = new Calibration(image);
    calibration.setUnit("mm");
    calibration.pixelWidth = grid.spacingMm().x;
    calibration.pixelHeight = grid.spacingMm().y;
    calibration.pixelDepth = grid.spacingMm().z;
    if (ImagejTiffWriter.isAlongAxes(grid)) {
      Vec3 corner = grid.gridToWorld(new Vec3(), new Vec3());
      calibration.xOrigin = -corner.x / grid.spacingMm().x + 0.0;
      calibration.yOrigin = -corner.y / grid.spacingMm().y + 0.0;
      calibration.zOrigin = -corner.z / grid.spacingMm().z + 0.0;
    }
    if (values.isOffset()) {
      calibration.setSigned16BitCalibration();
    }
    image.setCalibration(calibration);
  }

  /** Returns the lines of Image > Show Info...: format, axes, notes and names of labels. */
  private List<String> info() {
    List<String> lines = new ArrayList<>();
    lines.add("Opened by Palpate: " + header.format() + ", " + values.description());
    lines.add("World: " + header.coordinateSystem().description());
    lines.addAll(OrientationText.describe(header));
    header.notes().forEach(note -> lines.add("Note: " + note));
    header
        .labels()
        .ifPresent(
            table ->
                table
                    .labels()
                    .forEach((value, label) -> lines.add("Label " + value + ": " + label.name())));
    return lines;
  }

  /** Keeps names and colours with the image, and shows labels of 8 bits in their colours. */
  private void name(ImagePlus image, LabelTable table) {
    image.setProperty(StackVolume.LABELS, table);
    if (values.bytes() != 1 || table.labels().isEmpty()) {
      return;
    }
    byte[] red = new byte[LUT_SIZE];
    byte[] green = new byte[LUT_SIZE];
    byte[] blue = new byte[LUT_SIZE];
    for (int value = 1; value < LUT_SIZE; value++) {
      Label label = table.labels().get((long) value);
      int rgb = label == null ? SegmentColour.byNumber(value).rgb() : label.rgb();
      red[value] = (byte) (rgb >> 16);
      green[value] = (byte) (rgb >> 8);
      blue[value] = (byte) rgb;
    }
    image.setLut(new LUT(red, green, blue));
    image.setDisplayRange(0, LUT_SIZE - 1);
  }
}
