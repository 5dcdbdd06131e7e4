package org.palpate.benchmarks.stress;

import java.io.IOException;
import java.io.Reader;
import java.io.Writer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Properties;

/** The totals of a run, kept in a file so that it can continue. One thread. */
public final class StressTotals {
  long cases;
  long frames;
  long legs;
  long exactDecisions;

  /** Returns the number of cases. */
  public long cases() {
    return cases;
  }

  /** Returns the number of frames. */
  public long frames() {
    return frames;
  }

  /** Returns the number of legs. */
  public long legs() {
    return legs;
  }

  /** Returns how often the judge could not decide in doubles. */
  public long exactDecisions() {
    return exactDecisions;
  }

  /** Reads totals; all are zero if the file does not exist. */
  public static StressTotals read(Path file) throws IOException {
    StressTotals totals = new StressTotals();
    if (Files.exists(file)) {
      Properties properties = new Properties();
      try (Reader reader = Files.newBufferedReader(file)) {
        properties.load(reader);
      }
      totals.cases = value(properties, "cases", file);
      totals.frames = value(properties, "frames", file);
      totals.legs = value(properties, "legs", file);
      totals.exactDecisions = value(properties, "exact_decisions", file);
    }
    return totals;
  }

  private static long value(Properties properties, String key, Path file) throws IOException {
    try {
      return Long.parseLong(properties.getProperty(key, ""));
    } catch (NumberFormatException e) {
      throw new IOException("no number under " + key + " in " + file, e);
    }
  }

  /** Writes the totals to a second file and moves it over the first. */
  public void write(Path file) throws IOException {
    Properties properties = new Properties();
    properties.setProperty("cases", Long.toString(cases));
    properties.setProperty("frames", Long.toString(frames));
    properties.setProperty("legs", Long.toString(legs));
    properties.setProperty("exact_decisions", Long.toString(exactDecisions));
    Path part = file.resolveSibling(file.getFileName() + ".part");
    try (Writer writer = Files.newBufferedWriter(part)) {
      properties.store(writer, null);
    }
    Files.move(part, file, StandardCopyOption.REPLACE_EXISTING);
  }
}
