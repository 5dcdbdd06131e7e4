package org.palpate.app.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.palpate.geometry.Vec3;
import org.palpate.igtl.ReceivedImage;
import org.palpate.io.GreyVolumes;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.volume.ScalarVolume;

class ReceivedVolumeTest {
  private static final Vec3 CENTRE = new Vec3(10, 20, 30);

  /** Returns an image of 3 x 2 x 2 voxels whose values are 1 to 12. */
  private static ReceivedImage image(ReceivedImage.Type type, Vec3 stepX, Vec3 stepY, Vec3 stepZ) {
    ByteBuffer values = ByteBuffer.allocate(12 * 8).order(ByteOrder.LITTLE_ENDIAN);
    for (int n = 1; n <= 12; n++) {
      switch (type) {
        case INT8, UINT8 -> values.put((byte) n);
        case INT16, UINT16 -> values.putShort((short) n);
        case INT32, UINT32 -> values.putInt(n);
        case FLOAT32 -> values.putFloat(n);
        case FLOAT64 -> values.putDouble(n);
      }
    }
    return new ReceivedImage("ct", 3, 2, 2, stepX, stepY, stepZ, CENTRE, type, values);
  }

  private static ReceivedImage image(ReceivedImage.Type type) {
    return image(type, new Vec3(0, 0.5, 0), new Vec3(-2, 0, 0), new Vec3(0, 0, 3));
  }

  @ParameterizedTest
  @EnumSource(ReceivedImage.Type.class)
  void everyTypeIsReadAsFromAFile(ReceivedImage.Type type) throws IOException {
    ReceivedVolume volume = ReceivedVolume.of(image(type)).orElseThrow();
    assertEquals(type.name(), volume.header().type().name());
    ScalarVolume values = GreyVolumes.read(volume);
    for (int n = 0; n < 12; n++) {
      assertEquals(n + 1, values.value(n % 3, n / 3 % 2, n / 6));
    }
  }

  @Test
  void voxelsLieWhereTheMessageSays() {
    ReceivedVolume volume = ReceivedVolume.of(image(ReceivedImage.Type.UINT8)).orElseThrow();
    assertEquals(CoordinateSystem.RAS, volume.header().coordinateSystem());
    assertEquals("(0.5, 2.0, 3.0)", volume.header().grid().spacingMm().toString());
    Vec3 last = volume.header().grid().gridToWorld(new Vec3(2.5, 1.5, 1.5), new Vec3());
    assertEquals(0, last.sub(new Vec3(8, 21, 33), last).length(), 1e-12);
    assertEquals("image ct", volume.sourceName());
    assertEquals(List.of(), volume.files());
  }

  @Test
  void axesThatAreNotAtRightAnglesMakeNoVolume() {
    Vec3 x = new Vec3(1, 0, 0);
    Vec3 z = new Vec3(0, 0, 1);
    assertTrue(
        ReceivedVolume.of(image(ReceivedImage.Type.UINT8, x, new Vec3(0.1, 1, 0), z)).isEmpty());
    assertTrue(
        ReceivedVolume.of(image(ReceivedImage.Type.UINT8, x, new Vec3(0, 1e-13, 0), z)).isEmpty());
    assertTrue(
        ReceivedVolume.of(image(ReceivedImage.Type.UINT8, x, new Vec3(0, -1, 0), z)).isPresent());
  }
}
