package org.palpate.io.dicom;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import org.palpate.io.dicom.DicomParser.PixelDataItem;
import org.palpate.io.file.NumberParser;
import org.palpate.io.volume.VolumeFormatException;

/**
 * A DICOM file: its attributes and the position of its pixel data.
 *
 * @param file its path
 * @param attributes attributes of the data set
 * @param syntax how the data set is encoded
 * @param deflatedFrom offset of the deflated data set, -1 if it is not deflated
 * @param order the byte order
 * @param pixelDataItems one item of native pixel data, or the fragments of encapsulated ones
 * @param encapsulated whether the items are fragments
 * @param swapped whether native pixels are big-endian words, in which bytes stand in pairs
 */
record DicomFile(
    Path file,
    DicomDataSet attributes,
    TransferSyntax syntax,
    long deflatedFrom,
    ByteOrder order,
    List<PixelDataItem> pixelDataItems,
    boolean encapsulated,
    boolean swapped) {
  /** The first attribute of group 2, as a little-endian number reads it. */
  private static final int META_LENGTH = 0x0000_0002;

  private static final int META_GROUP = 2;

  /** The remedy for an encoding that cannot be read. */
  static final String CONVERT = "convert it with gdcmconv --raw IN OUT (free, from GDCM)";

  /** Reads the attributes of a file, and no pixel. */
  static DicomFile read(Path file) throws VolumeFormatException {
    try (DicomBytes bytes = DicomBytes.open(file)) {
      return read(file, bytes);
    } catch (VolumeFormatException e) {
      throw e;
    } catch (IOException e) {
      throw new VolumeFormatException(
          "the file is damaged (" + e.getMessage() + ")", file, "copy or export it again", e);
    }
  }

  private static DicomFile read(Path file, DicomBytes bytes) throws IOException {
    DicomDataSet meta = new DicomDataSet();
    long body = bodyStart(bytes, meta);
    String uid = meta.text(DicomTag.TRANSFER_SYNTAX);
    if (uid.isEmpty()) {
      throw new VolumeFormatException(
          "the file has no transfer syntax, so its encoding is unknown", file, CONVERT);
    }
    boolean deflated = uid.equals(TransferSyntax.DEFLATED);
    ByteOrder order =
        uid.equals(TransferSyntax.BIG_ENDIAN) ? ByteOrder.BIG_ENDIAN : ByteOrder.LITTLE_ENDIAN;
    DicomDataSet attributes = new DicomDataSet();
    try (DicomBytes data = deflated ? DicomBytes.inflated(file, body) : bytes) {
      DicomParser parser = new DicomParser(data, deflated ? 0 : body, order);
      parser.parse(data.length(), !uid.equals(TransferSyntax.IMPLICIT), attributes);
      DicomFile dicom =
          new DicomFile(
              file,
              attributes,
              TransferSyntax.of(uid),
              deflated ? body : -1,
              order,
              List.copyOf(parser.pixelDataItems()),
              parser.isEncapsulated(),
              parser.areWords() && order == ByteOrder.BIG_ENDIAN);
      if (parser.isFloating()) {
        throw dicom.refusal("the pixels are floating-point numbers", CONVERT);
      }
      return dicom;
    }
  }

  /**
   * Returns the offset of the data set, after the preamble and group 2 if the file has them, and
   * stores the transfer syntax.
   */
  private static long bodyStart(DicomBytes bytes, DicomDataSet meta) throws IOException {
    int count = (int) Math.min(bytes.length(), DicomRecognizer.START_BYTES);
    byte[] start = new byte[count];
    bytes.at(0, count, ByteOrder.LITTLE_ENDIAN).get(start);
    if (DicomRecognizer.hasPreamble(start)) {
      return readMeta(bytes, DicomRecognizer.PREAMBLE + 4, meta);
    }
    if (!DicomRecognizer.isBare(start)) {
      throw new IOException("neither the letters DICM nor attributes are at its start");
    }
    ByteBuffer first = ByteBuffer.wrap(start).order(ByteOrder.LITTLE_ENDIAN);
    if (first.getShort(0) == META_GROUP) {
      return readMeta(bytes, 0, meta);
    }
    String uid =
        DicomRecognizer.isExplicit(first, 0) ? TransferSyntax.EXPLICIT : TransferSyntax.IMPLICIT;
    meta.put(DicomTag.TRANSFER_SYNTAX, uid.getBytes(StandardCharsets.ISO_8859_1));
    return 0;
  }

  /** Reads group 2, which is always explicit and little-endian, and returns the offset after it. */
  private static long readMeta(DicomBytes bytes, long at, DicomDataSet meta) throws IOException {
    ByteBuffer first = bytes.at(at, 12, ByteOrder.LITTLE_ENDIAN);
    long end = bytes.length();
    if (first.getInt(0) == META_LENGTH) {
      end = at + 12 + (first.getInt(8) & 0xffffffffL);
      if (end > bytes.length()) {
        throw new IOException("group 2 is longer than the file");
      }
    }
    return new DicomParser(bytes, at, ByteOrder.LITTLE_ENDIAN).parseMeta(end, meta);
  }

  /** Whether the file has pixel data. */
  boolean hasPixels() {
    return !pixelDataItems.isEmpty();
  }

  /** Returns the rows of a frame, 0 if unknown. */
  int rows() {
    return attributes.number(DicomTag.ROWS, 0);
  }

  /** Returns the columns of a frame, 0 if unknown. */
  int columns() {
    return attributes.number(DicomTag.COLUMNS, 0);
  }

  /** Returns the bits that a pixel takes in the file. */
  int bitsAllocated() {
    return attributes.number(DicomTag.BITS_ALLOCATED, 0);
  }

  /** Returns the bits of a pixel that carry its value. */
  int bitsStored() {
    return attributes.number(DicomTag.BITS_STORED, bitsAllocated());
  }

  /** Returns the index of the highest bit that carries the value. */
  int highBit() {
    return attributes.number(DicomTag.HIGH_BIT, bitsStored() - 1);
  }

  /** Whether pixels are signed. */
  boolean isSigned() {
    return attributes.number(DicomTag.SIGNED, 0) == 1;
  }

  /** Returns the numbers that a pixel has: 1 for grey values, 3 for colours. */
  int samples() {
    return attributes.number(DicomTag.SAMPLES, 1);
  }

  /** Returns the bits of one decoded frame. Frames of 1 bit a pixel share bytes. */
  long frameBits() {
    return (long) rows() * columns() * samples() * bitsAllocated();
  }

  /** Returns the size of one decoded frame in bytes, rounded up. */
  long frameBytes() {
    return (frameBits() + 7) / 8;
  }

  /** Returns the number of frames, 1 if the file does not name it. */
  int frameCount() throws VolumeFormatException {
    String text = attributes.text(DicomTag.FRAMES);
    int count = text.isEmpty() ? 1 : NumberParser.positiveInt(text);
    if (count < 1) {
      throw refusal("the number of frames is no positive integer", "export the file again");
    }
    return count;
  }

  /** Returns an exception for pixels that cannot be decoded. */
  VolumeFormatException damagedPixels(Exception cause) {
    return new VolumeFormatException(
        "the pixels are damaged (" + cause.getMessage() + ")",
        file,
        "copy or export the file again",
        cause);
  }

  /** Returns an exception that names this file. */
  VolumeFormatException refusal(String what, String remedy) {
    return new VolumeFormatException(what, file, remedy);
  }
}
