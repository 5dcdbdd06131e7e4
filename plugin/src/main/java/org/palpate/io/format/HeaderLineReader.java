package org.palpate.io.format;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Arrays;
import org.palpate.io.volume.VolumeFormatException;

/** Reads the text lines at the start of a file, and limits their length. */
public final class HeaderLineReader {
  private static final int MAX_LINE_BYTES = 1 << 20;
  private static final int MAX_HEADER_BYTES = 1 << 24;

  private final InputStream in;
  private final Path file;
  private byte[] line = new byte[256];
  private long bytesRead;

  /** Creates a reader of lines; messages name the file. */
  public HeaderLineReader(InputStream in, Path file) {
    this.in = in;
    this.file = file;
  }

  /** Returns the next line without its end, or null after the last line. */
  public String next() throws IOException {
    int length = 0;
    int c = in.read();
    if (c < 0) {
      return null;
    }
    for (; c >= 0 && c != '\n'; c = in.read()) {
      if (length == MAX_LINE_BYTES || bytesRead + length > MAX_HEADER_BYTES) {
        throw new VolumeFormatException(
            "a line of the header has no end",
            file,
            "export the file again; its header is damaged");
      }
      if (length == line.length) {
        line = Arrays.copyOf(line, 2 * length);
      }
      line[length++] = (byte) c;
    }
    bytesRead += length + (c < 0 ? 0 : 1);
    int end = length > 0 && line[length - 1] == '\r' ? length - 1 : length;
    return new String(line, 0, end, StandardCharsets.UTF_8);
  }

  /** Returns the number of bytes read, which is the offset of whatever follows the lines. */
  public long bytesRead() {
    return bytesRead;
  }
}
