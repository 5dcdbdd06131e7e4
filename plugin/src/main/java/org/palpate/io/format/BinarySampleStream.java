package org.palpate.io.format;

import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.ShortBuffer;
import org.palpate.io.volume.VoxelSlice;
import org.palpate.io.volume.VoxelType;

/** Reads samples of a fixed number of bytes from a stream, which it closes. */
public final class BinarySampleStream implements SampleStream {
  private static final int BUFFER_BYTES = 1 << 16;

  private final InputStream bytes;
  private final VoxelType type;
  private final Scaling scaling;
  private final byte[] buffer = new byte[BUFFER_BYTES];
  private final ByteBuffer view;
  private final ShortBuffer shortView;
  private final short[] shorts;
  private int next;
  private int limit;

  /** Creates a stream of scaled samples. */
  public BinarySampleStream(InputStream bytes, VoxelType type, ByteOrder order, Scaling scaling) {
    this.bytes = bytes;
    this.type = type;
    this.scaling = scaling;
    view = ByteBuffer.wrap(buffer).order(order);
    shortView = view.asShortBuffer();
    shorts = type.bytes() == 2 ? new short[BUFFER_BYTES / 2] : new short[0];
  }

  @Override
  public void read(VoxelSlice dest, int at, int count) throws IOException {
    for (int done = 0; done < count; ) {
      int part = Math.min(count - done, available());
      if (dest.isInteger()) {
        decodeIntegers(dest.integers(), at + done, part);
      } else {
        decodeDoubles(dest.doubles(), at + done, part);
      }
      next += part;
      done += part;
    }
  }

  @Override
  public void skip(long count) throws IOException {
    int buffered = (int) Math.min(count, limit - next);
    next += buffered;
    try {
      bytes.skipNBytes((count - buffered) * type.bytes());
    } catch (EOFException e) {
      throw new EOFException("the data end among skipped samples");
    }
  }

  @Override
  public void close() throws IOException {
    bytes.close();
  }

  private int available() throws IOException {
    if (next == limit) {
      limit = bytes.readNBytes(buffer, 0, BUFFER_BYTES) / type.bytes();
      next = 0;
      if (limit == 0) {
        throw new EOFException("the data end");
      }
    }
    return limit - next;
  }

  private void decodeIntegers(int[] dest, int at, int count) {
    switch (type) {
      case INT8 -> widenBytes(dest, at, count, -1);
      case UINT8 -> widenBytes(dest, at, count, 0xff);
      case INT16 -> widenShorts(dest, at, count, -1);
      case UINT16 -> widenShorts(dest, at, count, 0xffff);
      default -> view.asIntBuffer().get(next, dest, at, count);
    }
    if (!scaling.isNone()) {
      rescaleIntegers(dest, at, count);
    }
  }

  private void widenBytes(int[] dest, int at, int count, int mask) {
    for (int n = 0; n < count; n++) {
      dest[at + n] = buffer[next + n] & mask;
    }
  }

  private void widenShorts(int[] dest, int at, int count, int mask) {
    shortView.get(next, shorts, 0, count);
    for (int n = 0; n < count; n++) {
      dest[at + n] = shorts[n] & mask;
    }
  }

  private void rescaleIntegers(int[] dest, int at, int count) {
    int slope = (int) scaling.slope();
    int intercept = (int) scaling.intercept();
    for (int n = at; n < at + count; n++) {
      dest[n] = dest[n] * slope + intercept;
    }
  }

  private void decodeDoubles(double[] dest, int at, int count) {
    for (int n = 0; n < count; n++) {
      dest[at + n] = sample(next + n);
    }
    if (!scaling.isNone()) {
      for (int n = at; n < at + count; n++) {
        dest[n] = scaling.apply(dest[n]);
      }
    }
  }

  private double sample(int index) {
    int at = index * type.bytes();
    return switch (type) {
      case INT8 -> buffer[at];
      case UINT8 -> buffer[at] & 0xff;
      case INT16 -> view.getShort(at);
      case UINT16 -> view.getShort(at) & 0xffff;
      case INT32 -> view.getInt(at);
      case UINT32 -> view.getInt(at) & 0xffffffffL;
      case INT64 -> view.getLong(at);
      case UINT64 -> unsigned(view.getLong(at));
      case FLOAT32 -> view.getFloat(at);
      case FLOAT64 -> view.getDouble(at);
    };
  }

  private static double unsigned(long value) {
    // keeping the lowest bit in the shifted value makes the rounding correct
    return value >= 0 ? value : ((value >>> 1) | (value & 1)) * 2.0;
  }
}
