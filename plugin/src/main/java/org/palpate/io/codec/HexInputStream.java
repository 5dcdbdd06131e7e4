package org.palpate.io.codec;

import java.io.IOException;
import java.io.InputStream;

/** Decodes bytes written as two hexadecimal digits each, and skips the white space between them. */
public final class HexInputStream extends InputStream {
  private final InputStream text;

  /** Creates a decoder of the text. */
  public HexInputStream(InputStream text) {
    this.text = text;
  }

  @Override
  public int read() throws IOException {
    int high = digit();
    if (high < 0) {
      return -1;
    }
    int low = digit();
    if (low < 0) {
      throw new IOException("the last byte has a single hexadecimal digit");
    }
    return high << 4 | low;
  }

  @Override
  public int read(byte[] dest, int from, int count) throws IOException {
    int got = 0;
    for (int c = 0; got < count && (c = read()) >= 0; got++) {
      dest[from + got] = (byte) c;
    }
    return got == 0 && count > 0 ? -1 : got;
  }

  @Override
  public void close() throws IOException {
    text.close();
  }

  private int digit() throws IOException {
    int c = text.read();
    while (c == ' ' || c == '\n' || c == '\r' || c == '\t') {
      c = text.read();
    }
    if (c < 0) {
      return -1;
    }
    int digit = Character.digit(c, 16);
    if (digit < 0) {
      throw new IOException("a character is no hexadecimal digit");
    }
    return digit;
  }
}
