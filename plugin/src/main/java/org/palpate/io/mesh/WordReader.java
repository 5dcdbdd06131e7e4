package org.palpate.io.mesh;

import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import org.palpate.io.file.NumberParser;
import org.palpate.io.volume.VolumeFormatException;

/**
 * Reads words that are separated by white space, and counts lines for messages. One thread.
 *
 * <p>{@link #hasWordInLine}, {@link #word} and {@link #nextLine} together read line by line, and
 * skip comments, which begin with {@code #}. {@link #wordOrNull} reads across line ends and does
 * not recognize comments.
 */
final class WordReader {
  private static final int LONGEST_WORD = 4096;

  private final InputStream in;
  private final Path file;
  private final byte[] word = new byte[LONGEST_WORD];
  private int next;
  private int line = 1;

  WordReader(InputStream in, Path file) throws IOException {
    this.in = in;
    this.file = file;
    next = in.read();
  }

  /** Returns the number of the line, from 1. */
  int line() {
    return line;
  }

  private void advance() throws IOException {
    if (next == '\n') {
      line++;
    }
    next = in.read();
  }

  private boolean isAtBlank() {
    return next == ' ' || next == '\t' || next == '\r';
  }

  /**
   * Whether another word follows on this line, before its end or a {@code #}. Skips blanks, and
   * line ends after a backslash.
   */
  boolean hasWordInLine() throws IOException {
    while (isAtBlank() || next == '\\') {
      boolean isContinued = next == '\\';
      advance();
      if (isContinued) {
        while (isAtBlank()) {
          advance();
        }
        if (next == '\n') {
          advance();
        }
      }
    }
    return next >= 0 && next != '\n' && next != '#';
  }

  /** Goes to the next line; false at the end of the file. */
  boolean nextLine() throws IOException {
    while (next >= 0 && next != '\n') {
      advance();
    }
    if (next >= 0) {
      advance();
    }
    return next >= 0;
  }

  /** Returns the next word of the file, or null at its end. */
  String wordOrNull() throws IOException {
    while (isAtBlank() || next == '\n') {
      advance();
    }
    return next < 0 ? null : word();
  }

  /**
   * Returns the next word.
   *
   * @throws EOFException if the file has ended
   */
  String word() throws IOException {
    while (isAtBlank() || next == '\n') {
      advance();
    }
    if (next < 0) {
      throw new EOFException("the file ends");
    }
    int length = 0;
    while (next >= 0 && !isAtBlank() && next != '\n') {
      if (length == LONGEST_WORD) {
        throw refusal("a word is longer than " + LONGEST_WORD + " letters");
      }
      word[length++] = (byte) next;
      advance();
    }
    return new String(word, 0, length, StandardCharsets.ISO_8859_1);
  }

  /** Returns the next word as a finite number. */
  double number() throws IOException {
    String text = word();
    double value = NumberParser.number(text);
    if (!Double.isFinite(value)) {
      throw refusal("'" + text + "' is no finite number");
    }
    return value;
  }

  /** Returns the exception for something wrong in the present line. */
  VolumeFormatException refusal(String what) {
    return new VolumeFormatException(
        "line " + line + ": " + what, file, "export the mesh again; this file is damaged");
  }
}
