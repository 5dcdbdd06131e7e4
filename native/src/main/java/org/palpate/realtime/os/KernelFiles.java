package org.palpate.realtime.os;

import java.io.FileInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.stream.Stream;

/** Reads the small text files in which a kernel tells about itself. Not for the path of a frame. */
final class KernelFiles {
  private static final int MAX_BYTES = 1 << 20;

  private KernelFiles() {}

  /** The file's first line; empty where there is no such file or it cannot be read. */
  static Optional<String> line(Path file) {
    return lines(file).findFirst();
  }

  /** The file's first line as a number; empty where it is none. */
  static OptionalLong number(Path file) {
    return line(file)
        .map(String::trim)
        .filter(text -> text.matches("-?\\d{1,18}"))
        .map(text -> OptionalLong.of(Long.parseLong(text)))
        .orElseGet(OptionalLong::empty);
  }

  /** What follows {@code name:} in a file of such lines. */
  static Optional<String> field(Path file, String name) {
    return lines(file)
        .filter(line -> line.startsWith(name + ":"))
        .map(line -> line.substring(name.length() + 1).trim())
        .findFirst();
  }

  /** All lines; none where the file cannot be read, as on a system without it. */
  static Stream<String> lines(Path file) {
    // The kernel says its files are empty, and gives some of them whole in the first read or never:
    // Files.readString asks for one byte first, and gets no more.
    try (InputStream stream = new FileInputStream(file.toFile())) {
      return new String(stream.readNBytes(MAX_BYTES), StandardCharsets.UTF_8).lines();
    } catch (IOException e) {
      return Stream.empty();
    }
  }
}
