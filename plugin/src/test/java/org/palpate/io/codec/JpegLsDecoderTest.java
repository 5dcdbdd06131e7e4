package org.palpate.io.codec;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.Random;
import java.util.zip.CRC32;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Compares decoded pixels with those of CharLS 2.4 (pyjpegls 1.5.1). The streams of {@code
 * jpeg-ls.csv} were encoded by CharLS from images made by formula: noise, ramps, flat regions; 2 to
 * 16 bits; lossless and near-lossless; with restart markers and with explicit parameters. A row
 * holds name, width, height, the CRC-32 of the pixels as 16 bits little-endian, and the stream.
 */
class JpegLsDecoderTest {
  /** ITU-T T.87, H.3. */
  private static final String EXAMPLE_OF_THE_STANDARD =
      "ffd8fff7000b0800040004010111 00ffda0008010100000000c000006c80208e01c0000057400000 6ee60000"
          + "01bc18000005d800009160ffd9";

  record Sample(String name, int width, int height, String crc, String hex) {
    byte[] stream() {
      return HexFormat.of().parseHex(hex);
    }

    @Override
    public String toString() {
      return name;
    }
  }

  static List<Sample> samples() throws IOException {
    try (BufferedReader lines =
        new BufferedReader(
            new InputStreamReader(
                JpegLsDecoderTest.class.getResourceAsStream("jpeg-ls.csv"),
                StandardCharsets.UTF_8))) {
      return lines.lines().map(JpegLsDecoderTest::sample).toList();
    }
  }

  private static Sample sample(String line) {
    String[] cells = line.split(",", -1);
    return new Sample(
        cells[0], Integer.parseInt(cells[1]), Integer.parseInt(cells[2]), cells[3], cells[4]);
  }

  @ParameterizedTest
  @MethodSource("samples")
  void decodesWhatCharlsEncoded(Sample sample) throws IOException {
    assertEquals(sample.crc(), crc(decoded(sample.stream(), sample.width(), sample.height())));
  }

  @Test
  void decodesTheExampleOfTheStandard() throws IOException {
    byte[] stream = HexFormat.of().parseHex(EXAMPLE_OF_THE_STANDARD.replace(" ", ""));
    assertArrayEquals(
        new int[] {0, 0, 90, 74, 68, 50, 43, 205, 64, 145, 145, 145, 100, 145, 145, 145},
        decoded(stream, 4, 4));
  }

  @ParameterizedTest
  @CsvSource({
    "8, 0, 3, 7, 21",
    "8, 3, 12, 22, 42",
    "12, 0, 18, 67, 276",
    "16, 0, 18, 67, 276",
    "2, 0, 2, 3, 3"
  })
  void thresholdsAreThoseOfTheStandard(int bits, int near, int first, int second, int third) {
    JpegLsParameters defaults = JpegLsParameters.defaults((1 << bits) - 1, near);
    assertEquals(
        List.of(first, second, third),
        List.of(defaults.threshold1(), defaults.threshold2(), defaults.threshold3()));
  }

  @Test
  void refusesAnotherSizeBeforeDecoding() throws IOException {
    Sample sample = samples().get(0);
    IOException refused =
        assertThrows(
            IOException.class, () -> decoded(sample.stream(), sample.width() + 1, sample.height()));
    assertTrue(refused.getMessage().contains("another size"), refused.getMessage());
  }

  @Test
  void refusesEveryTruncatedStream() throws IOException {
    for (Sample sample : samples()) {
      for (int length = 0; length < sample.stream().length - 8; length++) {
        byte[] part = Arrays.copyOf(sample.stream(), length);
        assertThrows(
            IOException.class,
            () -> decoded(part, sample.width(), sample.height()),
            sample + " cut to " + length);
      }
    }
  }

  /** A damaged stream gives some pixels or an {@link IOException}, and always ends. */
  @Test
  void survivesDamagedStreams() throws IOException {
    long seed = Long.getLong("palpate.seed", System.nanoTime());
    System.out.println("JpegLsDecoderTest seed " + seed);
    Random random = new Random(seed);
    List<Sample> samples = samples();
    for (int n = 0; n < 20_000; n++) {
      Sample sample = samples.get(random.nextInt(samples.size()));
      byte[] damaged = sample.stream().clone();
      for (int times = 1 + random.nextInt(3); times > 0; times--) {
        damaged[random.nextInt(damaged.length)] = (byte) random.nextInt(256);
      }
      try {
        decoded(damaged, sample.width(), sample.height());
      } catch (IOException refused) {
        assertTrue(refused.getMessage().startsWith("the JPEG-LS stream"), refused.getMessage());
      }
    }
  }

  private static int[] decoded(byte[] stream, int width, int height) throws IOException {
    int[] pixels = new int[width * height];
    JpegLsDecoder.decode(stream, width, height, pixels);
    return pixels;
  }

  private static String crc(int[] pixels) {
    CRC32 crc = new CRC32();
    for (int pixel : pixels) {
      crc.update(pixel & 0xff);
      crc.update(pixel >> 8);
    }
    return String.format("%08x", crc.getValue());
  }
}
