package org.palpate.io.codec;

import java.io.IOException;
import java.io.InputStream;

/**
 * Decodes the LZW of TIFF: codes of 9 to 12 bits, highest bit first, that widen one code early.
 *
 * <p>Source: TIFF Revision 6.0, section 13.
 */
public final class LzwInputStream extends InputStream {
  private static final int CLEAR = 256;
  private static final int END = 257;
  private static final int FIRST_FREE = 258;
  private static final int MAX_CODES = 4096;

  private final InputStream in;
  private final short[] prefix = new short[MAX_CODES];
  private final byte[] last = new byte[MAX_CODES];
  private final byte[] text = new byte[MAX_CODES];
  private int textAt = MAX_CODES;
  private int bits;
  private int bitCount;
  private int width = 9;
  private int free = FIRST_FREE;
  private int previous = -1;
  private boolean ended;

  /** Creates a decoder of the compressed bytes. */
  public LzwInputStream(InputStream in) {
    this.in = in;
    for (int n = 0; n < 256; n++) {
      last[n] = (byte) n;
    }
  }

  @Override
  public int read() throws IOException {
    while (textAt == MAX_CODES && !ended) {
      decode();
    }
    return textAt == MAX_CODES ? -1 : text[textAt++] & 0xff;
  }

  @Override
  public int read(byte[] dest, int from, int count) throws IOException {
    int got = 0;
    for (int c = 0; got < count && (c = read()) >= 0; got++) {
      dest[from + got] = (byte) c;
    }
    return got == 0 && count > 0 ? -1 : got;
  }

  private void decode() throws IOException {
    int code = code();
    if (code == END || code < 0) {
      ended = true;
    } else if (code == CLEAR) {
      width = 9;
      free = FIRST_FREE;
      previous = -1;
    } else {
      expand(code);
    }
  }

  private void expand(int code) throws IOException {
    if (code > free || (previous < 0 && code >= CLEAR) || code == END) {
      throw new IOException("LZW code " + code + " is not defined");
    }
    // the code being defined stands for the previous text followed by its own first byte
    boolean isNew = code == free;
    unroll(isNew ? previous : code);
    if (isNew) {
      repeatFirst();
    }
    if (previous >= 0 && free < MAX_CODES) {
      prefix[free] = (short) previous;
      last[free] = text[textAt];
      free++;
      if (free == (1 << width) - 1 && width < 12) {
        width++;
      }
    }
    previous = code;
  }

  private void unroll(int code) {
    int rest = code;
    while (rest >= FIRST_FREE) {
      text[--textAt] = last[rest];
      rest = prefix[rest];
    }
    text[--textAt] = (byte) rest;
  }

  private void repeatFirst() throws IOException {
    if (textAt == 0) {
      throw new IOException("an LZW code stands for too many bytes");
    }
    byte first = text[textAt];
    System.arraycopy(text, textAt, text, textAt - 1, MAX_CODES - textAt);
    textAt--;
    text[MAX_CODES - 1] = first;
  }

  private int code() throws IOException {
    while (bitCount < width) {
      int next = in.read();
      if (next < 0) {
        return -1;
      }
      bits = bits << 8 | next;
      bitCount += 8;
    }
    bitCount -= width;
    return bits >>> bitCount & (1 << width) - 1;
  }
}
