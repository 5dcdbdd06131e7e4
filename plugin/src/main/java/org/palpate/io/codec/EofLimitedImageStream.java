package org.palpate.io.codec;

import java.io.IOException;
import javax.imageio.stream.ImageInputStreamImpl;

/**
 * Feeds bytes to an image library and limits how often it may read past the end. JJ2000 takes the
 * -1 at the end for bits of 1; in damaged data it can wait for a 0 bit for ever.
 */
public final class EofLimitedImageStream extends ImageInputStreamImpl {
  /** A limit that valid data stay below: the library reads past the end once for each packet. */
  private static final int MAX_END_READS = 1 << 20;

  private final byte[] bytes;
  private int ends;

  /** Creates a stream of the bytes. */
  public EofLimitedImageStream(byte[] bytes) {
    this.bytes = bytes;
  }

  @Override
  public int read() throws IOException {
    bitOffset = 0;
    if (streamPos >= bytes.length) {
      return end();
    }
    return bytes[(int) streamPos++] & 0xff;
  }

  @Override
  public int read(byte[] dest, int from, int count) throws IOException {
    bitOffset = 0;
    if (streamPos >= bytes.length) {
      return end();
    }
    int got = (int) Math.min(count, bytes.length - streamPos);
    System.arraycopy(bytes, (int) streamPos, dest, from, got);
    streamPos += got;
    return got;
  }

  /**
   * Returns -1, or throws unchecked after too many reads; the library takes a checked exception as
   * one more end.
   */
  private int end() {
    if (++ends > MAX_END_READS) {
      throw new IllegalStateException("too many reads past the end");
    }
    return -1;
  }
}
