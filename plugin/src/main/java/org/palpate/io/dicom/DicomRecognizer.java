package org.palpate.io.dicom;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Set;

/**
 * Recognizes DICOM files by their first bytes, with the preamble that the standard asks for or
 * without.
 *
 * <p>Source: DICOM PS3.10 section 7.1, PS3.5 section 7.1.
 */
final class DicomRecognizer {
  /** Bytes that are enough to recognize a file. */
  static final int START_BYTES = 1024;

  /** Offset of the letters DICM. */
  static final int PREAMBLE = 128;

  private static final int META_GROUP = 0x0002;
  private static final int FIRST_GROUP = 0x0008;
  private static final int MIN_ATTRIBUTES = 3;
  private static final int MAX_VALUE_BYTES = 1 << 16;
  private static final Set<String> SHORT_VRS =
      Set.of(
          "AE", "AS", "AT", "CS", "DA", "DS", "DT", "FL", "FD", "IS", "LO", "LT", "PN", "SH", "SL",
          "SS", "ST", "TM", "UI", "UL", "US");

  private DicomRecognizer() {}

  /** Returns whether a file with these first bytes is a DICOM file. */
  static boolean isDicom(byte[] start) {
    return hasPreamble(start) || isBare(start);
  }

  /** Returns whether the letters DICM follow 128 bytes. */
  static boolean hasPreamble(byte[] start) {
    return start.length >= PREAMBLE + 4
        && new String(start, PREAMBLE, 4, StandardCharsets.ISO_8859_1).equals("DICM");
  }

  /**
   * Returns whether the bytes begin with attributes of group 2 or 8 in ascending order, which no
   * other format does. Byte order little-endian.
   */
  static boolean isBare(byte[] start) {
    ByteBuffer bytes = ByteBuffer.wrap(start).order(ByteOrder.LITTLE_ENDIAN);
    long before = -1;
    int at = 0;
    for (int n = 0; n < MIN_ATTRIBUTES; n++) {
      if (at > start.length - 12) {
        return n >= 2; // the values fill the bytes that were given
      }
      int group = bytes.getShort(at) & 0xffff;
      long tag = (long) group << 16 | (bytes.getShort(at + 2) & 0xffff);
      long next = at + attributeBytes(bytes, at);
      boolean fits = group == FIRST_GROUP || group == META_GROUP || n > 0;
      if (!fits || tag <= before || next < at) {
        return false;
      }
      before = tag;
      at = (int) Math.min(next, start.length);
    }
    return true;
  }

  /** Whether an attribute states its value representation. */
  static boolean isExplicit(ByteBuffer bytes, int at) {
    String vr = "" + (char) bytes.get(at + 4) + (char) bytes.get(at + 5);
    return SHORT_VRS.contains(vr) || DicomParser.isLong(vr);
  }

  /** Returns the bytes of an attribute, or a negative number if its length makes no sense. */
  private static long attributeBytes(ByteBuffer bytes, int at) {
    String vr = "" + (char) bytes.get(at + 4) + (char) bytes.get(at + 5);
    int head = DicomParser.isLong(vr) ? 12 : 8;
    long length =
        SHORT_VRS.contains(vr)
            ? bytes.getShort(at + 6) & 0xffff
            : bytes.getInt(at + (head == 12 ? 8 : 4)) & 0xffffffffL;
    return length % 2 != 0 || length > MAX_VALUE_BYTES ? Long.MIN_VALUE : head + length;
  }
}
