package org.palpate.igtl;

/**
 * The checksum of OpenIGTLink messages: CRC-64 with the polynomial of ECMA-182, most significant
 * bit first, start value 0 and no final inversion.
 *
 * <p>Reference: OpenIGTLink protocol, "CRC", which takes the polynomial from ECMA-182, annex B.
 */
final class Crc64 {
  private static final long POLYNOMIAL = 0x42F0E1EBA9EA3693L;
  private static final long[] TABLE = table();

  private Crc64() {}

  private static long[] table() {
    long[] table = new long[256];
    for (int value = 0; value < table.length; value++) {
      long crc = (long) value << 56;
      for (int bit = 0; bit < 8; bit++) {
        crc = crc < 0 ? crc << 1 ^ POLYNOMIAL : crc << 1;
      }
      table[value] = crc;
    }
    return table;
  }

  /** Returns the checksum of {@code bytes}. */
  static long of(byte[] bytes) {
    long crc = 0;
    for (byte each : bytes) {
      crc = TABLE[(int) (crc >>> 56 ^ each) & 0xff] ^ crc << 8;
    }
    return crc;
  }
}
