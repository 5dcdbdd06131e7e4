package org.palpate.io.dicom;

import java.io.ByteArrayInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import org.palpate.io.codec.PackBitsInputStream;
import org.palpate.io.dicom.DicomParser.PixelDataItem;
import org.palpate.io.format.Scaling;
import org.palpate.io.volume.VoxelSlice;

/** Decodes frames of DICOM files into slices. */
final class DicomPixelDecoder {
  private int[] stored = new int[0];

  /** Fills a slice with the values of a frame whose file passed {@link DicomFile#check}. */
  void decode(DicomFrame frame, VoxelSlice dest) throws IOException {
    DicomFile dicom = frame.dicom();
    int count = dest.count();
    if (stored.length < count) {
      stored = new int[count];
    }
    switch (dicom.syntax().coding()) {
      case PLAIN ->
          unpackStoredValues(plainBytes(frame), dicom.order(), dicom.bitsAllocated(), count);
      case RLE ->
          unpackStoredValues(
              decodeRunLengths(frame), ByteOrder.BIG_ENDIAN, dicom.bitsAllocated(), count);
      default -> DicomJpegDecoder.decode(dicom, fragmentBytes(frame), stored, count);
    }
    scale(dicom, frame.scaling(), dest);
  }

  private static byte[] plainBytes(DicomFrame frame) throws IOException {
    DicomFile dicom = frame.dicom();
    int bytes = Math.toIntExact(dicom.frameBytes());
    long place = dicom.pixelDataItems().get(0).place() + frame.index() * dicom.frameBytes();
    try (DicomBytes source =
        dicom.deflatedFrom() < 0
            ? DicomBytes.open(dicom.file())
            : DicomBytes.inflated(dicom.file(), dicom.deflatedFrom())) {
      return copy(source.at(place, bytes, dicom.order()));
    }
  }

  /**
   * Returns the compressed bytes of a frame: its fragment, or all fragments if there is one frame.
   */
  private static byte[] fragmentBytes(DicomFrame frame) throws IOException {
    DicomFile dicom = frame.dicom();
    boolean all = dicom.frameCount() == 1;
    long length = 0;
    for (int n = 0; n < dicom.pixelDataItems().size(); n++) {
      length += all || n == frame.index() ? dicom.pixelDataItems().get(n).length() : 0;
    }
    ByteBuffer bytes = ByteBuffer.allocate(Math.toIntExact(length));
    try (DicomBytes source = DicomBytes.open(dicom.file())) {
      for (int n = 0; n < dicom.pixelDataItems().size(); n++) {
        if (all || n == frame.index()) {
          PixelDataItem piece = dicom.pixelDataItems().get(n);
          bytes.put(source.at(piece.place(), (int) piece.length(), dicom.order()));
        }
      }
    }
    return bytes.array();
  }

  private static byte[] copy(ByteBuffer buffer) {
    byte[] bytes = new byte[buffer.remaining()];
    buffer.get(bytes);
    return bytes;
  }

  /**
   * Decodes the RLE of DICOM: a PackBits segment for each byte of a pixel, the highest byte first.
   *
   * <p>Source: DICOM PS3.5 annex G.
   *
   * @return pixels, big-endian
   */
  private static byte[] decodeRunLengths(DicomFrame frame) throws IOException {
    DicomFile dicom = frame.dicom();
    byte[] bytes = fragmentBytes(frame);
    if (bytes.length < 64) {
      throw new EOFException("an RLE frame is shorter than its header");
    }
    ByteBuffer head = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
    int planes = dicom.bitsAllocated() / 8;
    if (head.getInt(0) != planes) {
      throw new IOException("an RLE frame has " + head.getInt(0) + " segments, not " + planes);
    }
    int pixels = dicom.rows() * dicom.columns();
    byte[] result = new byte[Math.multiplyExact(pixels, planes)];
    byte[] plane = new byte[pixels];
    for (int n = 0; n < planes; n++) {
      int from = head.getInt(4 + 4 * n);
      if (from < 64 || from > bytes.length) {
        throw new EOFException("an RLE segment is outside its frame");
      }
      PackBitsInputStream in =
          new PackBitsInputStream(new ByteArrayInputStream(bytes, from, bytes.length - from));
      if (in.readNBytes(plane, 0, pixels) < pixels) {
        throw new EOFException("an RLE segment is incomplete");
      }
      for (int p = 0; p < pixels; p++) {
        result[p * planes + n] = plane[p];
      }
    }
    return result;
  }

  private void unpackStoredValues(byte[] bytes, ByteOrder order, int bits, int count) {
    ByteBuffer buffer = ByteBuffer.wrap(bytes).order(order);
    switch (bits) {
      case 8 -> {
        for (int n = 0; n < count; n++) {
          stored[n] = bytes[n] & 0xff;
        }
      }
      case 16 -> {
        for (int n = 0; n < count; n++) {
          stored[n] = buffer.getShort(2 * n) & 0xffff;
        }
      }
      default -> buffer.asIntBuffer().get(0, stored, 0, count);
    }
  }

  /** Extracts the stored bits with their sign, and scales them. */
  private void scale(DicomFile dicom, Scaling scaling, VoxelSlice dest) {
    int up = 31 - dicom.highBit();
    int down = 32 - dicom.bitsStored();
    boolean signed = dicom.isSigned();
    for (int n = 0; n < dest.count(); n++) {
      int high = stored[n] << up;
      long value = signed ? high >> down : (high >>> down) & 0xffffffffL;
      if (dest.isInteger()) {
        dest.integers()[n] = (int) (value * (long) scaling.slope() + (long) scaling.intercept());
      } else {
        dest.doubles()[n] = scaling.apply((double) value);
      }
    }
  }
}
