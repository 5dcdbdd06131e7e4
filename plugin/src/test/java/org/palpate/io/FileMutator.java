package org.palpate.io;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Random;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;

/** Damages a file in one to four random ways. */
final class FileMutator {
  private static final Pattern NUMBER = Pattern.compile("-?[0-9]+(\\.[0-9]+)?");
  private static final String[] NASTY_NUMBERS = {
    "0",
    "-1",
    "1",
    "2147483647",
    "2147483648",
    "4294967296",
    "9223372036854775807",
    "NaN",
    "inf",
    "1e308",
    "-1e-308",
    "65536",
    "99999",
    "",
    "x"
  };
  private static final byte[] NASTY_BYTES = {0, 1, -1, 127, -128, 'N', '\n', ' '};
  private static final int HEADER_BYTES = 800;

  private FileMutator() {}

  static byte[] spoil(byte[] file, Random random) {
    byte[] spoiled = file.clone();
    for (int times = 1 + random.nextInt(4); times > 0 && spoiled.length > 0; times--) {
      spoiled =
          switch (random.nextInt(7)) {
            case 0 -> flipBit(spoiled, random);
            case 1 -> setBytes(spoiled, random);
            case 2 -> Arrays.copyOf(spoiled, random.nextInt(spoiled.length));
            case 3 -> replaceNumber(spoiled, random);
            case 4 -> repeatPart(spoiled, random);
            case 5 -> removePart(spoiled, random);
            default -> setWord(spoiled, random);
          };
    }
    return spoiled;
  }

  /** Returns a random offset, mostly in the header. */
  private static int offset(byte[] file, Random random) {
    int end = random.nextInt(4) == 0 ? file.length : Math.min(HEADER_BYTES, file.length);
    return random.nextInt(end);
  }

  private static byte[] flipBit(byte[] file, Random random) {
    file[offset(file, random)] ^= (byte) (1 << random.nextInt(8));
    return file;
  }

  private static byte[] setBytes(byte[] file, Random random) {
    int at = offset(file, random);
    byte value = NASTY_BYTES[random.nextInt(NASTY_BYTES.length)];
    Arrays.fill(file, at, Math.min(file.length, at + 1 + random.nextInt(8)), value);
    return file;
  }

  /** Sets a length, a count or an offset in either byte order. */
  private static byte[] setWord(byte[] file, Random random) {
    int at = offset(file, random) & ~1;
    int[] words = {0, 1, 255, 4096, 65535, Integer.MAX_VALUE, -1, file.length, 1 << 24};
    int word = words[random.nextInt(words.length)];
    boolean big = random.nextBoolean();
    int bytes = random.nextBoolean() ? 4 : 2;
    for (int n = 0; n < bytes && at + n < file.length; n++) {
      file[at + n] = (byte) (word >> (8 * (big ? bytes - 1 - n : n)));
    }
    return file;
  }

  private static byte[] replaceNumber(byte[] file, Random random) {
    String text = new String(file, StandardCharsets.ISO_8859_1);
    String header = text.substring(0, Math.min(HEADER_BYTES, text.length()));
    MatchResult[] numbers = NUMBER.matcher(header).results().toArray(MatchResult[]::new);
    if (numbers.length == 0) {
      return file;
    }
    MatchResult number = numbers[random.nextInt(numbers.length)];
    String nasty = NASTY_NUMBERS[random.nextInt(NASTY_NUMBERS.length)];
    return (text.substring(0, number.start()) + nasty + text.substring(number.end()))
        .getBytes(StandardCharsets.ISO_8859_1);
  }

  private static byte[] repeatPart(byte[] file, Random random) {
    int from = offset(file, random);
    int to = Math.min(file.length, from + 1 + random.nextInt(64));
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    bytes.write(file, 0, to);
    bytes.write(file, from, file.length - from);
    return bytes.toByteArray();
  }

  private static byte[] removePart(byte[] file, Random random) {
    int from = offset(file, random);
    int to = Math.min(file.length, from + 1 + random.nextInt(64));
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    bytes.write(file, 0, from);
    bytes.write(file, to, file.length - to);
    return bytes.toByteArray();
  }
}
