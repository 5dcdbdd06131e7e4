package org.palpate.io.table;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import org.palpate.io.file.NumberText;

/** Rows of a table: cells parted by commas, lines by a line feed. One thread. */
final class CsvWriter {
  private final OutputStream stream;
  private final StringBuilder row = new StringBuilder();

  /** Rows after a header line, into a stream that the caller closes. */
  CsvWriter(OutputStream stream, String header) throws IOException {
    this.stream = stream;
    row.append(header);
    end();
  }

  CsvWriter cell(long value) {
    part();
    row.append(value);
    return this;
  }

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

  void end() throws IOException {
    row.append('\n');
    stream.write(row.toString().getBytes(StandardCharsets.US_ASCII));
    row.setLength(0);
  }
}
