package org.palpate.igtl;

import java.io.ByteArrayOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;

/**
 * Reads messages from a client.
 *
 * <p>Sizes are bounded before memory is allocated, and memory grows only with bytes that have
 * arrived. One thread.
 */
final class MessageReader {
  private static final int CHUNK_BYTES = 1 << 16;

  /** The largest body of a message that is not an image. */
  private static final long MAX_OTHER_BYTES = 1 << 20;

  private final InputStream in;
  private final long maxImageBytes;

  /**
   * Creates a reader.
   *
   * @param maxImageBytes the largest body of an image, bytes
   */
  MessageReader(InputStream in, long maxImageBytes) {
    this.in = in;
    this.maxImageBytes = Math.min(maxImageBytes, Integer.MAX_VALUE - CHUNK_BYTES);
  }

  /**
   * Reads the next message and checks its checksum.
   *
   * @return the message, or null if the stream ended between two messages
   * @throws LinkProtocolException if the message is too large, cut off or damaged
   */
  Message read() throws IOException {
    byte[] first = in.readNBytes(MessageHeader.BYTES);
    if (first.length == 0) {
      return null;
    }
    if (first.length < MessageHeader.BYTES) {
      throw new EOFException("the connection ended inside a header");
    }
    MessageHeader header = MessageHeader.parse(first);
    byte[] body = readBody(header);
    long crc = Crc64.of(body);
    if (crc != header.crc()) {
      throw new LinkProtocolException(
          "the checksum of a " + header.type() + " message is wrong; send it again");
    }
    return Message.of(header, body);
  }

  private byte[] readBody(MessageHeader header) throws IOException {
    long limit = header.type().equals(ReceivedImage.TYPE) ? maxImageBytes : MAX_OTHER_BYTES;
    if (header.bodySize() > limit) {
      throw new LinkProtocolException(
          "a "
              + header.type()
              + " message has "
              + header.bodySize()
              + " bytes; at most "
              + limit
              + " are accepted");
    }
    int size = (int) header.bodySize();
    ByteArrayOutputStream body = new ByteArrayOutputStream(Math.min(size, CHUNK_BYTES));
    byte[] chunk = new byte[Math.min(size, CHUNK_BYTES)];
    while (body.size() < size) {
      int read = in.read(chunk, 0, Math.min(chunk.length, size - body.size()));
      if (read < 0) {
        throw new EOFException("the connection ended inside a " + header.type() + " message");
      }
      body.write(chunk, 0, read);
    }
    return body.toByteArray();
  }
}
