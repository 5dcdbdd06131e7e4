package org.palpate.igtl;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.time.Instant;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.testing.RandomGeometry;
import org.palpate.testing.Seeds;

class MessageWriterTest {
  private static final long SEED = Seeds.seed();

  private final MessageWriter writer = new MessageWriter();

  /** Returns a reader of everything that was written. */
  private MessageReader written() {
    return new MessageReader(new ByteArrayInputStream(writer.take()), 1 << 20);
  }

  private static String text(ByteBuffer in, int bytes) {
    return MessageHeader.text(in, bytes);
  }

  @Test
  void aTransformIsReadBack() throws IOException {
    SplittableRandom random = new SplittableRandom(SEED);
    for (int round = 0; round < 100; round++) {
      RigidTransform pose = RandomGeometry.pose(random, 200).transform(RigidTransform.identity());
      writer.transform("Probe", pose);
      Message message = written().read();
      ReceivedTransform read = ReceivedTransform.parse(message);
      assertEquals("Probe", read.name());
      Vec3 at = RandomGeometry.vector(random, 10);
      Vec3 apart = pose.transform(at, new Vec3()).sub(read.pose().transform(at, new Vec3()), at);
      assertEquals(0, apart.length(), 1e-4, "seed=" + SEED);
    }
  }

  @Test
  void theBytesAreThoseOfAnotherProgram() {
    writer.setTime(Instant.ofEpochSecond(1, 500_000_000));
    Message recorded;
    try {
      recorded = new MessageReader(new ByteArrayInputStream(Recorded.TRANSFORM_V1), 1 << 20).read();
      writer.transform("Probe", ReceivedTransform.parse(recorded).pose());
    } catch (IOException e) {
      throw new IllegalStateException(e);
    }
    assertArrayEquals(Recorded.TRANSFORM_V1, writer.take());
  }

  @Test
  void messagesFollowOneAnotherUntilTheyAreTaken() throws IOException {
    writer.sensor("a", MessageWriter.UNIT_NONE, 1);
    writer.status("b", MessageWriter.STATUS_OK, "", "");
    MessageReader reader = written();
    assertEquals("a", reader.read().header().deviceName());
    assertEquals("b", reader.read().header().deviceName());
    assertNull(reader.read());
    assertEquals(0, writer.take().length);
  }

  @Test
  void aSensorHasItsUnitAndItsValues() throws IOException {
    writer.sensor("Force", MessageWriter.UNIT_NEWTON, 1.5, -2, 1e-9);
    Message message = written().read();
    assertEquals("SENSOR", message.header().type());
    ByteBuffer body = message.content();
    assertEquals(3, body.get());
    assertEquals(0, body.get());
    assertEquals(0x02c4_0000_0000_0000L, body.getLong());
    assertEquals(1.5, body.getDouble());
    assertEquals(-2, body.getDouble());
    assertEquals(1e-9, body.getDouble());
    assertEquals(0, body.remaining());
    assertEquals(0xb2c4_1100_0000_0000L, MessageWriter.UNIT_NEWTON_MM);
  }

  @Test
  void landmarksAreNamedPoints() throws IOException {
    String longName = "n".repeat(70);
    writer.points(
        "Landmarks",
        List.of(
            new LinkState.Landmark("nose", new Vec3(1, 2, 3)),
            new LinkState.Landmark(longName, new Vec3(-1, 0, 0.5))));
    ByteBuffer body = written().read().content();
    assertEquals(2 * 136, body.remaining());
    assertEquals("nose", text(body, 64));
    assertEquals("Landmark", text(body, 32));
    assertEquals(0xffff00ff, body.getInt());
    assertEquals(1, body.getFloat());
    assertEquals(2, body.getFloat());
    assertEquals(3, body.getFloat());
    assertEquals(0, body.getFloat());
    assertEquals("", text(body, 20));
    assertEquals(longName.substring(0, 64), text(body, 64));
  }

  @Test
  void aStatusHasACodeANameAndAText() throws IOException {
    writer.status("Palpate", MessageWriter.STATUS_ILLEGAL, "bad message", "say\u00e9");
    ByteBuffer body = written().read().content();
    assertEquals(12, body.getShort());
    assertEquals(0, body.getLong());
    assertEquals("bad message", text(body, 20));
    byte[] rest = new byte[body.remaining()];
    body.get(rest);
    assertEquals("say?\0", new String(rest, StandardCharsets.US_ASCII));
  }

  @Test
  void theTimeHasFractionsOfASecond() throws IOException {
    writer.sensor("a", 0, 1);
    assertEquals(0, written().read().header().timestamp());
    writer.setTime(Instant.ofEpochSecond(7, 250_000_000));
    writer.sensor("a", 0, 1);
    assertEquals(7L << 32 | 0x4000_0000L, written().read().header().timestamp());
    writer.setTime(Instant.ofEpochSecond(7, 999_999_999));
    writer.sensor("a", 0, 1);
    assertEquals(7, written().read().header().timestamp() >> 32);
  }

  @Test
  void aNameIsCutToItsField() throws IOException {
    writer.sensor("a name of more than twenty letters", 0, 1);
    assertEquals("a name of more than ", written().read().header().deviceName() + " ");
  }

  @Test
  void aTransformThatIsNoRigidMotionIsRefused() {
    RigidTransform mirrored =
        new RigidTransform(new Vec3(-1, 0, 0), new Vec3(0, 1, 0), new Vec3(0, 0, 1), new Vec3());
    RigidTransform scaled =
        new RigidTransform(new Vec3(2, 0, 0), new Vec3(0, 2, 0), new Vec3(0, 0, 2), new Vec3());
    RigidTransform far = RigidTransform.identity();
    far.origin().set(Double.NaN, 0, 0);
    for (RigidTransform pose : List.of(mirrored, scaled, far)) {
      writer.transform("a", pose);
      assertEquals(
          "a transform is no rigid motion; send one without scale, shear and reflection",
          assertThrows(LinkProtocolException.class, () -> ReceivedTransform.parse(written().read()))
              .getMessage());
    }
    writer.sensor("a", 0, 1);
    assertEquals(
        "a transform has 18 bytes instead of 48",
        assertThrows(LinkProtocolException.class, () -> ReceivedTransform.parse(written().read()))
            .getMessage());
  }
}
