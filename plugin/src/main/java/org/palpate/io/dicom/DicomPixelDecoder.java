package org.palpate.io.dicom;

import java.io.ByteArrayInputStream;
import java.io.Closeable;
import java.io.EOFException;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Path;
import org.palpate.io.codec.PackBitsInputStream;
import org.palpate.io.dicom.DicomParser.PixelDataItem;
import org.palpate.io.format.Scaling;
import org.palpate.io.volume.VoxelSlice;

/**
 * Decodes frames of DICOM files into slices. Keeps the file of the last frame open, so that a
 * deflated file is inflated once.
 */
final class DicomPixelDecoder implements Closeable {
  private int[] stored = new int[0];
  private Path openFile;
  private DicomBytes source;

  /** Fills a slice with the values of a frame whose file passed {@link DicomImageChecks#check}. */
  void decode(DicomFrame frame, VoxelSlice dest) throws IOException {
    int[] numbers = storedValues(frame.dicom(), frame.index(), dest.count());
    scale(frame.dicom(), frame.scaling(), numbers, dest);
  }

  /** Returns the stored numbers of a frame, valid until the next call. */
  int[] storedValues(DicomFile dicom, int index, int count) throws IOException {
    if (stored.length < count) {
      stored = new int[count];
    }
    switch (dicom.syntax().coding()) {
      case PLAIN -> {
        boolean planar = dicom.attributes().number(DicomTag.PLANAR, 0) == 1;
        unpack(dicom, plainBytes(dicom, index), dicom.order(), planar, count);
      }
      case RLE -> unpack(dicom, decodeRunLengths(dicom, index), ByteOrder.BIG_ENDIAN, false, count);
      default -> DicomJpegDecoder.decode(dicom, fragmentBytes(dicom, index), stored, count);
    }
    return stored;
  }

  private void unpack(DicomFile dicom, byte[] bytes, ByteOrder order, boolean planar, int count) {
    if (DicomColours.isColour(dicom)) {
      DicomColours.toLuminance(dicom, bytes, planar, count, stored);
    } else {
      unpackStoredValues(bytes, order, dicom.bitsAllocated(), count);
    }
  }

  /** Returns the bytes of a frame of native pixels, whose bits begin at a whole byte. */
  private byte[] plainBytes(DicomFile dicom, int index) throws IOException {
    int count = Math.toIntExact(dicom.frameBytes());
    long from = index * dicom.frameBytes();
    return dicom.swapped() && dicom.bitsAllocated() == 8
        ? swappedBytes(dicom, from, count)
        : nativeBytes(dicom, from, count);
  }

  /** Returns bytes that stand in words whose higher byte comes first. */
  private byte[] swappedBytes(DicomFile dicom, long from, int count) throws IOException {
    int before = (int) (from & 1);
    byte[] words = nativeBytes(dicom, from - before, before + count + ((before + count) & 1));
    byte[] bytes = new byte[count];
    for (int n = 0; n < count; n++) {
      bytes[n] = words[(n + before) ^ 1];
    }
    return bytes;
  }

  /** Returns some bytes of native pixels. */
  byte[] nativeBytes(DicomFile dicom, long from, int count) throws IOException {
    long place = dicom.pixelDataItems().get(0).place() + from;
    return copy(source(dicom).at(place, count, dicom.order()));
  }

  private DicomBytes source(DicomFile dicom) throws IOException {
    if (!dicom.file().equals(openFile)) {
      close();
      source =
          dicom.deflatedFrom() < 0
              ? DicomBytes.open(dicom.file())
              : DicomBytes.inflated(dicom.file(), dicom.deflatedFrom());
      openFile = dicom.file();
    }
    return source;
  }

  @Override
  public void close() throws IOException {
    openFile = null;
    if (source != null) {
      source.close();
      source = null;
    }
  }

  /**
   * Returns the compressed bytes of a frame: its fragment, or all fragments if there is one frame.
   */
  private byte[] fragmentBytes(DicomFile dicom, int index) throws IOException {
    boolean all = dicom.frameCount() == 1;
    long length = 0;
    for (int n = 0; n < dicom.pixelDataItems().size(); n++) {
      length += all || n == index ? dicom.pixelDataItems().get(n).length() : 0;
    }
    ByteBuffer bytes = ByteBuffer.allocate(Math.toIntExact(length));
    for (int n = 0; n < dicom.pixelDataItems().size(); n++) {
      if (all || n == index) {
        PixelDataItem piece = dicom.pixelDataItems().get(n);
        bytes.put(source(dicom).at(piece.place(), (int) piece.length(), dicom.order()));
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
  private byte[] decodeRunLengths(DicomFile dicom, int index) throws IOException {
    byte[] bytes = fragmentBytes(dicom, index);
    if (bytes.length < 64) {
      throw new EOFException("an RLE frame is shorter than its header");
    }
    ByteBuffer head = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
    int planes = dicom.samples() * dicom.bitsAllocated() / 8;
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
  private static void scale(DicomFile dicom, Scaling scaling, int[] stored, VoxelSlice dest) {
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
