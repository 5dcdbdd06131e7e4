package org.palpate.igtl;

import java.nio.ByteBuffer;

/**
 * A message that was received and whose checksum was right.
 *
 * @param header the header
 * @param content the content, without an extended header and without metadata
 */
record Message(MessageHeader header, ByteBuffer content) {
  private static final int EXTENDED_HEADER_BYTES = 12;

  /**
   * Takes the content out of a body.
   *
   * @throws LinkProtocolException if the body is shorter than it says
   */
  static Message of(MessageHeader header, byte[] body) throws LinkProtocolException {
    if (header.version() == 1) {
      return new Message(header, ByteBuffer.wrap(body).asReadOnlyBuffer());
    }
    if (body.length < EXTENDED_HEADER_BYTES) {
      throw tooShort(header, body.length);
    }
    ByteBuffer in = ByteBuffer.wrap(body);
    int extendedHeader = in.getShort() & 0xffff;
    long metadata = (in.getShort() & 0xffff) + (in.getInt() & 0xffff_ffffL);
    if (extendedHeader < EXTENDED_HEADER_BYTES || extendedHeader + metadata > body.length) {
      throw tooShort(header, body.length);
    }
    int length = (int) (body.length - extendedHeader - metadata);
    ByteBuffer content = ByteBuffer.wrap(body, extendedHeader, length).slice();
    return new Message(header, content.asReadOnlyBuffer());
  }

  private static LinkProtocolException tooShort(MessageHeader header, int bytes) {
    return new LinkProtocolException(
        "the body of a " + header.type() + " message has " + bytes + " bytes, fewer than it says");
  }
}
