package org.palpate.io.format;

import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import org.palpate.io.file.NumberParser;
import org.palpate.io.volume.VoxelSlice;
import org.palpate.io.volume.VoxelType;

/** Reads samples that are written as words of text from a stream, which it closes. */
public final class TextSampleStream implements SampleStream {
  private static final int MAX_WORD = 64;

  private final InputStream text;
  private final VoxelType type;
  private final char[] word = new char[MAX_WORD];

  /** Creates a stream of samples without scaling. */
  public TextSampleStream(InputStream text, VoxelType type) {
    this.text = text;
    this.type = type;
  }

  @Override
  public void read(VoxelSlice dest, int at, int count) throws IOException {
    for (int n = at; n < at + count; n++) {
      double value = next();
      if (dest.isInteger()) {
        dest.integers()[n] = (int) value;
      } else {
        dest.doubles()[n] = value;
      }
    }
  }

  @Override
  public void skip(long count) throws IOException {
    for (long n = 0; n < count; n++) {
      next();
    }
  }

  @Override
  public void close() throws IOException {
    text.close();
  }

  private double next() throws IOException {
    String token = token();
    double value = NumberParser.number(token);
    boolean isNan = token.equalsIgnoreCase("nan") || token.equalsIgnoreCase("-nan");
    boolean integer = value == Math.rint(value);
    boolean fits = value >= type.low() && value <= type.high();
    if (type.isInteger() ? !(integer && fits) : Double.isNaN(value) && !isNan) {
      throw new IOException("'" + token + "' is no value of type " + type.description());
    }
    return value;
  }

  private String token() throws IOException {
    int c = text.read();
    while (isGap(c)) {
      c = text.read();
    }
    int length = 0;
    for (; c >= 0 && !isGap(c); c = text.read()) {
      if (length == MAX_WORD) {
        throw new IOException("a number has more than " + MAX_WORD + " characters");
      }
      word[length++] = (char) c;
    }
    if (length == 0) {
      throw new EOFException("the values end");
    }
    return new String(word, 0, length);
  }

  private static boolean isGap(int c) {
    return c == ' ' || c == '\n' || c == '\r' || c == '\t' || c == ',';
  }
}
