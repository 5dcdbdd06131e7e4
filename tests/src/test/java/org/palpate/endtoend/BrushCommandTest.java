package org.palpate.endtoend;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Paints with the command touch, and replays what was painted. */
class BrushCommandTest {
  @TempDir Path folder;

  @ParameterizedTest
  @CsvSource({"point,2,add", "point,2,erase", "sphere:2,tool,add", "sphere:2,2.5,erase"})
  void aSessionThatPaintsReplaysToTheSameVoxels(String tool, String brush, String paint)
      throws IOException {
    Path recording = folder.resolve("t.csv");
    Path live = folder.resolve("live.nrrd");
    Path again = folder.resolve("again.nrrd");
    Path report = folder.resolve("r.json");
    List<Object> touch = new ArrayList<>(List.of("touch", "--phantom", "sphere:32", "--headless"));
    touch.addAll(List.of("--tool", tool, "--brush", brush, "--paint", paint, "--seconds", 2));
    touch.addAll(List.of("--record", recording, "--export", live, "--report", report));
    CommandRun.of(touch.toArray()).mustSucceed();
    double carved = mm3("carved", report);
    double added = mm3("added", report);
    assertTrue((paint.equals("add") ? added : carved) > 3, "added " + added + " carved " + carved);
    assertEquals(0, paint.equals("add") ? carved : added);

    List<Object> replay = new ArrayList<>(List.of("replay", "--phantom", "sphere:32"));
    replay.addAll(List.of("--tool", tool, "--trajectory", recording));
    replay.addAll(List.of("--edits", folder.resolve("t.edits.csv")));
    replay.addAll(List.of("--export", again, "--report", report));
    CommandRun.of(replay.toArray()).mustSucceed();
    assertArrayEquals(Files.readAllBytes(live), Files.readAllBytes(again));
    assertEquals(carved, mm3("carved", report));
    assertEquals(added, mm3("added", report));
  }

  @Test
  void noVoxelOutsideTheRangeIsPainted() throws IOException {
    Path report = folder.resolve("r.json");
    List<Object> touch = new ArrayList<>(List.of("touch", "--phantom", "sphere:32:grey"));
    touch.addAll(List.of("--segment", "sphere=>=500", "--headless", "--seconds", 1));
    touch.addAll(List.of("--brush", "3,range:>=100000", "--paint", "add", "--report", report));
    CommandRun.of(touch.toArray()).mustSucceed();
    assertEquals(0, mm3("added", report));
  }

  private static double mm3(String key, Path report) throws IOException {
    return FlatJson.number(report, key + "/sphere");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = ';',
      value = {
        "--paint add;painting needs a brush",
        "--brush tool;a point has no shape",
        "--brush 0;the brush cannot be read",
        "--brush NaN;the brush cannot be read",
        "--brush 3,refuses;the brush cannot be read",
        "--brush 3,range:a..b;the brush cannot be read",
        "--brush 3,segment:nose;the brush cannot be read",
        "--brush 3 --phantom fracture:64:2;a brush is for the segments of one volume",
        "--brush tool --tool sphere:3 --points 20;an open or thinned tool has no shape"
      })
  void aBrushThatCannotBeIsRefusedInOneLine(String options, String message) {
    List<Object> touch = new ArrayList<>(List.of("touch", "--headless", "--seconds", 1));
    if (!options.contains("--phantom")) {
      touch.addAll(List.of("--phantom", "sphere:32"));
    }
    touch.addAll(List.of((Object[]) options.split(" ")));
    String line = CommandRun.of(touch.toArray()).mustRefuse();
    assertTrue(
        line.startsWith("palpate: " + message + ": --brush")
            || line.startsWith("palpate: " + message + ": --paint"),
        line);
  }
}
