package org.palpate.io.dicom;

import java.io.ByteArrayOutputStream;
import java.io.Closeable;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.util.zip.Inflater;
import java.util.zip.InflaterInputStream;
import org.palpate.io.format.InputFiles;
import org.palpate.io.format.MemoryCheck;

/**
 * Gives random access to the bytes of a DICOM file, or of a deflated data set that it inflates in
 * memory.
 */
final class DicomBytes implements Closeable {
  private static final int WINDOW_BYTES = 1 << 13;

  private final FileChannel channel; // null if the window holds everything
  private final long length;
  private ByteBuffer window;
  private long windowAt;

  private DicomBytes(FileChannel channel, long length, ByteBuffer window) {
    this.channel = channel;
    this.length = length;
    this.window = window;
  }

  /** Opens a file. */
  static DicomBytes open(Path file) throws IOException {
    FileChannel channel = FileChannel.open(file);
    return new DicomBytes(channel, channel.size(), ByteBuffer.allocate(0));
  }

  /**
   * Inflates everything from an offset on.
   *
   * @throws org.palpate.io.volume.VolumeFormatException if it does not fit in memory
   */
  static DicomBytes inflated(Path file, long from) throws IOException {
    ByteArrayOutputStream all = new ByteArrayOutputStream();
    try (InputStream in =
        new InflaterInputStream(InputFiles.open(file, from), new Inflater(true), WINDOW_BYTES)) {
      byte[] buffer = new byte[InputFiles.BUFFER_BYTES];
      for (int got = in.read(buffer); got >= 0; got = in.read(buffer)) {
        if ((all.size() & 0xfffff) < buffer.length) {
          MemoryCheck.require(3.0 * all.size(), "inflating the data set", file.toString());
        }
        all.write(buffer, 0, got);
      }
    }
    byte[] bytes = all.toByteArray();
    return new DicomBytes(null, bytes.length, ByteBuffer.wrap(bytes));
  }

  /** Returns the number of bytes. */
  long length() {
    return length;
  }

  /** Returns bytes at an offset in a byte order; the buffer is valid until the next call. */
  ByteBuffer at(long place, int count, ByteOrder order) throws IOException {
    if (place < 0 || count < 0 || place > length - count) {
      throw new EOFException("the file ends inside an attribute");
    }
    if (place < windowAt || place + count > windowAt + window.limit()) {
      fill(place, count);
    }
    return window.slice((int) (place - windowAt), count).order(order);
  }

  private void fill(long place, int count) throws IOException {
    int wanted = (int) Math.min(Math.max(count, WINDOW_BYTES), length - place);
    ByteBuffer fresh = ByteBuffer.allocate(wanted);
    while (fresh.hasRemaining()) {
      if (channel.read(fresh, place + fresh.position()) < 0) {
        throw new EOFException("the file ends inside an attribute");
      }
    }
    window = fresh.flip();
    windowAt = place;
  }

  @Override
  public void close() throws IOException {
    if (channel != null) {
      channel.close();
    }
  }
}
