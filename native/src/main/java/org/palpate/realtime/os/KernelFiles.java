package org.palpate.realtime.os;

import java.io.FileInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.stream.Stream;

/** Reads the small text files through which a kernel reports its state. Not for a frame's path. */
final class KernelFiles {
  private static final int MAX_BYTES = 1 << 20;

  private KernelFiles() {}

  /** Returns the first line; empty if the file does not exist or cannot be read. */
  static Optional<String> line(Path file) {
    return lines(file).findFirst();
  }

  /** Returns the first line as a number; empty if it is not a number. */
  static OptionalLong number(Path file) {
    return line(file)
        .map(String::trim)
        .filter(text -> text.matches("-?\\d{1,18}"))
        .map(text -> OptionalLong.of(Long.parseLong(text)))
        .orElseGet(OptionalLong::empty);
  }

  /** Returns the text after {@code name:} on its line. */
  static Optional<String> field(Path file, String name) {
    return lines(file)
        .filter(line -> line.startsWith(name + ":"))
        .map(line -> line.substring(name.length() + 1).trim())
        .findFirst();
  }

  /** Returns all lines; none if the file cannot be read. */
  static Stream<String> lines(Path file) {
    // These files report a size of 0, and some give their content only to one large first read.
    // Files.readString first asks for a single byte and then gets no more.
    try (InputStream stream = new FileInputStream(file.toFile())) {
      return new String(stream.readNBytes(MAX_BYTES), StandardCharsets.UTF_8).lines();
    } catch (IOException e) {
      return Stream.empty();
    }
  }
}
