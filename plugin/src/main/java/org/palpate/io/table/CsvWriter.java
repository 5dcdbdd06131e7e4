package org.palpate.io.table;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import org.palpate.io.file.NumberText;

/**
 * Writes the rows of a table, with commas between cells and line feeds after rows. For one thread.
 */
final class CsvWriter {
  private final OutputStream stream;
  private final StringBuilder row = new StringBuilder();

  /** Writes the header line into a stream that the caller closes. */
  CsvWriter(OutputStream stream, String header) throws IOException {
    this.stream = stream;
    row.append(header);
    end();
  }

  /** Appends an integer to the row. */
  CsvWriter cell(long value) {
    part();
    row.append(value);
    return this;
  }

  /** Appends the shortest decimal that reads back as the same double. */
  CsvWriter cell(double value) {
    part();
    row.append(NumberText.text(value));
    return this;
  }

  private void part() {
    if (row.length() > 0) {
      row.append(',');
    }
  }

  /** Ends the row. */
  void end() throws IOException {
    row.append('\n');
    stream.write(row.toString().getBytes(StandardCharsets.US_ASCII));
    row.setLength(0);
  }
}
