package org.palpate.benchmarks.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Function;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class TableFileTest {
  private static final List<String> COLUMNS = List.of("way", "count", "time_us");

  @TempDir private Path folder;

  @Test
  void numbersAreExactAndTextsHaveQuotesOnlyIfNeeded() throws IOException {
    Path file = folder.resolve("table.csv");
    List<List<Object>> rows =
        List.of(
            List.of("wait-free", 3, 0.1 + 0.2),
            List.of("paper, \"2013\"", 1L << 60, Double.POSITIVE_INFINITY),
            List.of("", -1, ""));
    TableFile.write(file, COLUMNS, rows, Function.identity());
    assertEquals(
        """
        way,count,time_us
        wait-free,3,0.30000000000000004
        "paper, ""2013""\",1152921504606846976,Infinity
        ,-1,
        """,
        Files.readString(file));
  }

  @Test
  void aRowWithAnotherNumberOfCellsLeavesTheFileAsItWas() throws IOException {
    Path file = folder.resolve("table.csv");
    Files.writeString(file, "earlier");
    List<List<Object>> rows = List.of(List.of("wait-free", 3));
    IllegalArgumentException refused =
        assertThrows(
            IllegalArgumentException.class,
            () -> TableFile.write(file, COLUMNS, rows, Function.identity()));
    assertEquals(file + ": a row has 2 cells for 3 columns", refused.getMessage());
    assertEquals("earlier", Files.readString(file));
  }
}
