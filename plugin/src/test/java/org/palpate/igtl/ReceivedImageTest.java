package org.palpate.igtl;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.Vec3;

class ReceivedImageTest {
  private static final int BODY = MessageHeader.BYTES;

  private static ReceivedImage parse(byte[] bytes) throws IOException {
    byte[] body = Arrays.copyOfRange(bytes, BODY, bytes.length);
    ByteBuffer.wrap(bytes).putLong(42, body.length).putLong(50, Crc64.of(body));
    return ReceivedImage.parse(new MessageReader(new ByteArrayInputStream(bytes), 1 << 20).read());
  }

  /** Returns the recorded image with one byte of its body replaced. */
  private static byte[] with(int offset, int value) {
    byte[] bytes = Recorded.IMAGE.clone();
    bytes[BODY + offset] = (byte) value;
    return bytes;
  }

  @Test
  void readsTheImageOfAnotherProgram() throws IOException {
    ReceivedImage image = parse(Recorded.IMAGE.clone());
    assertEquals("labels", image.name());
    assertEquals(4, image.sizeX());
    assertEquals(3, image.sizeY());
    assertEquals(2, image.sizeZ());
    assertEquals(ReceivedImage.Type.INT16, image.type());
    for (int voxel = 0; voxel < 24; voxel++) {
      assertEquals(voxel, image.value(voxel));
    }
  }

  @Test
  void positionsAreConvertedFromLpsToRas() throws IOException {
    ReceivedImage image = parse(Recorded.IMAGE.clone());
    assertSame(-0.5, 0, 0, image.stepX());
    assertSame(0, -0.75, 0, image.stepY());
    assertSame(0, 0, 2, image.stepZ());
    assertSame(-10, -20, 30, image.firstCentre());
  }

  @Test
  void rasIsKept() throws IOException {
    ReceivedImage image = parse(with(5, 1));
    assertSame(0.5, 0, 0, image.stepX());
    assertSame(10, 20, 30, image.firstCentre());
  }

  private static void assertSame(double x, double y, double z, Vec3 actual) {
    assertEquals(x, actual.x + 0.0);
    assertEquals(y, actual.y + 0.0);
    assertEquals(z, actual.z + 0.0);
  }

  @Test
  void bigEndianValuesAreRead() throws IOException {
    ReceivedImage image = parse(with(4, 1));
    assertEquals(0x0100, image.value(1));
  }

  @Test
  void faultsAreNamed() {
    assertFault("an image has 3 values a voxel; send one", with(2, 3));
    assertFault("an image has the unknown scalar type 9", with(3, 9));
    assertFault("unknown byte order 7", with(4, 7));
    assertFault("unknown coordinate system 3", with(5, 3));
    assertFault("an image is part of a volume; send the whole volume", with(61, 1));
    assertFault("an image is part of a volume; send the whole volume", with(7, 5));
    byte[] longer = Arrays.copyOf(Recorded.IMAGE, Recorded.IMAGE.length + 2);
    assertFault("an image has 50 bytes instead of 48", longer);
  }

  private static void assertFault(String expected, byte[] bytes) {
    LinkProtocolException e = assertThrows(LinkProtocolException.class, () -> parse(bytes));
    assertEquals(expected, e.getMessage());
  }
}
