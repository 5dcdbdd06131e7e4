package org.palpate.io.table;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.MalformedInputException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/**
 * Reads a table of comma-separated lines: a header, then rows. Empty lines and lines that start
 * with # are skipped. One thread.
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
        rows.header(
            Arrays.stream(line.replace("\ufeff", "").split(",", -1)).map(String::strip).toList());
      } else {
        rows.row(line.split(",", -1));
      }
    }
    return Math.max(0, count);
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
