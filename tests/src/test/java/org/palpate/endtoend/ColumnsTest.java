package org.palpate.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonToken;
import java.io.BufferedReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.palpate.benchmarks.jitter.ResultRows;
import org.palpate.benchmarks.report.StudyTable;

/** Compares the columns and keys of files with the page that explains them. */
@EnabledOnOs(value = OS.LINUX, disabledReason = "skipped: the keys of realtime are those of Linux")
class ColumnsTest {
  /** Maven runs the tests in the folder of the module. */
  private static final Path PAGE =
      Path.of(Files.exists(Path.of("docs")) ? "." : "..", "docs", "results", "columns.md");

  private static final Pattern KEY = Pattern.compile("`([^`]+)`");

  /** The heading of a section about keys of reports. */
  private static final Pattern REPORT = Pattern.compile("^## (Every report|Reports of|Times of)");

  /** Keys whose names below are those of segments, parameters or requests, not words of ours. */
  private static final Set<String> OPEN = Set.of("cells.answers", "left_out");

  /** Keys that only a window or a picture has. */
  private static final Set<String> NEED_DISPLAY = Set.of("sync.first_picture_s", "draw_ms");

  /** The empty list of displaced fragments, none of which faces another. */
  private static final Set<String> NO_PAIRS = Set.of("fracture.pairs");

  @TempDir private Path folder;

  @Test
  void everyColumnOfTablesIsExplainedAndWritten() throws IOException {
    Path trajectory = TestFiles.trajectory(folder.resolve("t.csv"), 30, 16, 1);
    Path frames = folder.resolve("frames.csv");
    Path legs = folder.resolve("legs.csv");
    Object[] point = replay(trajectory, "--out", frames, "--legs", legs);
    CommandRun.of(point).mustSucceed();
    assertEquals(explained("Frames of a point"), header(frames));
    assertEquals(explained("Legs of a point"), header(legs));
    CommandRun.of(replay(trajectory, "--out", frames, "--legs", legs, "--tool", "sphere:2"))
        .mustSucceed();
    assertEquals(explained("Frames of a tool"), header(frames));
    assertEquals(explained("Legs of a tool"), header(legs));
    Path recorded = folder.resolve("recorded.csv");
    CommandRun.of(touch("--record", recorded)).mustSucceed();
    assertEquals(explained("Trajectories"), header(recorded));
  }

  @Test
  void everyColumnOfStudiesIsExplained() throws IOException {
    Map<String, List<String>> columns = new TreeMap<>();
    for (StudyTable table : StudyTable.values()) {
      columns.put(table.fileName(), table.columns());
    }
    assertEquals(columns, tablesOfBench());
    assertEquals(ResultRows.columns(), explained("Table of `jitter`"));
  }

  @Test
  void everyKeyOfReportsIsExplainedAndWritten() throws IOException {
    Path trajectory = TestFiles.trajectory(folder.resolve("t.csv"), 30, 16, 1);
    Path report = folder.resolve("r.json");
    Path surface = folder.resolve("s.ply");
    Set<String> seen = new TreeSet<>();
    String[] common = {"Every report", "Reports of a volume", "Reports of frames"};
    seen.addAll(
        keys(report, replay(trajectory, "--repeat", 3), common, "Times of `replay --repeat`"));
    seen.addAll(
        keys(
            report,
            replay(trajectory, "--tool", "sphere:2", "--mass", 0.1),
            common,
            "Reports of a tool",
            "Reports of a point with mass"));
    seen.addAll(
        keys(
            report,
            replay(trajectory, "--elastic", "sphere=young:1e4"),
            common,
            "Reports with elastic segments"));
    seen.addAll(
        keys(
            report,
            replay(trajectory, "--protect", "sphere:1"),
            common,
            "Reports with protected segments"));
    Object[] needle =
        replay(trajectory, "--tool", "needle:1,9", "--material", "sphere=puncture:0.1");
    seen.addAll(keys(report, needle, common, "Reports of a needle", "Reports of a tool"));
    seen.addAll(
        keys(report, replay(trajectory, "--mass", 0.1), common, "Reports of a point with mass"));
    seen.addAll(keys(report, touch(), common, "Reports of `touch`"));
    Object[] reduction = {"touch", "--phantom", "fracture:64:2", "--headless", "--seconds", 0.3};
    String[] ofReduction = {
      "Reports of `touch`",
      "Reports of `touch` with bodies to hold",
      "Reports of a tool",
      "Reports of fragments"
    };
    seen.addAll(keys(report, reduction, common, ofReduction, NO_PAIRS));
    Object[] info = {"info", "--phantom", "sphere:16"};
    seen.addAll(keys(report, info, common, "Reports of `info`"));
    Object[] render = {"render", "--phantom", "sphere:16", "--out", surface};
    seen.addAll(keys(report, render, common, "Reports of `render`"));
    seen.addAll(keys(report, new Object[] {"devices"}, common, "Reports of `devices`"));
    Object[] check = {"devices", "--check", "capture:../native/docs/captures/six-degrees.hid"};
    seen.addAll(keys(report, check, common, "Reports of `devices`"));
    seen.addAll(keysOfScenes(trajectory, report, common));
    seen.addAll(keysOfStudies(report, common));
    Set<String> missing = allKeys();
    missing.removeAll(seen);
    missing.removeAll(NEED_DISPLAY);
    assertEquals(Set.of(), missing, "explained but never written");
  }

