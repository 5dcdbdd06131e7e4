package org.palpate.io.dicom;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;

/** Writes DICOM slices of 16 bit, explicit little-endian. */
public final class DicomSliceWriter {
  static final int COLUMNS = 6;
  static final int ROWS = 5;

  private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();

  private DicomSliceWriter() {}

  /**
   * Writes a slice with spacings 0.5 (columns) and 0.75 mm (rows) whose pixels all hold one value.
   */
  public static Path slice(
      Path file, String seriesUid, String position, String orientation, int value)
      throws IOException {
    byte[] pixels = new byte[2 * ROWS * COLUMNS];
    for (int n = 0; n < pixels.length; n += 2) {
      pixels[n] = (byte) value;
      pixels[n + 1] = (byte) (value >> 8);
    }
    DicomSliceWriter writer = withHeader(seriesUid, position, orientation);
    writer.picture(COLUMNS, ROWS, 12, "0.75\\0.5", pixels);
    return Files.write(file, writer.bytes.toByteArray());
  }

  /** Writes an axial slice of given pixels with a spacing of 1 mm. */
  public static Path slice(Path file, double z, int columns, int rows, byte[] pixels)
      throws IOException {
    DicomSliceWriter writer = withHeader("1.2.3", "0\\0\\" + z, "1\\0\\0\\0\\1\\0");
    writer.picture(columns, rows, 16, "1\\1", pixels);
    return Files.write(file, writer.bytes.toByteArray());
  }

  private static DicomSliceWriter withHeader(String seriesUid, String position, String orientation)
      throws IOException {
    DicomSliceWriter writer = new DicomSliceWriter();
    writer.bytes.write(new byte[128]);
    writer.bytes.write("DICM".getBytes(StandardCharsets.ISO_8859_1));
    writer.put(
        0x0002_0000,
        "UL",
        ByteBuffer.allocate(4).order(ByteOrder.LITTLE_ENDIAN).putInt(28).array());
    writer.text(0x0002_0010, "UI", "1.2.840.10008.1.2.1");
    writer.text(0x0008_0060, "CS", "CT");
    writer.text(0x0010_0010, "PN", "Nobody^Secret");
    writer.text(0x0018_0050, "DS", "9");
    writer.text(0x0020_000E, "UI", seriesUid);
    writer.text(0x0020_0032, "DS", position);
    writer.text(0x0020_0037, "DS", orientation);
    return writer;
  }

  private void picture(int columns, int rows, int bits, String spacing, byte[] pixels)
      throws IOException {
    number(0x0028_0002, 1);
    number(0x0028_0010, rows);
    number(0x0028_0011, columns);
    text(0x0028_0030, "DS", spacing);
    number(0x0028_0100, 16);
    number(0x0028_0101, bits);
    number(0x0028_0102, bits - 1);
    number(0x0028_0103, 0);
    put(0x7FE0_0010, "OW", pixels);
  }

  private void text(int tag, String vr, String text) throws IOException {
    String pad = text.length() % 2 == 0 ? "" : vr.equals("UI") ? "\0" : " ";
    put(tag, vr, (text + pad).getBytes(StandardCharsets.ISO_8859_1));
  }

  private void number(int tag, int value) throws IOException {
    put(tag, "US", new byte[] {(byte) value, (byte) (value >> 8)});
  }

  private void put(int tag, String vr, byte[] value) throws IOException {
    ByteBuffer head = ByteBuffer.allocate(12).order(ByteOrder.LITTLE_ENDIAN);
    head.putShort((short) (tag >>> 16)).putShort((short) tag);
    head.put(vr.getBytes(StandardCharsets.ISO_8859_1));
    if (vr.equals("OW")) {
      head.putShort((short) 0).putInt(value.length);
    } else {
      head.putShort((short) value.length);
    }
    bytes.write(head.array(), 0, head.position());
    bytes.write(value);
  }
}
