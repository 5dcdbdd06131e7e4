package org.palpate.igtl;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;

class MessageReaderTest {
  private static final long MAX_IMAGE_BYTES = 1 << 20;
  private static final long SEED = Long.getLong("palpate.seed", 11);
  private static final int MUTATIONS = 20_000;

  private static Message read(byte[] bytes) throws IOException {
    return new MessageReader(new ByteArrayInputStream(bytes), MAX_IMAGE_BYTES).read();
  }

  @Test
  void readsTheTransformOfAnotherProgram() throws IOException {
    Message message = read(Recorded.TRANSFORM_V1);
    assertEquals("TRANSFORM", message.header().type());
    assertEquals("Probe", message.header().deviceName());
    assertEquals(0x1_8000_0000L, message.header().timestamp()); // 1.5 s
    assertEquals(48, message.content().remaining());
    assertEquals(1.5f, message.content().getFloat(36));
  }

  @Test
  void contentIsTheSameWithExtendedHeaderAndMetadata() throws IOException {
    assertEquals(read(Recorded.TRANSFORM_V1).content(), read(Recorded.TRANSFORM_V2).content());
  }

  @Test
  void versionThreeIsReadLikeVersionTwo() throws IOException {
    byte[] third = Recorded.TRANSFORM_V2.clone();
    third[1] = 3;
    assertEquals(read(Recorded.TRANSFORM_V2).content(), read(third).content());
  }

  @Test
  void endsBetweenTwoMessages() throws IOException {
    byte[] twice = new byte[2 * Recorded.TRANSFORM_V1.length];
    System.arraycopy(Recorded.TRANSFORM_V1, 0, twice, 0, twice.length / 2);
    System.arraycopy(Recorded.TRANSFORM_V1, 0, twice, twice.length / 2, twice.length / 2);
    MessageReader reader = new MessageReader(new ByteArrayInputStream(twice), MAX_IMAGE_BYTES);
    assertEquals("TRANSFORM", reader.read().header().type());
    assertEquals("TRANSFORM", reader.read().header().type());
    assertNull(reader.read());
  }

  @Test
  void everyCutIsFound() {
    for (int length = 1; length < Recorded.TRANSFORM_V1.length; length++) {
      byte[] cut = Arrays.copyOf(Recorded.TRANSFORM_V1, length);
      assertThrows(EOFException.class, () -> read(cut), "bytes=" + length);
    }
  }

  @Test
  void everyFlippedBitOfTheBodyIsFound() {
    for (int bit = 8 * MessageHeader.BYTES; bit < 8 * Recorded.TRANSFORM_V1.length; bit++) {
      byte[] flipped = Recorded.TRANSFORM_V1.clone();
      flipped[bit / 8] ^= (byte) (1 << bit % 8);
      assertThrows(LinkProtocolException.class, () -> read(flipped), "bit=" + bit);
    }
  }

  @Test
  void aHugeBodyIsRefusedBeforeItIsRead() {
    byte[] header = Arrays.copyOf(Recorded.TRANSFORM_V1, MessageHeader.BYTES);
    ByteBuffer.wrap(header).putLong(42, Long.MAX_VALUE);
    InputStream endless =
        new InputStream() {
          private int at;

          @Override
          public int read() {
            assertTrue(at < header.length, "the body was read");
            return header[at++] & 0xff;
          }

          @Override
          public int read(byte[] dest, int offset, int length) {
            if (length == 0) {
              return 0;
            }
            dest[offset] = (byte) read();
            return 1;
          }
        };
    LinkProtocolException e =
        assertThrows(
            LinkProtocolException.class, () -> new MessageReader(endless, MAX_IMAGE_BYTES).read());
    assertEquals(
        "a TRANSFORM message has 9223372036854775807 bytes; at most 1048576 are accepted",
        e.getMessage());
  }

  @Test
  void unknownVersionsAreRefused() {
    for (int version : new int[] {0, 4, 0xffff}) {
      byte[] bytes = Recorded.TRANSFORM_V1.clone();
      ByteBuffer.wrap(bytes).putShort((short) version);
      LinkProtocolException e =
          assertThrows(LinkProtocolException.class, () -> read(bytes), "version=" + version);
      assertEquals("unknown header version " + version + "; 1 to 3 are known", e.getMessage());
    }
  }

  @Test
  void damagedMessagesGiveAnImageOrAnErrorAndNothingElse() {
    Random random = new Random(SEED);
    for (int n = 0; n < MUTATIONS; n++) {
      byte[] bytes = damaged(random);
      try {
        Message message = read(bytes);
        if (message != null && message.header().type().equals(ReceivedImage.TYPE)) {
          ReceivedImage image = ReceivedImage.parse(message);
          image.value(image.voxels() - 1);
        }
      } catch (IOException e) {
        assertTrue(e.getMessage().length() < 200, e::getMessage);
      } catch (RuntimeException e) {
        throw new AssertionError("seed=" + SEED + " n=" + n + " " + Arrays.toString(bytes), e);
      }
    }
  }

  /** Returns a message with some bytes changed and its checksum made right again. */
  private static byte[] damaged(Random random) {
    byte[] bytes = (random.nextBoolean() ? Recorded.IMAGE : Recorded.TRANSFORM_V2).clone();
    for (int changes = 1 + random.nextInt(4); changes > 0; changes--) {
      bytes[random.nextInt(bytes.length)] = (byte) random.nextInt();
    }
    byte[] body = Arrays.copyOfRange(bytes, MessageHeader.BYTES, bytes.length);
    if (random.nextInt(4) != 0) {
      ByteBuffer.wrap(bytes).putLong(42, body.length).putLong(50, Crc64.of(body));
    }
    return bytes;
  }
}
