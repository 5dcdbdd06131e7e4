package org.palpate.io.dicom;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Consumer;

/**
 * A DICOM image for tests, whose attributes can be changed one by one: 4x3 pixels of 16 bits, 1 mm,
 * values 0 to 11 plus a start.
 */
final class DicomTestFile {
  static final int COLUMNS = 4;
  static final int ROWS = 3;
  private static final int COMPRESSED_ITEM = 0xFFFE_E000;

  private final Map<Integer, Consumer<DicomElements>> attributes =
      new TreeMap<>(Integer::compareUnsigned);
  private String syntax = TransferSyntax.EXPLICIT;

  /** Creates an axial image at a height. */
  DicomTestFile(double z, int start) {
    text(DicomTag.SOP_CLASS, "UI", "1.2.840.10008.5.1.4.1.1.2");
    text(DicomTag.MODALITY, "CS", "MR");
    text(0x0010_0010, "PN", "Nobody^Secret");
    text(DicomTag.SERIES_UID, "UI", "1.2.3");
    text(DicomTag.POSITION, "DS", "0\\0\\" + z);
    text(DicomTag.ORIENTATION, "DS", "1\\0\\0\\0\\1\\0");
    number(DicomTag.SAMPLES, 1);
    text(DicomTag.PHOTOMETRIC, "CS", "MONOCHROME2");
    number(DicomTag.ROWS, ROWS);
    number(DicomTag.COLUMNS, COLUMNS);
    text(DicomTag.PIXEL_SPACING, "DS", "1\\1");
    number(DicomTag.BITS_ALLOCATED, 16);
    number(DicomTag.BITS_STORED, 16);
    number(DicomTag.HIGH_BIT, 15);
    number(DicomTag.SIGNED, 0);
    ByteBuffer pixels = ByteBuffer.allocate(2 * COLUMNS * ROWS).order(ByteOrder.LITTLE_ENDIAN);
    for (int n = 0; n < COLUMNS * ROWS; n++) {
      pixels.putShort((short) (start + n));
    }
    pixels("OW", pixels.array());
  }

  DicomTestFile text(int tag, String vr, String value) {
    attributes.put(tag, elements -> elements.text(tag, vr, value));
    return this;
  }

  DicomTestFile number(int tag, int value) {
    attributes.put(tag, elements -> elements.shorts(tag, value));
    return this;
  }

  DicomTestFile sequence(int tag, DicomElements... items) {
    attributes.put(tag, elements -> elements.sequence(tag, items));
    return this;
  }

  DicomTestFile pixels(String vr, byte[] bytes) {
    attributes.put(DicomTag.PIXELS, elements -> elements.value(DicomTag.PIXELS, vr, bytes));
    return this;
  }

  DicomTestFile without(int tag) {
    attributes.remove(tag);
    return this;
  }

  /** Makes every pixel one byte. */
  DicomTestFile bytes(byte[] pixels) {
    number(DicomTag.BITS_ALLOCATED, 8);
    number(DicomTag.BITS_STORED, 8);
    number(DicomTag.HIGH_BIT, 7);
    return pixels("OB", pixels);
  }

  /** Encapsulates one frame in a transfer syntax. */
  DicomTestFile compressed(String uid, byte[] frame) {
    syntax = uid;
    byte[] padded = Arrays.copyOf(frame, (frame.length + 1) / 2 * 2);
    attributes.put(
        DicomTag.PIXELS,
        elements ->
            elements
                .head(DicomTag.PIXELS, "OB", 0xffffffffL)
                .head(COMPRESSED_ITEM, "", 0)
                .value(COMPRESSED_ITEM, "", padded)
                .head(DicomTag.SEQUENCE_END, "", 0));
    return this;
  }

  Path write(Path file) throws IOException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    out.write(new byte[128]);
    out.writeBytes("DICM".getBytes(StandardCharsets.ISO_8859_1));
    byte[] meta = new DicomElements().text(DicomTag.TRANSFER_SYNTAX, "UI", syntax).toBytes();
    out.writeBytes(new DicomElements().ints(0x0002_0000, meta.length).toBytes());
    out.writeBytes(meta);
    out.writeBytes(dataSet());
    return Files.write(file, out.toByteArray());
  }

  /** Returns the attributes alone, without preamble and group 2. */
  byte[] dataSet() {
    DicomElements elements = new DicomElements();
    attributes.values().forEach(attribute -> attribute.accept(elements));
    return elements.toBytes();
  }
}
