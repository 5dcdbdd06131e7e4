package org.palpate.io.table;

import java.io.IOException;
import java.nio.file.Path;

/**
 * Reports a table that cannot be read. The message is one line, {@code WHAT: WHERE: what to do}.
 */
public final class CsvFormatException extends IOException {
  private static final long serialVersionUID = 1L;

  CsvFormatException(String what, Path file, String remedy) {
    super(what + ": " + file + ": " + remedy);
  }

  CsvFormatException(String what, Path file, long line, String remedy) {
    super(what + ": " + file + " line " + line + ": " + remedy);
  }
}
