package org.palpate.igtl;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;

/**
 * The header of an OpenIGTLink message: 58 bytes, big endian.
 *
 * <pre>
 *   0   uint16    version: 1, or 2 and 3 if an extended header precedes the content
 *   2   char[12]  type, such as TRANSFORM
 *   14  char[20]  device name
 *   34  uint64    time: seconds and fractions of 2^-32 s
 *   42  uint64    size of the body, bytes
 *   50  uint64    checksum of the body, see {@link Crc64}
 * </pre>
 *
 * @param version the version of the header, from 1 to 3
 * @param type the type of the message
 * @param deviceName the name that the sender gave, ASCII
 * @param timestamp seconds in the upper and fractions in the lower 32 bits
 * @param bodySize the size of the body in bytes, not negative
 * @param crc the checksum of the body
 */
record MessageHeader(
    int version, String type, String deviceName, long timestamp, long bodySize, long crc) {
  /** The size of a header in bytes. */
  static final int BYTES = 58;

  private static final int MAX_VERSION = 3;
  private static final int TYPE_BYTES = 12;
  private static final int NAME_BYTES = 20;

  /**
   * Parses a header.
   *
   * @param bytes 58 bytes
   * @throws LinkProtocolException if these are not the bytes of a header
   */
  static MessageHeader parse(byte[] bytes) throws LinkProtocolException {
    ByteBuffer in = ByteBuffer.wrap(bytes);
    int version = in.getShort() & 0xffff;
    if (version < 1 || version > MAX_VERSION) {
      throw new LinkProtocolException("unknown header version " + version + "; 1 to 3 are known");
    }
    String type = text(in, TYPE_BYTES);
    String deviceName = text(in, NAME_BYTES);
    long timestamp = in.getLong();
    long bodySize = in.getLong();
    if (type.isEmpty() || bodySize < 0) {
      throw new LinkProtocolException("the header has no type or a body above 2^63 bytes");
    }
    return new MessageHeader(version, type, deviceName, timestamp, bodySize, in.getLong());
  }

  /** Returns printable ASCII up to the first NUL, without trailing blanks. */
  static String text(ByteBuffer in, int bytes) {
    byte[] raw = new byte[bytes];
    in.get(raw);
    int length = 0;
    while (length < bytes && raw[length] != 0) {
      length++;
    }
    String text = new String(raw, 0, length, StandardCharsets.US_ASCII);
    return text.replaceAll("[^\\x20-\\x7e]", "?").strip();
  }

  /** Appends the header to {@code out}. */
  void write(ByteBuffer out) {
    out.putShort((short) version);
    putText(out, type, TYPE_BYTES);
    putText(out, deviceName, NAME_BYTES);
    out.putLong(timestamp).putLong(bodySize).putLong(crc);
  }

  /** Appends a text, cut to its field and padded with NUL; other characters than ASCII are '?'. */
  static void putText(ByteBuffer out, String text, int bytes) {
    byte[] ascii = text.getBytes(StandardCharsets.US_ASCII);
    int length = Math.min(ascii.length, bytes);
    out.put(ascii, 0, length).put(new byte[bytes - length]);
  }
}
