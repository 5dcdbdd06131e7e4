package org.palpate.io.tiff;

import java.io.BufferedInputStream;
import java.io.ByteArrayInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.FileChannel;
import java.util.zip.InflaterInputStream;
import org.apache.commons.compress.compressors.zstandard.ZstdCompressorInputStream;
import org.palpate.io.codec.LzwInputStream;
import org.palpate.io.codec.PackBitsInputStream;
import org.palpate.io.format.BinarySampleStream;
import org.palpate.io.format.Luminance;
import org.palpate.io.format.SampleStream;
import org.palpate.io.format.Scaling;
import org.palpate.io.volume.VoxelSlice;
import org.palpate.io.volume.VoxelType;

/** Decodes pages of one TIFF file into slices, strip by strip or tile by tile. */
final class TiffDecoder {
  private final FileChannel channel;
  private final ByteOrder order;
  private final Scaling scaling;
  private byte[] pageBytes = new byte[0];
  private byte[] tileBytes = new byte[0];

  TiffDecoder(FileChannel channel, ByteOrder order, Scaling scaling) {
    this.channel = channel;
    this.order = order;
    this.scaling = scaling;
  }

  /** Fills a slice with a page that passed {@link TiffPage#check}. */
  void decode(TiffPage page, VoxelSlice dest) throws IOException {
    int planeBytes = Math.multiplyExact(dest.count(), bytesOfPixel(page));
    pageBytes = atLeast(pageBytes, Math.multiplyExact(planeBytes, page.pixels().planes()));
    int across = page.tilesAcross();
    int perPlane = across * page.tilesDown();
    for (int n = 0; n < perPlane * page.pixels().planes(); n++) {
      int inPlane = n % perPlane;
      decodeTile(
          page,
          n,
          (inPlane % across) * page.tileWidth(),
          (inPlane / across) * page.tileHeight(),
          n / perPlane * planeBytes);
    }
    if (page.pixels().samples() == 1) {
      readGrey(page, dest);
    } else {
      readFirstOrLuminance(page, planeBytes, dest);
    }
    page.greyPalette().ifPresent(palette -> lookUp(palette, dest.integers()));
  }

  private static int bytesOfPixel(TiffPage page) {
    return page.pixels().type().bytes() * page.pixels().interleaved();
  }

  private void readGrey(TiffPage page, VoxelSlice dest) throws IOException {
    VoxelType type = page.pixels().type();
    InputStream bytes = new ByteArrayInputStream(pageBytes, 0, dest.count() * type.bytes());
    try (SampleStream samples = new BinarySampleStream(bytes, type, order, scaling)) {
      samples.read(dest, 0, dest.count());
    }
  }

  /** Reads the luminance of a colour, or the first sample of grey with transparency. */
  private void readFirstOrLuminance(TiffPage page, int planeBytes, VoxelSlice dest)
      throws IOException {
    VoxelType type = page.pixels().type();
    int pixelStep = bytesOfPixel(page);
    int sampleStep = page.pixels().isPlanar() ? planeBytes : type.bytes();
    byte[] grey = new byte[Math.multiplyExact(dest.count(), type.bytes())];
    ByteBuffer in = ByteBuffer.wrap(pageBytes).order(order);
    ByteBuffer out = ByteBuffer.wrap(grey).order(order);
    for (int n = 0; n < dest.count(); n++) {
      int at = n * pixelStep;
      if (!page.pixels().isColour()) {
        System.arraycopy(pageBytes, at, grey, n * type.bytes(), type.bytes());
      } else if (type.bytes() == 1) {
        int red = pageBytes[at] & 0xff;
        int green = pageBytes[at + sampleStep] & 0xff;
        grey[n] = (byte) Luminance.of(red, green, pageBytes[at + 2 * sampleStep] & 0xff);
      } else {
        int red = in.getShort(at) & 0xffff;
        int green = in.getShort(at + sampleStep) & 0xffff;
        int blue = in.getShort(at + 2 * sampleStep) & 0xffff;
        out.putShort(2 * n, (short) Luminance.of(red, green, blue));
      }
    }
    pageBytes = grey;
    readGrey(page, dest);
  }

  private static void lookUp(int[] palette, int[] values) {
    for (int n = 0; n < values.length; n++) {
      values[n] = palette[values[n]];
    }
  }

  /**
   * Decodes a strip or tile into the page.
   *
   * @param x where it begins, pixels
   * @param y where it begins, pixels
   * @param plane where its plane begins in the page, bytes
   */
  private void decodeTile(TiffPage page, int n, int x, int y, int plane) throws IOException {
    TiffPixels pixels = page.pixels();
    int rows = page.isTiled() ? page.tileHeight() : Math.min(page.tileHeight(), page.height() - y);
    int tileRow = Math.toIntExact(pixels.rowBytes(page.tileWidth()));
    tileBytes = atLeast(tileBytes, Math.multiplyExact(tileRow, rows));
    byte[] stored = bytes((long) page.offsets()[n], (int) page.byteCounts()[n]);
    if (pixels.isLowestBitFirst()) {
      RowUnpacker.reverseBits(stored);
    }
    try (InputStream in = decompressed(stored, page.compression())) {
      if (in.readNBytes(tileBytes, 0, tileRow * rows) < tileRow * rows) {
        throw new EOFException("a strip or tile is incomplete");
      }
    }
    TiffPredictor predictor = new TiffPredictor(page.predictor(), order);
    int kept = Math.min(page.tileWidth(), page.width() - x) * pixels.interleaved();
    int size = pixels.type().bytes();
    for (int row = 0; row < Math.min(rows, page.height() - y); row++) {
      predictor.undo(
          tileBytes,
          row * tileRow,
          page.tileWidth() * pixels.interleaved(),
          pixels.bits() / 8,
          pixels.interleaved());
      int at = plane + ((y + row) * page.width() + x) * size * pixels.interleaved();
      if (pixels.isPlain()) {
        System.arraycopy(tileBytes, row * tileRow, pageBytes, at, kept * size);
      } else {
        RowUnpacker.unpack(pixels, tileBytes, row * tileRow, kept, order, pageBytes, at);
      }
    }
  }

  private static InputStream decompressed(byte[] stored, int compression) throws IOException {
    InputStream in = new ByteArrayInputStream(stored);
    return switch (compression) {
      case 5 -> new LzwInputStream(in);
      case 8, 32946 -> new BufferedInputStream(new InflaterInputStream(in));
      case 32773 -> new PackBitsInputStream(in);
      case TiffPage.ZSTD -> new ZstdCompressorInputStream(in);
      default -> in;
    };
  }

  private byte[] bytes(long at, int count) throws IOException {
    ByteBuffer buffer = ByteBuffer.allocate(count);
    while (buffer.hasRemaining()) {
      if (channel.read(buffer, at + buffer.position()) < 0) {
        throw new EOFException("the file is too short");
      }
    }
    return buffer.array();
  }

  private static byte[] atLeast(byte[] bytes, int count) {
    return bytes.length >= count ? bytes : new byte[count];
  }
}
