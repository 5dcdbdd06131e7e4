package org.palpate.io.table;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import org.palpate.io.file.NumberText;

/**
 * Writes the rows of a table in UTF-8, with commas between cells and line feeds after rows. For one
 * thread.
 */
public final class CsvWriter {
  private final OutputStream stream;
  private final StringBuilder row = new StringBuilder();
  private boolean hasCell;

  /** Writes the header line into a stream that the caller closes. */
  public CsvWriter(OutputStream stream, String header) throws IOException {
    this.stream = stream;
    row.append(header);
    end();
  }

  /** Appends an integer to the row. */
  public CsvWriter cell(long value) {
    part();
    row.append(value);
    return this;
  }

  /** Appends the shortest decimal that reads back as the same double. */
  public CsvWriter cell(double value) {
    part();
    row.append(NumberText.text(value));
    return this;
  }

  /**
   * Appends a text, in quotes if a comma, a quote or a line end would break the row, or if it would
   * begin a comment.
   */
  public CsvWriter cell(String text) {
    part();
    row.append(quoted(text));
    return this;
  }

  private void part() {
    if (hasCell) {
      row.append(',');
    }
    hasCell = true;
  }

  /** Ends the row. */
  public void end() throws IOException {
    row.append('\n');
    stream.write(row.toString().getBytes(StandardCharsets.UTF_8));
    row.setLength(0);
    hasCell = false;
  }

  /** Quotes a cell as RFC 4180 does, only if it would break the row or begin a comment. */
  static String quoted(String text) {
    boolean plain = text.chars().noneMatch(c -> c == ',' || c == '"' || c == '\n' || c == '\r');
    return plain && !text.startsWith("#") ? text : "\"" + text.replace("\"", "\"\"") + "\"";
  }
}
