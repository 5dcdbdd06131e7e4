package org.palpate.io.table;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.MalformedInputException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/**
 * Reads a table of comma-separated lines: a header, then rows. Words may be quoted as in RFC 4180,
 * without line ends. Empty lines and lines that start with # are skipped. One thread.
 */
final class CsvLines {
  private final Path file;
  private long lineNumber;

  /** Receives the lines of a table in order. */
  interface Rows {
    /** Receives the names of the columns. */
    void header(List<String> names) throws CsvFormatException;

    /** Receives the words of a row. */
    void row(String[] words) throws CsvFormatException;
  }

  CsvLines(Path file) {
    this.file = file;
  }

  /**
   * Reads the file to its end.
   *
   * @param columns the columns that the table must have, for messages
   * @return the number of rows
   * @throws CsvFormatException if the file is missing or no text, or if {@code rows} throws it
   */
  long read(String columns, Rows rows) throws IOException {
    String remedy = "give a table with " + columns;
    if (Files.isDirectory(file)) {
      throw new CsvFormatException("the path is a folder", file, remedy);
    }
    try (BufferedReader reader = Files.newBufferedReader(file, StandardCharsets.UTF_8)) {
      return read(reader, rows);
    } catch (NoSuchFileException e) {
      throw new CsvFormatException("no such file", file, "check the path");
    } catch (MalformedInputException e) {
      throw new CsvFormatException("the file is no text", file, remedy);
    } catch (FileSystemException e) {
      throw new CsvFormatException("the file cannot be read", file, "check that you may read it");
    }
  }

  private long read(BufferedReader reader, Rows rows) throws IOException {
    long count = -1;
    for (String line = reader.readLine(); line != null; line = reader.readLine()) {
      lineNumber++;
      if (line.isBlank() || line.startsWith("#")) {
        continue;
      }
      if (count++ < 0) {
        rows.header(Arrays.stream(words(line.replace("\ufeff", ""))).map(String::strip).toList());
      } else {
        rows.row(words(line));
      }
    }
    return Math.max(0, count);
  }

  /** Splits a line at the commas outside quotes, as RFC 4180 does. */
  private static String[] words(String line) {
    return line.indexOf('"') < 0 ? line.split(",", -1) : quotedWords(line);
  }

  private static String[] quotedWords(String line) {
    List<String> words = new ArrayList<>();
    StringBuilder word = new StringBuilder();
    boolean quoted = false;
    for (int n = 0; n < line.length(); n++) {
      char c = line.charAt(n);
      if (c == '"' && quoted && n + 1 < line.length() && line.charAt(n + 1) == '"') {
        word.append(c);
        n++;
      } else if (c == '"') {
        quoted = !quoted;
      } else if (c == ',' && !quoted) {
        words.add(word.toString());
        word.setLength(0);
      } else {
        word.append(c);
      }
    }
    words.add(word.toString());
    return words.toArray(new String[0]);
  }

  /**
   * Returns the index of each column that the table must have.
   *
   * @throws CsvFormatException if one is missing
   */
  int[] neededColumns(List<String> header, List<String> needed) throws CsvFormatException {
    int[] found = columns(header, needed);
    for (int n = 0; n < found.length; n++) {
      if (found[n] < 0) {
        throw fault(
            "there is no column " + needed.get(n), "begin with " + String.join(",", needed));
      }
    }
    return found;
  }

  /** Returns the index of each column that is wanted, -1 for one that is missing. */
  static int[] columns(List<String> header, List<String> wanted) {
    return wanted.stream().mapToInt(header::indexOf).toArray();
  }

  /** Returns the word of a column of the present row; empty if the row is too short. */
  static String word(String[] words, int column) {
    return column < words.length ? words[column].strip() : "";
  }

  /** Returns the fault of the present line. */
  CsvFormatException fault(String what, String remedy) {
    return new CsvFormatException(what, file, lineNumber, remedy);
  }

  /** Returns a number, which may be NaN or infinite. */
  double number(String word, String name) throws CsvFormatException {
    try {
      return switch (word.toLowerCase(Locale.ROOT)) {
        case "nan", "+nan", "-nan" -> Double.NaN;
        case "inf", "+inf", "+infinity", "infinity" -> Double.POSITIVE_INFINITY;
        case "-inf", "-infinity" -> Double.NEGATIVE_INFINITY;
        default -> Double.parseDouble(word);
      };
    } catch (NumberFormatException e) {
      String what = word.isEmpty() ? name + " is missing" : name + " is no number: " + word;
      throw fault(what, "write numbers with a dot");
    }
  }
}
