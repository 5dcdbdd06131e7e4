package org.palpate.io.nifti;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;

/** Builds NIfTI files field by field, in both versions and byte orders. */
final class NiftiFile {
  private final boolean second;
  private final ByteBuffer header;

  private NiftiFile(boolean second, ByteOrder order) {
    this.second = second;
    header = ByteBuffer.allocate(second ? 544 : 352).order(order);
    header.putInt(0, second ? 540 : 348);
    magic(second ? "n+2\0\r\n\032\n" : "n+1\0");
    dim(3, 1, 1, 1);
    pixdim(1, 1, 1, 1);
    offset(header.capacity());
    type(2);
  }

  static NiftiFile first() {
    return new NiftiFile(false, ByteOrder.LITTLE_ENDIAN);
  }

  static NiftiFile second() {
    return new NiftiFile(true, ByteOrder.LITTLE_ENDIAN);
  }

  static NiftiFile of(boolean second, ByteOrder order) {
    return new NiftiFile(second, order);
  }

  NiftiFile magic(String magic) {
    header.put(second ? 4 : 344, magic.getBytes(StandardCharsets.ISO_8859_1));
    return this;
  }

  /** Sets the number of axes and the sizes. */
  NiftiFile dim(long... dim) {
    for (int n = 0; n < dim.length; n++) {
      if (second) {
        header.putLong(16 + 8 * n, dim[n]);
      } else {
        header.putShort(40 + 2 * n, (short) dim[n]);
      }
    }
    return this;
  }

  /** Sets the handedness and the spacings. */
  NiftiFile pixdim(double... pixdim) {
    return reals(76, 104, pixdim);
  }

  private NiftiFile reals(int first, int secondOffset, double... values) {
    for (int n = 0; n < values.length; n++) {
      if (second) {
        header.putDouble(secondOffset + 8 * n, values[n]);
      } else {
        header.putFloat(first + 4 * n, (float) values[n]);
      }
    }
    return this;
  }

  NiftiFile type(int code) {
    header.putShort(second ? 12 : 70, (short) code);
    return this;
  }

  NiftiFile offset(double bytes) {
    if (second) {
      header.putLong(168, (long) bytes);
    } else {
      header.putFloat(108, (float) bytes);
    }
    return this;
  }

  NiftiFile scaling(double slope, double intercept) {
    return reals(112, 176, slope, intercept);
  }

  NiftiFile intent(int code) {
    if (second) {
      header.putInt(504, code);
    } else {
      header.putShort(68, (short) code);
    }
    return this;
  }

  NiftiFile unit(int code) {
    if (second) {
      header.putInt(500, code);
    } else {
      header.put(123, (byte) code);
    }
    return this;
  }

  /** Sets the quaternion b, c, d and the offset x, y, z. */
  NiftiFile qform(int code, double... values) {
    putCode(252, 344, code);
    return reals(256, 352, values);
  }

  /** Sets the rows of the matrix. */
  NiftiFile sform(int code, double... rows) {
    putCode(254, 348, code);
    return reals(280, 400, rows);
  }

  private void putCode(int first, int secondOffset, int code) {
    if (second) {
      header.putInt(secondOffset, code);
    } else {
      header.putShort(first, (short) code);
    }
  }

  /** Writes the header and some data. */
  Path write(Path file, byte[] data) throws IOException {
    byte[] all = Arrays.copyOf(header.array(), header.capacity() + data.length);
    System.arraycopy(data, 0, all, header.capacity(), data.length);
    return Files.write(file, all);
  }

  /** Writes the header alone, as the first file of a pair. */
  Path writePair(Path file) throws IOException {
    return Files.write(file, Arrays.copyOf(header.array(), second ? 540 : 348));
  }
}
