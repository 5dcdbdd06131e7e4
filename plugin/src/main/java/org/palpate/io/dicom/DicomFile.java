package org.palpate.io.dicom;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import org.palpate.io.dicom.DicomParser.PixelDataItem;
import org.palpate.io.file.NumberParser;
import org.palpate.io.format.InputFiles;
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
 */
record DicomFile(
    Path file,
    DicomDataSet attributes,
    TransferSyntax syntax,
    long deflatedFrom,
    ByteOrder order,
    List<PixelDataItem> pixelDataItems,
    boolean encapsulated) {
  private static final int PREAMBLE = 128;
  private static final String CONVERT = "convert it with gdcmconv --raw IN OUT (free, from GDCM)";

  /** Returns whether a file with these first bytes is a DICOM file. */
  static boolean isDicom(byte[] start) {
    return start.length >= PREAMBLE + 4
        && new String(start, PREAMBLE, 4, StandardCharsets.ISO_8859_1).equals("DICM");
  }

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
    long body = readMeta(bytes, meta);
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
              parser.isEncapsulated());
      if (parser.isFloating()) {
        throw dicom.refusal("the pixels are floating-point numbers", CONVERT);
      }
      return dicom;
    }
  }

  /** Reads group 2, which is always explicit and little-endian, and returns the offset after it. */
  private static long readMeta(DicomBytes bytes, DicomDataSet meta) throws IOException {
    long at = PREAMBLE + 4;
    ByteBuffer first = bytes.at(at, 12, ByteOrder.LITTLE_ENDIAN);
    if (first.getInt(0) != 0x0000_0002) {
      throw new IOException("group 2 is missing");
    }
    long end = at + 12 + (first.getInt(8) & 0xffffffffL);
    if (end > bytes.length()) {
      throw new IOException("group 2 is longer than the file");
    }
    new DicomParser(bytes, at + 12, ByteOrder.LITTLE_ENDIAN).parse(end, true, meta);
    return end;
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

  /** Returns the size of one decoded frame in bytes. */
  long frameBytes() {
    return (long) rows() * columns() * (bitsAllocated() / 8);
  }

  /** Returns the number of frames, 1 if the file does not name it. */
  int frameCount() throws VolumeFormatException {
    String text = attributes.text(DicomTag.FRAMES);
    int count = text.isEmpty() ? 1 : NumberParser.positiveInt(text);
    if (count < 1) {
      throw refusal("the number of frames is '" + text + "'", "export the file again");
    }
    return count;
  }

  /**
   * Checks that the pixels are grey, can be decoded, and are complete.
   *
   * @throws VolumeFormatException if they are not
   */
  void check() throws VolumeFormatException {
    if (!hasPixels()) {
      throw refusal("the file has no image", "give a file or folder of an image series");
    }
    if (syntax.coding() == TransferSyntax.Coding.UNREADABLE) {
      throw refusal(
          "the image is compressed as " + syntax.name() + ", which cannot be read", CONVERT);
    }
    if (attributes.number(DicomTag.SAMPLES, 1) != 1) {
      throw refusal("the pixels are colours, not grey values", "give a grey series");
    }
    if (attributes.text(DicomTag.MODALITY).equals("RTDOSE")) {
      throw refusal("the file is a dose grid (RTDOSE), not a scan", "give the scan of the plan");
    }
    if (bitsAllocated() == 1) {
      throw refusal(
          "the file is a DICOM segmentation of one bit a pixel, which cannot be read",
          "save it as a label volume (NRRD or NIfTI), for example with 3D Slicer");
    }
    boolean bitsMakeSense =
        bitsStored() >= 1 && highBit() >= bitsStored() - 1 && highBit() < bitsAllocated();
    if ((bitsAllocated() != 8 && bitsAllocated() != 16 && bitsAllocated() != 32)
        || !bitsMakeSense) {
      throw refusal(
          "the pixels use "
              + bitsStored()
              + " of "
              + bitsAllocated()
              + " bits, of which the highest is bit "
              + highBit(),
          CONVERT);
    }
    if (rows() < 1 || columns() < 1) {
      throw refusal("the size is " + columns() + "x" + rows(), "export the file again");
    }
    checkPixelDataItems();
  }

  private void checkPixelDataItems() throws VolumeFormatException {
    boolean plain = syntax.coding() == TransferSyntax.Coding.PLAIN;
    if (plain == encapsulated) {
      throw refusal(
          "the pixels are not encoded as the transfer syntax " + syntax.name() + " requires",
          CONVERT);
    }
    double needed = (double) frameBytes() * frameCount();
    if (plain && pixelDataItems.get(0).length() < needed) {
      throw InputFiles.truncatedFile(file, needed, (double) pixelDataItems.get(0).length(), "");
    }
    requireInflatable(needed);
    if (!plain && pixelDataItems.size() < frameCount()) {
      throw refusal(
          "the header promises "
              + frameCount()
              + " frames but the file has "
              + pixelDataItems.size()
              + " fragments",
          CONVERT);
    }
    if (!plain && frameCount() > 1 && pixelDataItems.size() != frameCount()) {
      throw refusal("a frame is split into several fragments", CONVERT);
    }
  }

  /** Refuses more pixels than the compressed bytes can hold. */
  private void requireInflatable(double needed) throws VolumeFormatException {
    double stored = 0;
    for (PixelDataItem piece : pixelDataItems) {
      stored += piece.length();
    }
    double most =
        switch (syntax.coding()) {
          case RLE -> 64; // 128 bytes of 2
          case JPEG_LOSSLESS -> 8.0 * bitsAllocated() / 8; // at least a bit for each pixel
          case JPEG_2000 -> 20_000; // a uniform image of 2000x2000 takes about 400 bytes
          default -> Double.POSITIVE_INFINITY;
        };
    if (needed > stored * most) {
      throw InputFiles.truncatedFile(file, needed, stored, "compressed");
    }
  }

  /** Returns an exception that names this file. */
  VolumeFormatException refusal(String what, String remedy) {
    return new VolumeFormatException(what, file, remedy);
  }
}
