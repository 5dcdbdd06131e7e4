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
import org.palpate.io.codec.LzwInputStream;
import org.palpate.io.codec.PackBitsInputStream;
import org.palpate.io.format.BinarySampleStream;
import org.palpate.io.format.SampleStream;
import org.palpate.io.format.Scaling;
import org.palpate.io.volume.VoxelSlice;

/** Decodes pages of a TIFF into slices, strip by strip or tile by tile. */
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
    int sample = page.type().bytes();
    int rowBytes = Math.multiplyExact(page.width(), sample);
    pageBytes = atLeast(pageBytes, Math.multiplyExact(rowBytes, page.height()));
    int across = (page.width() - 1) / page.tileWidth() + 1;
    int down = (page.height() - 1) / page.tileHeight() + 1;
    for (int n = 0; n < across * down; n++) {
      decodeTile(page, n, (n % across) * page.tileWidth(), (n / across) * page.tileHeight());
    }
    InputStream bytes = new ByteArrayInputStream(pageBytes, 0, rowBytes * page.height());
    try (SampleStream samples = new BinarySampleStream(bytes, page.type(), order, scaling)) {
      samples.read(dest, 0, dest.count());
    }
  }

  private void decodeTile(TiffPage page, int n, int x, int y) throws IOException {
    int sample = page.type().bytes();
    int rows = page.isTiled() ? page.tileHeight() : Math.min(page.tileHeight(), page.height() - y);
    int tileRow = page.tileWidth() * sample;
    tileBytes = atLeast(tileBytes, tileRow * rows);
    byte[] stored = bytes((long) page.offsets()[n], (int) page.byteCounts()[n]);
    try (InputStream in = decompressed(stored, page.compression())) {
      if (in.readNBytes(tileBytes, 0, tileRow * rows) < tileRow * rows) {
        throw new EOFException("a strip or tile is incomplete");
      }
    }
    int kept = Math.min(page.tileWidth(), page.width() - x) * sample;
    for (int row = 0; row < Math.min(rows, page.height() - y); row++) {
      if (page.predictor() == 2) {
        undoHorizontalPredictor(row * tileRow, page.tileWidth(), sample);
      }
      System.arraycopy(
          tileBytes, row * tileRow, pageBytes, ((y + row) * page.width() + x) * sample, kept);
    }
  }

  private static InputStream decompressed(byte[] stored, int compression) {
    InputStream in = new ByteArrayInputStream(stored);
    return switch (compression) {
      case 5 -> new LzwInputStream(in);
      case 8, 32946 -> new BufferedInputStream(new InflaterInputStream(in));
      case 32773 -> new PackBitsInputStream(in);
      default -> in;
    };
  }

  /**
   * Reverses horizontal differencing, in which a sample is stored as its difference from the left
   * one.
   */
  private void undoHorizontalPredictor(int from, int count, int sample) {
    ByteBuffer row = ByteBuffer.wrap(tileBytes).order(order);
    for (int n = 1; n < count; n++) {
      int at = from + n * sample;
      int left = at - sample;
      switch (sample) {
        case 1 -> tileBytes[at] += tileBytes[left];
        case 2 -> row.putShort(at, (short) (row.getShort(at) + row.getShort(left)));
        case 4 -> row.putInt(at, row.getInt(at) + row.getInt(left));
        default -> row.putLong(at, row.getLong(at) + row.getLong(left));
      }
    }
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
