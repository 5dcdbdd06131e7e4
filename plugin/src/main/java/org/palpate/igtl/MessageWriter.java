package org.palpate.igtl;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.time.Instant;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;

/**
 * Writes messages with the header of version 1, which every client reads. Allocates; used by the
 * server's own threads only.
 */
final class MessageWriter {
  /** The code of a status that reports success. */
  static final int STATUS_OK = 1;

  /** The code of a status that reports a message that is not accepted. */
  static final int STATUS_ILLEGAL = 12;

  /** No unit. */
  static final long UNIT_NONE = 0;

  /** Newton: unit 0x0b with exponent 1, see "unit" of the protocol. */
  static final long UNIT_NEWTON = 0x0bL << 54 | 1L << 50;

  /** Newton millimetre: prefix milli, newton and metre with exponent 1. */
  static final long UNIT_NEWTON_MM = 0xbL << 60 | UNIT_NEWTON | 1L << 44 | 1L << 40;

  private static final int HEADER_VERSION = 1;
  private static final int POINT_BYTES = 136;
  private static final int POINT_NAME_BYTES = 64;
  private static final int POINT_GROUP_BYTES = 32;
  private static final int OWNER_BYTES = 20;
  private static final int STATUS_NAME_BYTES = 20;
  private static final double NANOS_PER_SECOND = 1e9;
  private static final double FRACTIONS_PER_SECOND = 0x1p32;

  private final ByteArrayOutputStream out = new ByteArrayOutputStream();

  /** The time of all messages until it is set again. */
  private long timestamp;

  /** Sets the time of the messages that follow. */
  void setTime(Instant time) {
    long fractions = (long) (time.getNano() / NANOS_PER_SECOND * FRACTIONS_PER_SECOND);
    timestamp = time.getEpochSecond() << 32 | fractions;
  }

  /** Appends a TRANSFORM: the rotation by columns, then the translation, as floats. */
  void transform(String name, RigidTransform pose) {
    ByteBuffer body = ByteBuffer.allocate(ReceivedTransform.BYTES);
    putFloats(body, pose.axisX());
    putFloats(body, pose.axisY());
    putFloats(body, pose.axisZ());
    putFloats(body, pose.origin());
    append(ReceivedTransform.TYPE, name, body.array());
  }

  private static void putFloats(ByteBuffer body, Vec3 vector) {
    body.putFloat((float) vector.x).putFloat((float) vector.y).putFloat((float) vector.z);
  }

  /** Appends a SENSOR with the given values, which share a unit. */
  void sensor(String name, long unit, double... values) {
    ByteBuffer body = ByteBuffer.allocate(2 + Long.BYTES * (1 + values.length));
    body.put((byte) values.length).put((byte) 0).putLong(unit);
    for (double value : values) {
      body.putDouble(value);
    }
    append("SENSOR", name, body.array());
  }

  /** Appends a POINT message with all landmarks. */
  void points(String name, Iterable<LinkState.Landmark> landmarks) {
    ByteArrayOutputStream body = new ByteArrayOutputStream();
    for (LinkState.Landmark landmark : landmarks) {
      ByteBuffer one = ByteBuffer.allocate(POINT_BYTES);
      MessageHeader.putText(one, landmark.name(), POINT_NAME_BYTES);
      MessageHeader.putText(one, "Landmark", POINT_GROUP_BYTES);
      one.put(new byte[] {(byte) 0xff, (byte) 0xff, 0, (byte) 0xff}); // red, green, blue, opacity
      putFloats(one, landmark.position());
      one.putFloat(0); // diameter
      MessageHeader.putText(one, "", OWNER_BYTES);
      body.writeBytes(one.array());
    }
    append("POINT", name, body.toByteArray());
  }

  /** Appends a STATUS. */
  void status(String name, int code, String error, String text) {
    byte[] ascii = text.getBytes(StandardCharsets.US_ASCII);
    ByteBuffer body = ByteBuffer.allocate(2 + Long.BYTES + STATUS_NAME_BYTES + ascii.length + 1);
    body.putShort((short) code).putLong(0);
    MessageHeader.putText(body, error, STATUS_NAME_BYTES);
    body.put(ascii).put((byte) 0);
    append("STATUS", name, body.array());
  }

  private void append(String type, String name, byte[] body) {
    ByteBuffer header = ByteBuffer.allocate(MessageHeader.BYTES);
    new MessageHeader(HEADER_VERSION, type, name, timestamp, body.length, Crc64.of(body))
        .write(header);
    out.writeBytes(header.array());
    out.writeBytes(body);
  }

  /** Returns all messages since the last call, in order. */
  byte[] take() {
    byte[] bytes = out.toByteArray();
    out.reset();
    return bytes;
  }
}