  @Test
  void everyKeyAndColumnOfAnAssessmentIsExplainedAndWritten() throws IOException {
    Path trajectory = TestFiles.trajectory(folder.resolve("t.csv"), 30, 16, 1);
    Path training = folder.resolve("training");
    CommandRun.of(replay(trajectory, "--protect", "sphere:1", "--assess", training)).mustSucceed();
    Set<String> written = leaves(training.resolve("assessment.json"));
    written.removeAll(explained("Reports with protected segments"));
    Set<String> explained = new TreeSet<>(explained("Assessment"));
    explained.removeIf(key -> key.startsWith("holds."));
    explained.add("holds"); // a point holds nothing
    assertEquals(explained, written);
    for (String table : List.of("Segments", "Course", "Tremor", "Holds")) {
      Path file = training.resolve(table.toLowerCase(Locale.ROOT) + ".csv");
      assertEquals(explained(table + " of an assessment"), header(file));
    }
  }

  private static Set<String> keysOfScenes(Path trajectory, Path report, String[] common)
      throws IOException {
    Path poses = trajectory.resolveSibling("poses.csv");
    Files.writeString(poses, "frame,body,x,y,z,qw,qx,qy,qz\n3,fragment2,1,0,0,1,0,0,0\n");
    Object[] moved = {
      "replay", "--phantom", "fracture:64:2", "--trajectory", trajectory, "--poses", poses
    };
    Path fragments = trajectory.resolveSibling("fragments.nrrd");
    CommandRun.of("info", "--phantom", "sphere:32", "--fracture", 2, "--export", fragments)
        .mustSucceed();
    Path scene = trajectory.resolveSibling("scene.json");
    String body = "{\"name\":\"%d\",\"volume\":\"fragments.nrrd\",\"segment\":\"label:%d\"}";
    Files.writeString(
        scene, "{\"bodies\":[" + body.replace("%d", "1") + "," + body.replace("%d", "2") + "]}");
    Object[] fracture = {"info", "--scene", scene};
    Set<String> keys =
        keys(report, moved, common, "Reports of bodies that move", "Reports of a tool");
    keys.addAll(keys(report, fracture, common, "Reports of fragments", "Reports of `info`"));
    Object[] aimed = {
      "touch", "--phantom", "fracture:64:2", "--headless", "--seconds", 0.3, "--ghost", fragments
    };
    String[] ofAimed = {
      "Reports of `touch`",
      "Reports of `touch` with bodies to hold",
      "Reports of a tool",
      "Reports of fragments",
      "Reports of ghosts"
    };
    keys.addAll(keys(report, aimed, common, ofAimed, NO_PAIRS));
    Path fine = trajectory.resolveSibling("fine.nrrd");
    Object[] resample = {"info", "--volume", fragments, "--resample", "x2", "--export", fine};
    CommandRun.of(resample).mustSucceed();
    Path two = trajectory.resolveSibling("two.json");
    Files.writeString(two, Files.readString(scene).replaceFirst("fragments.nrrd", "fine.nrrd"));
    Object[] replay = {"replay", "--scene", two, "--trajectory", trajectory};
    String own = "Reports of bodies with grids of their own";
    keys.addAll(keys(report, replay, common, own, "Reports of a tool"));
    return keys;
  }

