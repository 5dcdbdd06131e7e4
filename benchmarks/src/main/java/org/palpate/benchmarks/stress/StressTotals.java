package org.palpate.benchmarks.stress;

import java.io.IOException;
import java.io.Reader;
import java.io.Writer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Properties;

/** What a run has done so far, kept in a file so that it can go on. One thread. */
public final class StressTotals {
  long cases;
  long frames;
  long legs;
  long exactDecisions;

  public long cases() {
    return cases;
  }

  public long frames() {
    return frames;
  }

  public long legs() {
    return legs;
  }

  /** How often the judge could not decide in doubles. */
  public long exactDecisions() {
    return exactDecisions;
  }

  /** Reads totals; all zero where there is no such file. */
  public static StressTotals read(Path file) throws IOException {
    StressTotals totals = new StressTotals();
    if (Files.exists(file)) {
      Properties kept = new Properties();
      try (Reader reader = Files.newBufferedReader(file)) {
        kept.load(reader);
      }
      totals.cases = value(kept, "cases", file);
      totals.frames = value(kept, "frames", file);
      totals.legs = value(kept, "legs", file);
      totals.exactDecisions = value(kept, "exact_decisions", file);
    }
    return totals;
  }

  private static long value(Properties kept, String key, Path file) throws IOException {
    try {
      return Long.parseLong(kept.getProperty(key, ""));
    } catch (NumberFormatException e) {
      throw new IOException("no number under " + key + " in " + file, e);
    }
  }

  /** Writes totals beside the file and moves them over it. */
  public void write(Path file) throws IOException {
    Properties kept = new Properties();
    kept.setProperty("cases", Long.toString(cases));
    kept.setProperty("frames", Long.toString(frames));
    kept.setProperty("legs", Long.toString(legs));
    kept.setProperty("exact_decisions", Long.toString(exactDecisions));
    Path beside = file.resolveSibling(file.getFileName() + ".part");
    try (Writer writer = Files.newBufferedWriter(beside)) {
      kept.store(writer, null);
    }
    Files.move(beside, file, StandardCopyOption.REPLACE_EXISTING);
  }
}
