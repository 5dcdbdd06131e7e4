package org.palpate.io.codec;

import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;

/** Decodes PackBits runs, which TIFF and the RLE of DICOM use. */
public final class PackBitsInputStream extends InputStream {
  private final InputStream in;
  private int literals;
  private int repeats;
  private int repeated;

  /** Creates a decoder of the compressed bytes. */
  public PackBitsInputStream(InputStream in) {
    this.in = in;
  }

  @Override
  public int read() throws IOException {
    while (literals == 0 && repeats == 0) {
      int control = in.read();
      if (control < 0) {
        return -1;
      }
      if (control < 128) {
        literals = control + 1;
      } else if (control > 128) {
        repeats = 257 - control;
        repeated = required();
      }
    }
    if (repeats > 0) {
      repeats--;
      return repeated;
    }
    literals--;
    return required();
  }

  @Override
  public int read(byte[] dest, int from, int count) throws IOException {
    int got = 0;
    for (int c = 0; got < count && (c = read()) >= 0; got++) {
      dest[from + got] = (byte) c;
    }
    return got == 0 && count > 0 ? -1 : got;
  }

  private int required() throws IOException {
    int c = in.read();
    if (c < 0) {
      throw new EOFException("a PackBits run is incomplete");
    }
    return c;
  }
}