  private Set<String> keysOfStudies(Path report, String[] common) throws IOException {
    String out = folder.resolve("study").toString();
    Object[] bench = {"bench", "--stress", "--frames", 1000, "--out", out};
    String cell = "jdk" + Runtime.version().feature() + "-serial-sleep-normal-empty-none-.*";
    Object[] jitter = {"jitter", "--cells", cell, "--seconds", 1, "--out", out};
    Set<String> keys = keys(report, bench, common, "Reports of `bench`");
    Set<String> columns = new TreeSet<>();
    explained("Table of `jitter`").forEach(column -> columns.add("cells." + column));
    keys.addAll(keys(report, jitter, common, new String[] {"Reports of `jitter`"}, columns));
    return keys;
  }

  /** Runs a command, checks that the page explains each key of its report, and returns the keys. */
  private static Set<String> keys(Path report, Object[] command, String[] common, String... own)
      throws IOException {
    return keys(report, command, common, own, Set.of());
  }

  /** Does the same; {@code others} are keys that the page explains elsewhere. */
  private static Set<String> keys(
      Path report, Object[] command, String[] common, String[] own, Set<String> others)
      throws IOException {
    List<Object> arguments = new ArrayList<>(List.of(command));
    arguments.add("--report");
    arguments.add(report);
    CommandRun.of(arguments.toArray()).mustSucceed();
    Set<String> keys = leaves(report);
    Set<String> unexplained = new TreeSet<>(keys);
    for (String section : common) {
      unexplained.removeAll(explained(section));
    }
    for (String section : own) {
      unexplained.removeAll(explained(section));
    }
    unexplained.removeAll(others);
    assertEquals(Set.of(), unexplained, command[0] + ": written but not explained");
    return keys;
  }

  private static Object[] replay(Path trajectory, Object... more) {
    List<Object> all =
        new ArrayList<>(List.of("replay", "--phantom", "sphere:16", "--trajectory", trajectory));
    all.addAll(List.of(more));
    return all.toArray();
  }

  private static Object[] touch(Object... more) {
    List<Object> all =
        new ArrayList<>(List.of("touch", "--phantom", "sphere:16", "--headless", "--seconds", 0.3));
    all.addAll(List.of(more));
    return all.toArray();
  }

  private static List<String> header(Path table) throws IOException {
    try (BufferedReader lines = Files.newBufferedReader(table)) {
      return List.of(lines.readLine().split(",", -1));
    }
  }

  /** Returns the paths of all fields that hold no object, without the indexes of lists. */
  private static Set<String> leaves(Path report) throws IOException {
    Set<String> paths = new TreeSet<>();
    try (JsonParser parser = new JsonFactory().createParser(report.toFile())) {
      while (parser.nextToken() != null) {
        if (parser.currentToken() == JsonToken.FIELD_NAME) {
          String pointer = parser.getParsingContext().pathAsPointer().toString();
          paths.add(pointer.substring(1).replaceAll("/[0-9]+(?=/|$)", "").replace('/', '.'));
        }
      }
    }
    Set<String> leaves = new TreeSet<>(paths);
    leaves.removeIf(path -> paths.stream().anyMatch(other -> other.startsWith(path + ".")));
    for (String open : OPEN) {
      if (leaves.removeIf(path -> path.startsWith(open + "."))) {
        leaves.add(open);
      }
    }
    leaves.remove("backends.devices"); // the list of a back end without a device
    return leaves;
  }

  private static List<String> explained(String section) throws IOException {
    List<String> keys = new ArrayList<>();
    boolean inside = false;
    for (String line : Files.readAllLines(PAGE)) {
      if (line.startsWith("#")) {
        inside = line.equals("## " + section) || line.equals("### " + section);
      } else if (inside && line.startsWith("| `")) {
        Matcher names = KEY.matcher(line.substring(0, line.indexOf('|', 1)));
        while (names.find()) {
          keys.add(names.group(1));
        }
      }
    }
    return keys;
  }

  /** Returns the explained columns of each file that a heading of the third level names. */
  private static Map<String, List<String>> tablesOfBench() throws IOException {
    Map<String, List<String>> tables = new TreeMap<>();
    for (String line : Files.readAllLines(PAGE)) {
      Matcher files = KEY.matcher(line);
      while (line.startsWith("### ") && files.find()) {
        tables.put(files.group(1), explained(line.substring(4)));
      }
    }
    return tables;
  }

  private static Set<String> allKeys() throws IOException {
    Set<String> keys = new TreeSet<>();
    for (String line : Files.readAllLines(PAGE)) {
      if (REPORT.matcher(line).find()) {
        keys.addAll(explained(line.substring(3)));
      }
    }
    return keys;
  }
}
