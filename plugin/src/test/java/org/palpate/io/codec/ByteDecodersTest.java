package org.palpate.io.codec;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.Map;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.testing.Seeds;

/** Decoders of bytes, against encoders that follow the formats step by step. */
class ByteDecodersTest {
  private static final long SEED = Seeds.seed();

  private final SplittableRandom random = new SplittableRandom(SEED);

  /** Returns bytes in runs, so that codes grow long. */
  private byte[] bytes(int count, int kinds) {
    byte[] bytes = new byte[count];
    for (int n = 0; n < count; n++) {
      bytes[n] = (byte) (n > 0 && random.nextInt(3) > 0 ? bytes[n - 1] : random.nextInt(kinds));
    }
    return bytes;
  }

  /** Reads in pieces of random lengths, one byte at a time now and then. */
  private byte[] read(InputStream in) throws IOException {
    ByteArrayOutputStream all = new ByteArrayOutputStream();
    byte[] piece = new byte[97];
    while (true) {
      if (random.nextInt(5) == 0) {
        int one = in.read();
        if (one < 0) {
          assertEquals(-1, in.read(piece, 3, 1), "the end is the end for several bytes too");
          return all.toByteArray();
        }
        all.write(one);
      } else {
        int count = in.read(piece, 3, 1 + random.nextInt(90));
        if (count < 0) {
          return all.toByteArray();
        }
        all.write(piece, 3, count);
      }
    }
  }

  /** Encodes as TIFF does: a clear code first, codes of 9 to 12 bits that widen one code early. */
  private static byte[] lzw(byte[] data, boolean ends) {
    BitWriter out = new BitWriter();
    Map<String, Integer> table = new HashMap<>();
    out.write(256, 9);
    int width = 9;
    int free = 258;
    String text = "";
    for (byte b : data) {
      String longer = text + (char) (b & 0xff);
      if (longer.length() == 1 || table.containsKey(longer)) {
        text = longer;
        continue;
      }
      out.write(code(text, table), width);
      table.put(longer, free++);
      if (free == 1 << width) {
        width++;
      }
      text = longer.substring(longer.length() - 1);
      if (free == 4094) {
        out.write(code(text, table), width);
        out.write(256, width);
        table.clear();
        free = 258;
        width = 9;
        text = "";
      }
    }
    if (!text.isEmpty()) {
      out.write(code(text, table), width);
      free++;
      width = free == 1 << width ? width + 1 : width;
    }
    if (ends) {
      out.write(257, width);
    }
    return out.bytes();
  }

  private static int code(String text, Map<String, Integer> table) {
    return text.length() == 1 ? text.charAt(0) : table.get(text);
  }

  /** Writes bits, the highest first. */
  private static final class BitWriter {
    private final ByteArrayOutputStream out = new ByteArrayOutputStream();
    private int bits;
    private int count;

    void write(int value, int width) {
      for (int bit = width - 1; bit >= 0; bit--) {
        bits = (bits << 1) | ((value >> bit) & 1);
        if (++count == 8) {
          out.write(bits);
          count = 0;
        }
      }
    }

    byte[] bytes() {
      ByteArrayOutputStream all = new ByteArrayOutputStream();
      all.writeBytes(out.toByteArray());
      if (count > 0) {
        all.write(bits << (8 - count));
      }
      return all.toByteArray();
    }
  }

  @ParameterizedTest
  @CsvSource({"0, 4", "1, 4", "700, 2", "9000, 256", "60000, 3", "30000, 40"})
  void whatLzwEncodedIsDecoded(int count, int kinds) throws IOException {
    byte[] data = bytes(count, kinds);
    byte[] encoded = lzw(data, true);
    assertArrayEquals(
        data, read(new LzwInputStream(new ByteArrayInputStream(encoded))), "seed=" + SEED);
  }

  @Test
  void aStreamWithoutAnEndCodeEndsWithItsBytes() throws IOException {
    byte[] data = {1, 1, 1, 1, 1, 1, 2};
    LzwInputStream in = new LzwInputStream(new ByteArrayInputStream(lzw(data, false)));
    byte[] decoded = new byte[7];
    assertEquals(7, in.read(decoded, 0, 7));
    assertArrayEquals(data, decoded);
  }

  @ParameterizedTest
  @ValueSource(ints = {258, 300, 511})
  void aCodeThatIsNotDefinedIsRefused(int code) {
    BitWriter out = new BitWriter();
    out.write(256, 9);
    out.write(code, 9);
    LzwInputStream in = new LzwInputStream(new ByteArrayInputStream(out.bytes()));
    assertEquals(
        "LZW code " + code + " is not defined",
        assertThrows(IOException.class, in::read).getMessage());
    BitWriter later = new BitWriter();
    later.write(256, 9);
    later.write('a', 9);
    later.write('b', 9);
    later.write(260, 9); // 258 is "ab", 259 would be new
    LzwInputStream second = new LzwInputStream(new ByteArrayInputStream(later.bytes()));
    assertThrows(IOException.class, () -> second.readNBytes(9));
  }

  private byte[] packBits(byte[] data) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    for (int n = 0; n < data.length; ) {
      int run = 1;
      while (n + run < data.length && run < 128 && data[n + run] == data[n]) {
        run++;
      }
      if (random.nextInt(10) == 0) {
        out.write(128); // no operation
      }
      if (run > 1) {
        out.write(257 - run);
        out.write(data[n]);
        n += run;
      } else {
        int literals = Math.min(data.length - n, 1 + random.nextInt(128));
        out.write(literals - 1);
        out.write(data, n, literals);
        n += literals;
      }
    }
    return out.toByteArray();
  }

  @ParameterizedTest
  @CsvSource({"0, 4", "1, 4", "5000, 2", "5000, 256"})
  void whatPackBitsEncodedIsDecoded(int count, int kinds) throws IOException {
    byte[] data = bytes(count, kinds);
    assertArrayEquals(
        data,
        read(new PackBitsInputStream(new ByteArrayInputStream(packBits(data)))),
        "seed=" + SEED);
  }

  @Test
  void anIncompleteRunIsRefused() {
    for (byte[] cut : new byte[][] {{5, 1, 2}, {-3}}) {
      PackBitsInputStream in = new PackBitsInputStream(new ByteArrayInputStream(cut));
      assertEquals(
          "a PackBits run is incomplete",
          assertThrows(EOFException.class, () -> in.readNBytes(9)).getMessage());
    }
  }

  private static HexInputStream hex(String text) {
    return new HexInputStream(new ByteArrayInputStream(text.getBytes(StandardCharsets.US_ASCII)));
  }

  @Test
  void hexadecimalDigitsMayBeDividedAnywhere() throws IOException {
    byte[] data = bytes(300, 256);
    StringBuilder text = new StringBuilder();
    for (byte b : data) {
      for (char digit : String.format("%02x", b & 0xff).toCharArray()) {
        text.append(random.nextBoolean() ? Character.toUpperCase(digit) : digit);
        text.append(" \n\r\t".substring(0, random.nextInt(4) == 0 ? 1 + random.nextInt(4) : 0));
      }
    }
    assertArrayEquals(data, read(hex(text.toString())), "seed=" + SEED);
  }

  @Test
  void whatIsNotHexadecimalIsRefused() {
    assertEquals(
        "a character is no hexadecimal digit",
        assertThrows(IOException.class, () -> hex("0g").read()).getMessage());
    assertEquals(
        "the last byte has a single hexadecimal digit",
        assertThrows(IOException.class, () -> hex("ab c").readNBytes(9)).getMessage());
  }
}
