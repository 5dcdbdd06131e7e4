package org.palpate.endtoend;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.raycast.Ray;
import org.palpate.testing.ExactOracle;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.phantom.Phantom;

/** Replays and live sessions with elastic segments: option {@code --elastic}. */
class ElasticCommandTest {
  @TempDir private Path folder;

  private Path file(String name) {
    return folder.resolve(name);
  }

  /** Presses the block, slides over its top and beyond its edge, and comes back. */
  @BeforeEach
  void writeTrajectory() throws IOException {
    StringBuilder device = new StringBuilder("t_ms,x,y,z\n");
    for (int n = 0; n < 900; n++) {
      double z = n < 300 ? 52 - 0.04 * n : 40 + 2 * Math.sin(0.02 * n);
      double x = 32.3 + (n < 300 ? 0 : 26 * Math.sin(0.01 * (n - 300)));
      device.append(n).append(',').append(x).append(",30.4,").append(z).append('\n');
    }
    Files.writeString(file("t.csv"), device);
  }

  private CommandRun replay(String suffix, Object... further) {
    List<Object> args =
        new ArrayList<>(
            List.of("replay", "--phantom", "block:64", "--trajectory", file("t.csv"), "--out"));
    args.addAll(List.of(file("f" + suffix), "--legs", file("l" + suffix), "--report"));
    args.add(file("r" + suffix));
    args.addAll(List.of(further));
    return CommandRun.of(args.toArray());
  }

  private CommandRun elastic(String suffix, Object... further) {
    List<Object> args =
        new ArrayList<>(
            List.of("--elastic", "block=young:20e3", "--fixed", "base", "--lattice", 8));
    args.addAll(List.of(further));
    return replay(suffix, args.toArray());
  }

  @ParameterizedTest
  @ValueSource(strings = {"smooth", "guarded"})
  void noLegInMaterialCoordinatesTouchesAVoxel(String solver) throws IOException {
    elastic("", "--solver", solver).mustSucceed();
    SegmentedVolume volume = Phantom.parse("block:64").segments();
    double[] end = null;
    int legs = 0;
    for (String line : Files.readAllLines(file("l")).subList(1, legsOf(file("l")))) {
      double[] row =
          List.of(line.split(",", -1)).stream().mapToDouble(Double::parseDouble).toArray();
      Ray ray = new Ray().from(row[2], row[3], row[4]).to(row[5], row[6], row[7]);
      for (Segment segment : volume.segments()) {
        assertTrue(!ExactOracle.touchesAny(segment.bits(), ray), line);
      }
      if (end != null && row[1] >= 0) {
        assertArrayEquals(end, new double[] {row[2], row[3], row[4]}, line);
      }
      end = new double[] {row[5], row[6], row[7]};
      legs++;
    }
    assertTrue(legs > 500, "legs " + legs);
    Map<String, String> report = FlatJson.read(file("r"));
    assertEquals("27", report.get("/elastic/updates"));
    assertEquals("0", report.get("/elastic/refused"));
    assertTrue(Integer.parseInt(report.get("/contact_frames")) > 400, report.toString());
  }

  private static int legsOf(Path file) throws IOException {
    return Files.readAllLines(file).size();
  }

  @Test
  void theBlockGivesWay() throws IOException {
    elastic("soft").mustSucceed();
    replay("hard").mustSucceed();
    double soft = height(file("fsoft"), 299);
    double hard = height(file("fhard"), 299);
    // The hand is at 40.04, 3.96 mm below the top; the rigid point stays above the top at 44.
    assertTrue(hard > 44 && soft < hard - 0.5 && soft > 40.04, soft + " and " + hard);
  }

  private static double height(Path frames, int frame) throws IOException {
    return Double.parseDouble(Files.readAllLines(frames).get(frame + 1).split(",", -1)[7]);
  }

  @Test
  void aReplayGivesTheSameBytesAgain() throws IOException {
    elastic("1").mustSucceed();
    elastic("2").mustSucceed();
    assertArrayEquals(Files.readAllBytes(file("f1")), Files.readAllBytes(file("f2")));
    assertArrayEquals(Files.readAllBytes(file("l1")), Files.readAllBytes(file("l2")));
  }

  @ParameterizedTest
  @CsvSource({
    "--tool, sphere:3, this option is for a point alone: --elastic with --tool sphere:3",
    "--solver, dot, elastic segments need a solver that keeps the guarantee: --solver dot",
    "--fixed, block, a segment is elastic and fixed: --fixed block",
    "--fixed, bone, there is no such segment: --fixed bone",
    "--elastic, bone=young:1e3, there is no such segment: --elastic bone",
    "--elastic, skin=young:1e3;poisson:0.2, there is no such segment: --elastic skin",
    "--elastic, block=yung:1e3, the elastic material cannot be read: --elastic block=yung:1e3",
    "--mass, 0.1, a point with mass touches rigid segments alone: --elastic with --mass",
    "--repeat, 5, a pass would not begin where the last one did: --repeat with --elastic",
  })
  void refusesWhatDoesNotFitInOneLine(String option, String value, String line) {
    CommandRun run = elastic("", option, value);
    assertEquals(2, run.exitCode(), run.err());
    assertTrue(run.err().startsWith("palpate: " + line), run.err());
    assertEquals(1, run.err().lines().count(), run.err());
  }

  @Test
  void theOptionsOfALatticeNeedAnElasticSegment() {
    CommandRun run = replay("", "--lattice", 4);
    assertEquals(2, run.exitCode());
    assertEquals(
        "palpate: no segment is elastic: --lattice: add --elastic NAME=young:PA, or leave it out",
        run.err().strip());
  }

