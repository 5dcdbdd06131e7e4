package org.palpate.io.table;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class CsvLinesTest {
  @TempDir private Path folder;

  /** Keeps what a table holds. */
  private static final class Kept implements CsvLines.Rows {
    private final List<String> all = new ArrayList<>();

    @Override
    public void header(List<String> names) {
      all.add("header " + String.join("|", names));
    }

    @Override
    public void row(String[] words) {
      all.add(String.join("|", words));
    }
  }

  private List<String> read(String text) throws IOException {
    Kept kept = new Kept();
    Path file = Files.writeString(folder.resolve("t.csv"), text);
    long count = new CsvLines(file).read("a,b", kept);
    assertEquals(Math.max(0, kept.all.size() - 1), count, "the number of rows");
    return kept.all;
  }

  @Test
  void remarksAndEmptyLinesAreSkippedEverywhere() throws IOException {
    assertEquals(
        List.of("header a|b", "1|2", "3|4"), read("# one\n\n a , b \n1,2\n#two\n   \n3,4\n"));
    assertEquals(List.of(), read("# nothing\n"));
    assertEquals(List.of("header a|b"), read("a,b"));
  }

  @Test
  void everyKindOfLineEndAndAByteOrderMarkAreRead() throws IOException {
    assertEquals(List.of("header a|b", "1|2", "3|4"), read("\ufeffa,b\r\n1,2\r3,4\n"));
  }

  @Test
  void aQuotedWordKeepsItsCommasAndQuotes() throws IOException {
    assertEquals(
        List.of("header a", "x, y|say \"no\"||end", "|"),
        read("a\n\"x, y\",\"say \"\"no\"\"\",\"\",end\n\"\",\n"));
  }

  @Test
  void emptyWordsAtTheEndCount() throws IOException {
    assertEquals(List.of("header a|b|", "1||"), read("a,b,\n1,,\n"));
  }

  @Test
  void aWordBeyondTheEndOfAShortRowIsEmpty() {
    assertEquals("1", CsvLines.word(new String[] {" 1 "}, 0));
    assertEquals("", CsvLines.word(new String[] {" 1 "}, 1));
  }

  @Test
  void whatIsNoTableIsRefusedWithWhatToGive() throws IOException {
    refuses("the path is a folder: %s: give a table with a,b", folder);
    refuses("no such file: %s: check the path", folder.resolve("none.csv"));
    byte[] latin = "gr\u00f6\u00dfe\n".getBytes(StandardCharsets.ISO_8859_1);
    refuses(
        "the file is no text: %s: give a table with a,b",
        Files.write(folder.resolve("latin.csv"), latin));
  }

  private static void refuses(String line, Path file) {
    CsvFormatException refusal =
        assertThrows(CsvFormatException.class, () -> new CsvLines(file).read("a,b", new Kept()));
    assertEquals(String.format(line, file), refusal.getMessage());
  }

  @ParameterizedTest
  @CsvSource({
    "1.5, 1.5",
    "-2e3, -2000",
    "NaN, NaN",
    "-nan, NaN",
    "Inf, Infinity",
    "+infinity, Infinity",
    "-INF, -Infinity"
  })
  void numbersMayBeSpecial(String word, double value) throws IOException {
    assertEquals(value, new CsvLines(folder).number(word, "x"));
  }

  @Test
  void aWordThatIsNoNumberIsShown() {
    CsvLines lines = new CsvLines(Path.of("t.csv"));
    assertEquals(
        "x is no number: 1,5: t.csv line 0: write numbers with a dot",
        assertThrows(CsvFormatException.class, () -> lines.number("1,5", "x")).getMessage());
    assertEquals(
        "x is missing: t.csv line 0: write numbers with a dot",
        assertThrows(CsvFormatException.class, () -> lines.number("", "x")).getMessage());
  }

  @Test
  void numbersAreReadByTheNamesOfTheirColumns() throws IOException {
    Path file = Files.writeString(folder.resolve("n.csv"), "c,a,b\n3,1,2\n6,4,5\n");
    List<double[]> rows = NumbersCsvReader.read(file, List.of("a", "b"));
    assertArrayEquals(new double[] {1, 2}, rows.get(0));
    assertArrayEquals(new double[] {4, 5}, rows.get(1));
    Files.writeString(file, "a,b\n1,nan\n");
    assertEquals(
        "b is nan: " + file + " line 2: correct the row",
        assertThrows(CsvFormatException.class, () -> NumbersCsvReader.read(file, List.of("a", "b")))
            .getMessage());
  }
}
