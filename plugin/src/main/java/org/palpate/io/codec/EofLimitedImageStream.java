package org.palpate.io.codec;

import java.io.IOException;
import javax.imageio.stream.ImageInputStreamImpl;

/**
 * Bytes for an image library that may be told of their end only so often. To JJ2000 the -1 there is
 * all ones, and where damaged data make it wait for a zero it would wait for ever.
 */
public final class EofLimitedImageStream extends ImageInputStreamImpl {
  /** It asks for the end once a packet, too, to know the length. */
  private static final int MAX_END_READS = 1 << 20;

  private final byte[] bytes;
  private int ends;

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

  /** An unchecked exception, for the library takes a checked one as one more end. */
  private int end() {
    if (++ends > MAX_END_READS) {
      throw new IllegalStateException("read on after the end");
    }
    return -1;
  }
}
