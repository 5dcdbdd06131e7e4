package org.palpate.io.dicom;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/**
 * Collects the attributes of a data set or of a sequence item, explicit VR little-endian.
 * Attributes must be added in ascending order.
 *
 * <p>Source: DICOM PS3.5, section 7.1.2.
 */
final class DicomElements {
  private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();

  /** Adds a text in UTF-8, filled up to an even length. */
  DicomElements text(int tag, String vr, String value) {
    byte[] text = value.getBytes(StandardCharsets.UTF_8);
    if (text.length % 2 == 0) {
      return value(tag, vr, text);
    }
    byte[] padded = Arrays.copyOf(text, text.length + 1);
    padded[text.length] = (byte) (vr.equals("UI") ? 0 : ' ');
    return value(tag, vr, padded);
  }

  /** Adds unsigned numbers of 16 bits. */
  DicomElements shorts(int tag, int... numbers) {
    ByteBuffer value = ByteBuffer.allocate(2 * numbers.length).order(ByteOrder.LITTLE_ENDIAN);
    for (int number : numbers) {
      value.putShort((short) number);
    }
    return value(tag, "US", value.array());
  }

  /** Adds unsigned numbers of 32 bits. */
  DicomElements ints(int tag, int... numbers) {
    ByteBuffer value = ByteBuffer.allocate(4 * numbers.length).order(ByteOrder.LITTLE_ENDIAN);
    for (int number : numbers) {
      value.putInt(number);
    }
    return value(tag, "UL", value.array());
  }

  /** Adds references to attributes. */
  DicomElements tag(int tag, int reference) {
    ByteBuffer value = ByteBuffer.allocate(4).order(ByteOrder.LITTLE_ENDIAN);
    value.putShort((short) (reference >>> 16)).putShort((short) reference);
    return value(tag, "AT", value.array());
  }

  /** Adds a sequence of items. */
  DicomElements sequence(int tag, DicomElements... items) {
    ByteArrayOutputStream value = new ByteArrayOutputStream();
    for (DicomElements item : items) {
      value.writeBytes(headBytes(DicomTag.ITEM, "", item.bytes.size()));
      value.writeBytes(item.toBytes());
    }
    return value(tag, "SQ", value.toByteArray());
  }

  /** Adds a value of an even number of bytes. */
  DicomElements value(int tag, String vr, byte[] value) {
    bytes.writeBytes(headBytes(tag, vr, value.length));
    bytes.writeBytes(value);
    return this;
  }

  /** Adds the head of a value that follows elsewhere. */
  DicomElements head(int tag, String vr, long length) {
    bytes.writeBytes(headBytes(tag, vr, length));
    return this;
  }

  private static byte[] headBytes(int tag, String vr, long length) {
    boolean wide = DicomParser.isLong(vr);
    ByteBuffer head = ByteBuffer.allocate(wide ? 12 : 8).order(ByteOrder.LITTLE_ENDIAN);
    head.putShort((short) (tag >>> 16)).putShort((short) tag);
    head.put(vr.getBytes(StandardCharsets.ISO_8859_1));
    if (wide) {
      head.putShort((short) 0);
    }
    if (wide || vr.isEmpty()) {
      head.putInt((int) length);
    } else {
      head.putShort((short) length);
    }
    return head.array();
  }

  /** Returns everything that was added. */
  byte[] toBytes() {
    return bytes.toByteArray();
  }
}
