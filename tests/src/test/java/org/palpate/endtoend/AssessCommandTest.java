package org.palpate.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The assessment of a session, live and replayed. */
class AssessCommandTest {
  private static final List<String> FILES =
      List.of(
          "assessment.html",
          "assessment.json",
          "course.csv",
          "holds.csv",
          "segments.csv",
          "tremor.csv");

  @TempDir Path folder;

  private static double value(Path training, String key) throws IOException {
    return FlatJson.number(training.resolve("assessment.json"), key);
  }

  private static void run(Object... arguments) {
    CommandRun.of(arguments).mustSucceed();
  }

  /** Writes a hand that waits, presses 2 mm into the ball of {@code sphere:32}, and goes back. */
  private Path pressing() throws IOException {
    StringBuilder rows = new StringBuilder("t_ms,x,y,z\n");
    for (int n = 0; n <= 12_000; n++) {
      double down = Math.min(Math.max(0, n - 4000), 400) * 0.03;
      double up = Math.min(Math.max(0, n - 8400), 400) * 0.03;
      rows.append(n).append(",16,16,").append(34 - down + up).append('\n');
    }
    return Files.writeString(folder.resolve("Doe^John.csv"), rows.toString());
  }

  @ParameterizedTest
  @ValueSource(strings = {"point", "sphere:1"})
  void aPressIsAssessedAsItWas(String tool) throws IOException {
    Path training = folder.resolve("new/training");
    Path report = folder.resolve("r.json");
    List<Object> replay = new ArrayList<>(List.of("replay", "--phantom", "sphere:32"));
    replay.addAll(List.of("--trajectory", pressing(), "--tool", tool));
    replay.addAll(List.of("--stiffness", 0.5, "--assess", training, "--report", report));
    replay.addAll(List.of("--protect", "sphere:0"));
    run(replay.toArray());
    assertEquals(12, value(training, "seconds"), 1e-9);
    assertEquals(12_001, value(training, "frames"));
    assertEquals(0, value(training, "lost_frames"));
    assertEquals(24, value(training, "hand_path_mm"), 0.2);
    double largest = FlatJson.number(report, "max_force_n");
    assertTrue(largest > 0.5, "it presses");
    assertEquals(largest, value(training, "max_force_n"), 1e-9 * largest);
    String[] row = Files.readAllLines(training.resolve("segments.csv")).get(1).split(",", -1);
    assertEquals("sphere", row[0]);
    assertEquals("1", row[1], "protected");
    assertEquals("1", row[2], "one contact");
    assertEquals(4.3, Double.parseDouble(row[3]), 0.3, "seconds in contact");
    assertEquals(largest, Double.parseDouble(row[5]), 1e-9 * largest);
    assertTrue(Files.readString(training.resolve("assessment.json")).contains("\"nearest_mm\""));
  }

  private static String limited(Path training) throws IOException {
    return FlatJson.read(training.resolve("assessment.json")).get("/force_limited");
  }

  @Test
  void aReplayWithALargestForceIsLimitedAndReplacesAnEarlierAssessment() throws IOException {
    Path training = folder.resolve("training");
    for (String[] limit : new String[][] {{}, {"--max-force", "0.5"}}) {
      List<Object> replay = new ArrayList<>(List.of("replay", "--phantom", "sphere:32"));
      replay.addAll(List.of("--trajectory", pressing(), "--assess", training, "--stiffness", 0.5));
      replay.addAll(List.of(limit));
      run(replay.toArray());
      assertEquals(limit.length == 0 ? "false" : "true", limited(training));
      assertEquals(limit.length == 0, value(training, "max_force_n") > 0.5);
    }
  }

