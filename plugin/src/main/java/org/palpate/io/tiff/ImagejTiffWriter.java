package org.palpate.io.tiff;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.io.file.NumberText;
import org.palpate.io.format.MemoryCheck;
import org.palpate.io.format.SliceWriter;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeReader;
import org.palpate.volume.VoxelGrid;

/**
 * Writes a volume as the TIFF stack that ImageJ itself writes: uncompressed, with spacing, origin
 * and unit. A file of more than 4 GiB has a single page, as ImageJ's have.
 *
 * <p>Source: TIFF Revision 6.0; the description and the layout of ImageJ's TiffEncoder.
 */
public final class ImagejTiffWriter {
  private static final int HEADER_BYTES = 8;
  private static final int ENTRIES = 15;
  private static final int PAGE_BYTES = 2 + 12 * ENTRIES + 4;
  private static final int RATIONAL_BYTES = 8;
  private static final long MAX_OFFSET = 0xffffffffL;
  private static final int SHORT = 3;
  private static final int LONG = 4;
  private static final int RATIONAL = 5;
  private static final int ASCII = 2;

  private final VolumeReader volume;
  private final VoxelGrid grid;
  private final StackValues values;
  private final byte[] description;
  private final int pages;

  private ImagejTiffWriter(VolumeReader volume, StackValues values) {
    this.volume = volume;
    this.values = values;
    grid = volume.header().grid();
    description = (description() + "\0").getBytes(StandardCharsets.UTF_8);
    boolean small = dataOffset(grid.sizeZ()) + sliceBytes() * grid.sizeZ() <= MAX_OFFSET;
    pages = small ? grid.sizeZ() : 1;
  }

  /**
   * Writes a volume and returns what was written, in words. Reads the volume twice if its header
   * does not show that its values fit a type of ImageJ.
   *
   * @throws VolumeFormatException if the volume cannot be read
   * @throws IOException if the stream cannot be written
   */
  public static String write(VolumeReader volume, OutputStream out) throws IOException {
    StackValues values = StackValues.of(volume);
    ImagejTiffWriter writer = new ImagejTiffWriter(volume, values);
    writer.writePages(out);
    writer.writeSlices(out);
    return "TIFF of ImageJ, " + values.description();
  }

  private long sliceBytes() {
    return (long) grid.sizeX() * grid.sizeY() * values.bytes();
  }

  private long dataOffset(int pageCount) {
    long end = HEADER_BYTES + (long) PAGE_BYTES * pageCount + 2 * RATIONAL_BYTES;
    return (end + description.length + 15) / 16 * 16;
  }

  /** Returns the text by which ImageJ knows its own files. */
  private String description() {
    StringBuilder text = new StringBuilder("ImageJ=1.54p\n");
    if (grid.sizeZ() > 1) {
      line(text, "images", Integer.toString(grid.sizeZ()));
      line(text, "slices", Integer.toString(grid.sizeZ()));
    }
    line(text, "unit", "mm");
    if (values.isOffset()) {
      line(text, "cf", "0");
      line(text, "c0", "-32768.0");
      line(text, "c1", "1.0");
      line(text, "vunit", "Gray Value");
    }
    line(text, "spacing", NumberText.text(grid.spacingMm().z));
    line(text, "loop", "false");
    if (isAlongAxes(grid)) {
      for (int axis = 0; axis < 3; axis++) {
        double corner = grid.gridToWorld(new Vec3(), new Vec3()).get(axis);
        line(
            text,
            "xyz".charAt(axis) + "origin",
            NumberText.text(-corner / grid.spacingMm().get(axis) + 0.0));
      }
    }
    return text.toString();
  }

  private static void line(StringBuilder text, String key, String value) {
    text.append(key).append('=').append(value).append('\n');
  }

  /** Whether the axes of a grid are those of the world, so that ImageJ's origin can state it. */
  public static boolean isAlongAxes(VoxelGrid grid) {
    RigidTransform axes = grid.gridMmToWorld();
    return axes.axisX().x == 1 && axes.axisY().y == 1 && axes.axisZ().z == 1;
  }

  private void writePages(OutputStream out) throws IOException {
    long data = dataOffset(pages);
    ByteBuffer bytes = ByteBuffer.allocate((int) data).order(ByteOrder.LITTLE_ENDIAN);
    bytes.put((byte) 'I').put((byte) 'I').putShort((short) 42).putInt(HEADER_BYTES);
    int after = HEADER_BYTES + PAGE_BYTES * pages;
    for (int page = 0; page < pages; page++) {
      boolean last = page == pages - 1;
      putPage(bytes, after, data + page * sliceBytes());
      bytes.putInt(last ? 0 : bytes.position() + 4);
    }
    putRational(bytes, grid.spacingMm().x);
    putRational(bytes, grid.spacingMm().y);
    bytes.put(description);
    out.write(bytes.array());
  }

  /**
   * Writes the entries of a page, in the order of their tags.
   *
   * @param after where the resolutions and then the description are
   */
  private void putPage(ByteBuffer bytes, int after, long data) {
    bytes.putShort((short) ENTRIES);
    entry(bytes, 254, LONG, 1, 0);
    entry(bytes, 256, LONG, 1, grid.sizeX());
    entry(bytes, 257, LONG, 1, grid.sizeY());
    entry(bytes, 258, SHORT, 1, 8L * values.bytes());
    entry(bytes, 259, SHORT, 1, 1);
    entry(bytes, 262, SHORT, 1, TiffPixels.BLACK_IS_ZERO);
    entry(bytes, 270, ASCII, description.length, after + 2L * RATIONAL_BYTES);
    entry(bytes, 273, LONG, 1, data);
    entry(bytes, 277, SHORT, 1, 1);
    entry(bytes, 278, LONG, 1, grid.sizeY());
    entry(bytes, 279, LONG, 1, sliceBytes());
    entry(bytes, 282, RATIONAL, 1, after);
    entry(bytes, 283, RATIONAL, 1, after + RATIONAL_BYTES);
    entry(bytes, 296, SHORT, 1, 1);
    entry(bytes, 339, SHORT, 1, values.isFloat() ? 3 : 1);
  }

  private static void entry(ByteBuffer bytes, int tag, int type, int count, long value) {
    bytes.putShort((short) tag).putShort((short) type).putInt(count).putInt((int) value);
  }

  /** Writes pixels a mm as the fraction whose reciprocal is nearest to the spacing. */
  private static void putRational(ByteBuffer bytes, double spacingMm) {
    int[] fraction = Fraction.reciprocalOf(spacingMm);
    bytes.putInt(fraction[0]).putInt(fraction[1]);
  }

  private void writeSlices(OutputStream out) throws IOException {
    MemoryCheck.require(2.0 * sliceBytes(), "one slice", volume.sourceName());
    byte[] bytes = new byte[Math.toIntExact(sliceBytes())];
    SliceWriter.writeAll(
        volume::read,
        (k, slice) -> {
          values.put(slice, ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN));
          out.write(bytes);
        });
  }
}
