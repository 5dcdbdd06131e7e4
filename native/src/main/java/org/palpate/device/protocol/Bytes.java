package org.palpate.device.protocol;

import java.util.Arrays;

/** Bytes that hold little-endian numbers. Immutable. */
public final class Bytes {
  private final byte[] bytes;

  private Bytes(byte[] bytes) {
    this.bytes = bytes;
  }

  /** Returns a copy of these bytes. */
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
        && Arrays.equals(Arrays.copyOfRange(bytes, at, at + expected.length), expected);
  }

  int unsigned8(int at) {
    return bytes[at] & 0xFF;
  }

  int unsigned16(int at) {
    return unsigned8(at) | unsigned8(at + 1) << 8;
  }

  int signed16(int at) {
    return (short) unsigned16(at);
  }

  int signed32(int at) {
    return unsigned16(at) | unsigned16(at + 2) << 16;
  }
}
