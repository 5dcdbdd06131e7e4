package org.palpate.io.format;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.ByteArrayInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.math.BigInteger;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.palpate.io.volume.VoxelSlice;
import org.palpate.io.volume.VoxelType;
import org.palpate.testing.Seeds;

class BinarySampleStreamTest {
  private static final long SEED = Seeds.seed();

  static Stream<Arguments> typesAndOrders() {
    List<Arguments> all = new ArrayList<>();
    for (VoxelType type : VoxelType.values()) {
      all.add(Arguments.of(type, ByteOrder.LITTLE_ENDIAN));
      all.add(Arguments.of(type, ByteOrder.BIG_ENDIAN));
    }
    return all.stream();
  }

  /** Returns a sample as its bytes say, by whole numbers of any size. */
  private static double naive(byte[] bytes, int sample, VoxelType type, ByteOrder order) {
    byte[] big = new byte[type.bytes()];
    for (int n = 0; n < big.length; n++) {
      int at = order == ByteOrder.BIG_ENDIAN ? n : big.length - 1 - n;
      big[n] = bytes[sample * big.length + at];
    }
    return switch (type) {
      case UINT8, UINT16, UINT32, UINT64 -> new BigInteger(1, big).doubleValue();
      case FLOAT32 -> ByteBuffer.wrap(big).getFloat();
      case FLOAT64 -> ByteBuffer.wrap(big).getDouble();
      default -> new BigInteger(big).doubleValue();
    };
  }

  @ParameterizedTest
  @MethodSource("typesAndOrders")
  void everyTypeIsReadToTheBitInBothByteOrders(VoxelType type, ByteOrder order) throws IOException {
    SplittableRandom random = new SplittableRandom(SEED);
    int count = (1 << 16) / type.bytes() + 700; // more than one buffer
    byte[] bytes = new byte[count * type.bytes()];
    for (int n = 0; n < bytes.length; n++) {
      bytes[n] = (byte) (n < 16 * type.bytes() ? -(n / type.bytes() & 1) : random.nextInt());
    }
    VoxelSlice slice = new VoxelSlice(count, 1, type.fitsInt());
    try (BinarySampleStream stream =
        new BinarySampleStream(new ByteArrayInputStream(bytes), type, order, Scaling.NONE)) {
      stream.read(slice, 0, count / 3);
      stream.read(slice, count / 3, count - count / 3);
    }
    for (int n = 0; n < count; n++) {
      assertEquals(naive(bytes, n, type, order), slice.value(n), "n=" + n + " seed=" + SEED);
    }
  }

  @ParameterizedTest
  @MethodSource("typesAndOrders")
  void skippedSamplesAreLeftOut(VoxelType type, ByteOrder order) throws IOException {
    int count = (1 << 16) / type.bytes() + 700;
    byte[] bytes = new byte[count * type.bytes()];
    new SplittableRandom(SEED).nextBytes(bytes);
    VoxelSlice slice = new VoxelSlice(3, 1, type.fitsInt());
    BinarySampleStream stream =
        new BinarySampleStream(new ByteArrayInputStream(bytes), type, order, Scaling.NONE);
    stream.skip(5);
    stream.read(slice, 0, 1);
    stream.skip(7);
    stream.read(slice, 1, 1);
    stream.skip(count - 15);
    stream.read(slice, 2, 1);
    assertEquals(naive(bytes, 5, type, order), slice.value(0), "seed=" + SEED);
    assertEquals(naive(bytes, 13, type, order), slice.value(1), "seed=" + SEED);
    assertEquals(naive(bytes, count - 1, type, order), slice.value(2), "seed=" + SEED);
    assertThrows(EOFException.class, () -> stream.read(slice, 0, 1));
  }

  @Test
  void integersAndDoublesAreScaled() throws IOException {
    byte[] bytes = {1, -2, 100, 0};
    VoxelSlice integers = new VoxelSlice(4, 1, true);
    read(bytes, VoxelType.INT8, new Scaling(-3, 7), integers);
    assertEquals(4, integers.integers()[0]);
    assertEquals(13, integers.integers()[1]);
    assertEquals(-293, integers.integers()[2]);
    VoxelSlice doubles = new VoxelSlice(4, 1, false);
    read(bytes, VoxelType.INT8, new Scaling(0.5, -1), doubles);
    assertEquals(-0.5, doubles.doubles()[0]);
    assertEquals(-2, doubles.doubles()[1]);
    assertEquals(-1, doubles.doubles()[3]);
  }

  private static void read(byte[] bytes, VoxelType type, Scaling scaling, VoxelSlice slice)
      throws IOException {
    new BinarySampleStream(new ByteArrayInputStream(bytes), type, ByteOrder.LITTLE_ENDIAN, scaling)
        .read(slice, 0, bytes.length / type.bytes());
  }

  @Test
  void dataThatEndTooSoonAreFound() {
    BinarySampleStream stream =
        new BinarySampleStream(
            new ByteArrayInputStream(new byte[5]),
            VoxelType.INT16,
            ByteOrder.LITTLE_ENDIAN,
            Scaling.NONE);
    VoxelSlice slice = new VoxelSlice(4, 1, true);
    assertEquals(
        "the data end",
        assertThrows(EOFException.class, () -> stream.read(slice, 0, 3)).getMessage());
    assertEquals(
        "the data end among skipped samples",
        assertThrows(EOFException.class, () -> stream.skip(3)).getMessage());
  }

  @Test
  void coloursAreReadAsTheirLuminance() throws IOException {
    byte[] bytes = new byte[4 * 5000];
    new SplittableRandom(SEED).nextBytes(bytes);
    VoxelSlice slice = new VoxelSlice(4999, 1, true);
    try (SampleStream stream =
        new LuminanceSampleStream(
            new BinarySampleStream(
                new ByteArrayInputStream(bytes),
                VoxelType.UINT8,
                ByteOrder.LITTLE_ENDIAN,
                Scaling.NONE),
            4)) {
      stream.skip(1);
      stream.read(slice, 0, 4999);
    }
    for (int n = 0; n < 4999; n++) {
      int at = 4 * (n + 1);
      double grey =
          0.299 * (bytes[at] & 0xff)
              + 0.587 * (bytes[at + 1] & 0xff)
              + 0.114 * (bytes[at + 2] & 0xff);
      assertEquals(grey, slice.integers()[n], 0.5 + 1e-9, "n=" + n + " seed=" + SEED);
    }
    assertEquals(255, Luminance.of(255, 255, 255));
    assertEquals(65535, Luminance.of(65535, 65535, 65535));
    assertEquals(0, Luminance.of(0, 0, 0));
  }
}