  @Test
  void aRecordedSessionIsAssessedAsItsReplayIs() throws IOException {
    Path live = folder.resolve("live");
    Path record = folder.resolve("t.csv");
    Object[] touch = {
      "touch",
      "--phantom",
      "sphere:32",
      "--headless",
      "--seconds",
      6,
      "--assess",
      live,
      "--record",
      record,
      "--solver",
      "guarded"
    };
    run(touch);
    Path again = folder.resolve("again");
    Object[] replay = {
      "replay",
      "--phantom",
      "sphere:32",
      "--trajectory",
      record,
      "--assess",
      again,
      "--solver",
      "guarded"
    };
    run(replay);
    assertEquals(value(live, "frames"), value(again, "frames"));
    assertEquals(value(live, "tool_path_mm"), value(again, "tool_path_mm"), 1e-6);
    assertEquals(value(live, "hand_path_mm"), value(again, "hand_path_mm"), 1e-6);
    assertEquals(value(live, "contacts"), value(again, "contacts"));
    assertEquals("true", limited(live));
    assertEquals("false", limited(again));
    String page = Files.readString(again.resolve("assessment.html"));
    assertTrue(page.contains("Forces have no limit, because a replay knows no device"), page);
    assertFalse(Files.readString(live.resolve("assessment.html")).contains("have no limit"));
    assertEquals(value(live, "rms_mm"), value(again, "rms_mm"), 1e-9);
    for (String table : List.of("segments.csv", "tremor.csv", "course.csv")) {
      int rows = Files.readAllLines(live.resolve(table)).size();
      assertEquals(rows, Files.readAllLines(again.resolve(table)).size(), table);
      assertTrue(rows > 1, table);
    }
  }

  /** A page that an XML parser reads is whole, and what is in it is no markup. */
  @Test
  void thePageIsWholeAndRefersToNothingAndNamesNoFile() throws Exception {
    Path training = folder.resolve("t");
    Path trajectory = pressing();
    Path grey = folder.resolve("Doe^John.nrrd");
    run("info", "--phantom", "sphere:32", "--export", grey);
    Object[] replay = {
      "replay",
      "--volume",
      grey,
      "--segment",
      "<b>&\"bone\"=nonzero",
      "--protect",
      "<b>&\"bone\":1",
      "--trajectory",
      trajectory,
      "--assess",
      training
    };
    run(replay);
    String page = Files.readString(training.resolve("assessment.html"));
    assertFalse(page.contains("http") || page.contains("src=") || page.contains("url("), page);
    assertFalse(page.contains("<b>"), "a name is no markup");
    assertTrue(page.contains("&lt;b&gt;&amp;&quot;bone&quot;"), page);
    assertTrue(page.contains("Forbidden contact"), page);
    String xml = page.replace("<!DOCTYPE html>", "").replace("<meta charset=\"utf-8\">", "");
    Path parsed = Files.writeString(folder.resolve("page.xml"), xml);
    int plots =
        DocumentBuilderFactory.newInstance()
            .newDocumentBuilder()
            .parse(parsed.toFile())
            .getElementsByTagName("svg")
            .getLength();
    assertEquals(5, plots, "force, three projections and the spectrum");
    for (String file : FILES) {
      assertFalse(Files.readString(training.resolve(file)).contains("Doe"), file);
    }
  }

  @Test
  void aCutIsPartOfTheAssessment() throws IOException {
    Path training = folder.resolve("t");
    Object[] replay = {
      "replay",
      "--phantom",
      "sphere:32",
      "--trajectory",
      pressing(),
      "--carve",
      40,
      "--assess",
      training
    };
    run(replay);
    assertTrue(value(training, "sphere") > 0, "removed volume");
    assertTrue(Files.readString(training.resolve("assessment.html")).contains("carved sphere"));
  }

  @Test
  void aFolderThatIsAFileOrHoldsAnInputIsRefused() throws IOException {
    Path file = Files.writeString(folder.resolve("file"), "text");
    Path input = Files.copy(pressing(), folder.resolve("course.csv"));
    for (Path wrong : List.of(file, folder)) {
      Object[] replay = {
        "replay", "--phantom", "sphere:32", "--trajectory", input, "--assess", wrong
      };
      String said = CommandRun.of(replay).mustRefuse();
      assertTrue(said.contains("--assess"), said);
    }
    Object[] same = {
      "touch",
      "--headless",
      "--seconds",
      1,
      "--assess",
      folder,
      "--report",
      folder.resolve("assessment.json")
    };
    CommandRun.of(same).mustRefuse();
  }
}