  @Test
  void aLiveSessionReportsItsUpdates() throws IOException {
    Object[] session = {
      "touch",
      "--phantom",
      "block:32",
      "--elastic",
      "block=young:20e3",
      "--lattice",
      8,
      "--headless",
      "--seconds",
      2,
      "--report",
      file("r.json")
    };
    CommandRun.of(session).mustSucceed();
    Map<String, String> report = FlatJson.read(file("r.json"));
    assertTrue(Integer.parseInt(report.get("/elastic/hexes")) > 20, report.toString());
    assertTrue(Integer.parseInt(report.get("/elastic/updates")) > 3, report.toString());
    double p50 = Double.parseDouble(report.get("/elastic/update_ms/p50"));
    double most = Double.parseDouble(report.get("/elastic/update_ms/max"));
    assertTrue(p50 > 0 && p50 <= most, report.toString());
  }

  private static final List<Object> RECORDED_SCENE =
      List.of(
          "--phantom",
          "block:32",
          "--elastic",
          "block=young:20e3",
          "--lattice",
          8,
          "--stiffness",
          0.5);

  private CommandRun recordSession(int seconds, Object... further) {
    List<Object> touch = new ArrayList<>(List.of("touch", "--headless", "--seconds", seconds));
    touch.addAll(RECORDED_SCENE);
    touch.addAll(List.of("--record", file("s.csv")));
    touch.addAll(List.of(further));
    return CommandRun.of(touch.toArray());
  }

  /** Returns the number of places of recorded updates with a force. */
  private long pressedPlaces() throws IOException {
    return Files.readAllLines(file("s.fields.csv")).stream()
        .skip(1)
        .map(line -> line.split(",", -1))
        .filter(words -> Double.parseDouble(words[6]) != 0)
        .map(words -> String.join(",", words[1], words[2], words[3]))
        .distinct()
        .count();
  }

  /** Lets each recorded field come into use some frames later. */
  private void delayFields(int frames) throws IOException {
    List<String> rows = new ArrayList<>();
    for (String line : Files.readAllLines(file("s.fields.csv"))) {
      String[] words = line.split(",", 2);
      boolean used = words[0].matches("[0-9]+");
      rows.add((used ? Long.parseLong(words[0]) + frames : words[0]) + "," + words[1]);
    }
    Files.write(file("s.fields.csv"), rows);
  }

  private String elsewhere() throws IOException {
    List<Object> replay = new ArrayList<>(List.of("replay", "--trajectory", file("s.csv")));
    replay.addAll(RECORDED_SCENE);
    replay.addAll(List.of("--fields", file("s.fields.csv"), "--report", file("r.json")));
    CommandRun.of(replay.toArray()).mustSucceed();
    return FlatJson.read(file("r.json")).get("/elastic/elsewhere");
  }

  @Test
  void aLiveSessionReplaysToItsBitsWithItsFields() throws IOException {
    long pressed = 0;
    for (int seconds = 5; seconds <= 20 && pressed <= 3; seconds *= 2) { // A busy machine is slow.
      recordSession(seconds, "--record-fields").mustSucceed();
      pressed = pressedPlaces();
    }
    assertTrue(pressed > 3, "places with a force: " + pressed);
    assertEquals("0", elsewhere());
    delayFields(20);
    assertNotEquals("0", elsewhere(), "updates at other frames give other bits");
  }

  @Test
  void withoutRecordFieldsATableOfAnOlderRecordingIsDeleted() throws IOException {
    Files.writeString(file("s.fields.csv"), "older");
    recordSession(1).mustSucceed();
    assertTrue(Files.notExists(file("s.fields.csv")));
  }

  @Test
  void refusesFieldsThatDoNotFit() throws IOException {
    String header = "frame,x,y,z,fx,fy,fz,cells\n";
    String[][] cases = {
      {"5,1,1,1,0,0,0,\n4,1,1,1,0,0,0,\n", "frame is 4"},
      {"5,1,nan,1,0,0,0,\n", "y is nan"},
      {"5,1,1,1,0,0,0,7:1\n", "a cell is 7:1"},
      {"5,1,1,1,0,0,0,7:1:-1:1:1:1\n", "a number of a cell is negative: 7:1:-1:1:1:1"},
      {"5,1,1,1,0,0,0,99999:1:1:1:1:1\n", "an update sets cell 99999, but cells are 0 to "},
    };
    for (String[] each : cases) {
      Files.writeString(file("fields.csv"), header + each[0]);
      CommandRun run = elastic("", "--fields", file("fields.csv"));
      assertEquals(2, run.exitCode(), run.err());
      assertTrue(run.err().contains(each[1]), run.err());
      assertEquals(1, run.err().lines().count(), run.err());
    }
    Files.writeString(file("fields.csv"), header);
    CommandRun rigid = replay("", "--fields", file("fields.csv"));
    assertEquals(2, rigid.exitCode());
    assertTrue(rigid.err().startsWith("palpate: no segment is elastic: --fields"), rigid.err());
  }

  @Test
  void aSceneOfSeveralVolumesIsRefused() {
    CommandRun run =
        CommandRun.of(
            "touch", "--phantom", "fracture:64:2", "--elastic", "x=young:1e3", "--headless");
    assertEquals(2, run.exitCode());
    assertEquals(
        "palpate: elastic segments are those of one volume: --elastic: give a volume, not a scene",
        run.err().strip());
  }
}
