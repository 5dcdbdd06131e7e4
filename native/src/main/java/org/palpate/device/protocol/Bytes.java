package org.palpate.device.protocol;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;

/** Bytes that hold little-endian numbers. Immutable. */
public final class Bytes {
  private final byte[] bytes;
  private final ByteBuffer littleEndian;

  private Bytes(byte[] bytes) {
    this.bytes = bytes;
    littleEndian = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
  }

  /** Returns bytes that hold a copy of an array. */
  public static Bytes of(byte... bytes) {
    return new Bytes(bytes.clone());
  }

  /** Returns a copy as an array. */
  public byte[] toArray() {
    return bytes.clone();
  }

  /** Returns the number of bytes. */
  public int length() {
    return bytes.length;
  }

  boolean startsAt(int at, byte... expected) {
    return bytes.length >= at + expected.length
        && Arrays.equals(bytes, at, at + expected.length, expected, 0, expected.length);
  }

  int unsigned8(int at) {
    return Byte.toUnsignedInt(bytes[at]);
  }

  int unsigned16(int at) {
    return Short.toUnsignedInt(littleEndian.getShort(at));
  }

  int signed16(int at) {
    return littleEndian.getShort(at);
  }

  int signed32(int at) {
    return littleEndian.getInt(at);
  }
}
