package org.palpate.io.format;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.ByteArrayInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.palpate.io.volume.VoxelSlice;
import org.palpate.io.volume.VoxelType;

class TextSampleStreamTest {
  private static TextSampleStream stream(String text, VoxelType type) {
    return new TextSampleStream(
        new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)), type);
  }

  @Test
  void wordsAreSeparatedByAnyGap() throws IOException {
    VoxelSlice slice = new VoxelSlice(5, 1, true);
    stream("\n 1\t-2,,3\r\n 4 5", VoxelType.INT8).read(slice, 0, 5);
    assertEquals("1 -2 3 4 5", text(slice));
  }

  private static String text(VoxelSlice slice) {
    StringBuilder text = new StringBuilder();
    for (int n = 0; n < slice.count(); n++) {
      text.append(n == 0 ? "" : " ").append((long) slice.value(n));
    }
    return text.toString();
  }

  @Test
  void wordsAreSkippedOneByOne() throws IOException {
    VoxelSlice slice = new VoxelSlice(2, 1, true);
    TextSampleStream stream = stream("1 2 3 4 5", VoxelType.UINT8);
    stream.skip(2);
    stream.read(slice, 1, 1);
    stream.skip(1);
    stream.read(slice, 0, 1);
    assertEquals("5 3", text(slice));
    assertEquals(
        "the values end",
        assertThrows(EOFException.class, () -> stream.read(slice, 0, 1)).getMessage());
  }

  @ParameterizedTest
  @CsvSource({
    "256, UINT8, unsigned 8 bit",
    "-1, UINT8, unsigned 8 bit",
    "1.5, INT16, signed 16 bit",
    "nan, INT16, signed 16 bit",
    "inf, INT32, signed 32 bit",
    "one, FLOAT32, 32 bit floating point",
    "1e, FLOAT64, 64 bit floating point"
  })
  void aWordThatTheTypeCannotHoldIsRefused(String word, VoxelType type, String description) {
    VoxelSlice slice = new VoxelSlice(1, 1, type.fitsInt());
    assertEquals(
        "'" + word + "' is no value of type " + description,
        assertThrows(IOException.class, () -> stream(word, type).read(slice, 0, 1)).getMessage());
  }

  @Test
  void floatsMayBeSpecial() throws IOException {
    VoxelSlice slice = new VoxelSlice(4, 1, false);
    stream("nan -NaN inf -1e-300", VoxelType.FLOAT64).read(slice, 0, 4);
    assertEquals(Double.NaN, slice.doubles()[0]);
    assertEquals(Double.NaN, slice.doubles()[1]);
    assertEquals(Double.POSITIVE_INFINITY, slice.doubles()[2]);
    assertEquals(-1e-300, slice.doubles()[3]);
  }

  @Test
  void aWordHasAnEnd() throws IOException {
    VoxelSlice slice = new VoxelSlice(1, 1, true);
    stream("0".repeat(64) + " ", VoxelType.INT32).read(slice, 0, 1);
    assertEquals(
        "a number has more than 64 characters",
        assertThrows(
                IOException.class, () -> stream("0".repeat(65), VoxelType.INT32).read(slice, 0, 1))
            .getMessage());
  }
}
