package org.palpate.benchmarks.speed;

import static org.junit.jupiter.api.Assertions.assertEquals;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonToken;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.palpate.benchmarks.report.MachineSummary;

class SpeedRunTest {
  /** Maven runs the tests in the folder of the module. */
  private static final Path PAGE =
      Path.of(Files.exists(Path.of("docs")) ? "." : "..", "docs", "results", "columns.md");

  @Test
  void everyKeyOfTheJsonFileIsExplained(@TempDir Path folder) throws IOException {
    Path file = folder.resolve("speed.json");
    SpeedRow row = new SpeedRow("response", "run", Map.of(), "ns/op", List.of(1.0, 2.0), 0);
    SpeedRun.writeJson(file, MachineSummary.facts(), List.of(row));
    assertEquals(explained(), keys(file));
  }

  private static Set<String> keys(Path file) throws IOException {
    Set<String> keys = new TreeSet<>();
    try (JsonParser parser = new JsonFactory().createParser(file.toFile())) {
      while (parser.nextToken() != null) {
        if (parser.currentToken() == JsonToken.FIELD_NAME) {
          boolean isInRow = parser.getParsingContext().getParent().inArray();
          keys.add((isInRow ? "rows." : "") + parser.currentName());
        }
      }
    }
    keys.remove("rows");
    return keys;
  }

  private static Set<String> explained() throws IOException {
    String page = Files.readString(PAGE);
    int begin = page.indexOf("\n## `speed.json`");
    String section = page.substring(begin, page.indexOf("\n## ", begin + 1));
    Set<String> keys = new TreeSet<>();
    section
        .lines()
        .filter(line -> line.startsWith("| `"))
        .map(line -> line.substring(0, line.indexOf('|', 1)))
        .flatMap(cell -> Pattern.compile("`([^`]+)`").matcher(cell).results())
        .map((MatchResult match) -> match.group(1))
        .forEach(keys::add);
    return keys;
  }
}
