package org.palpate.endtoend;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.palpate.geometry.Vec3;
import org.palpate.io.VolumeFiles;
import org.palpate.io.label.SegmentBuilder;
import org.palpate.io.label.SegmentSpec;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.io.volume.ReadOptions;
import org.palpate.io.volume.VolumeReader;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.testing.Seeds;
import org.palpate.tool.MadeTool;
import org.palpate.tool.ToolMaker;
import org.palpate.tool.ToolRequest;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.phantom.Phantom;

/** Runs {@code replay --tool} and judges what it writes. */
class ToolReplayTest {
  private static final double SPAN_MM = 48;

  private final SplittableRandom random = new SplittableRandom(Seeds.seed());
  @TempDir private Path folder;

  private Path file(String name) {
    return folder.resolve(name);
  }

  private Path trajectory(int frames, Vec3 centre) throws IOException {
    return TestFiles.toolTrajectory(file("t.csv"), random, frames, centre, SPAN_MM);
  }

  private CommandRun replay(Object... arguments) {
    List<Object> all = new ArrayList<>(List.of("replay", "--trajectory", file("t.csv")));
    all.addAll(List.of(arguments));
    return CommandRun.of(all.toArray());
  }

  @Test
  void everyLegIsFreeChainsBitForBitAndAgreesWithTheFrames() throws IOException {
    SegmentedVolume torus = Phantom.parse("torus:48").segments();
    for (String clearance : new String[] {"body", "points"}) {
      trajectory(700, new Vec3(24, 24, 24));
      replay(
              "--phantom",
              "torus:48",
              "--tool",
              "capsule:2,6",
              "--clearance",
              clearance,
              "--out",
              file("f.csv"),
              "--legs",
              file("l.csv"),
              "--report",
              file("r.json"))
          .mustSucceed();
      MadeTool made = tool("capsule:2,6", clearance);
      ToolLegsFile judge = new ToolLegsFile(torus, made.tool(), 1);
      judge.judge(file("f.csv"), file("l.csv"));
      assertTrue(judge.legs() > 50_000, "legs " + judge.legs());
      Map<String, String> report = FlatJson.read(file("r.json"));
      assertEquals("700", report.get("/frames"));
      assertEquals("rigid", report.get("/solver"));
      assertEquals(Integer.toString(made.tool().count()), report.get("/tool/points"));
      boolean body = clearance.equals("body");
      assertEquals(body ? "0.0" : null, report.get("/tool/clearance_mm"));
      assertEquals(body ? "0" : null, report.get("/tool/clearance_reduced"));
      assertTrue(Integer.parseInt(report.get("/contact_frames")) > 50, report.toString());
      assertTrue(Double.parseDouble(report.get("/max_torque_nmm")) > 0);
      long p50 = Long.parseLong(report.get("/work/p50"));
      assertTrue(p50 > 0 && p50 <= Long.parseLong(report.get("/work/p99_9")), report.toString());
    }
  }

  private static MadeTool tool(String spec, String clearance) throws IOException {
    ToolRequest request = ToolRequest.parse(spec, null, null, clearance);
    return ToolMaker.make(request, 1, CoordinateSystem.UNKNOWN);
  }

  @Test
  void aFragmentAmongTheSegmentsOfAScanStartsFreeAndIsJudgedAgainstEach() throws IOException {
    Path scan =
        TestFiles.nrrd(
            file("scan.nrrd"), 24, v -> blob(v, 8, 12, 12, 6) ? 1 : blob(v, 17, 12, 12, 4) ? 2 : 0);
    Path fragment = TestFiles.nrrd(file("fragment.nrrd"), 10, v -> blob(v, 5, 5, 5, 4) ? 7 : 0);
    trajectory(400, new Vec3(-2, -8, 36)); // begins inside the first blob or near it
    Path trajectory = file("t.csv");
    List<String> lines = new ArrayList<>(Files.readAllLines(trajectory));
    lines.add(1, "-1,-2,-8,54,0,1,0,0");
    Files.writeString(trajectory, String.join("\n", lines) + "\n");
    replay(
            "--volume",
            scan,
            "--tool",
            fragment,
            "--out",
            file("f.csv"),
            "--legs",
            file("l.csv"),
            "--report",
            file("r.json"))
        .mustSucceed();
    VolumeReader reader = VolumeFiles.open(scan, ReadOptions.defaults());
    SegmentedVolume segments =
        SegmentBuilder.read(
            reader, List.of(SegmentSpec.parse("a=label:1"), SegmentSpec.parse("b=label:2")));
    ToolRequest request = ToolRequest.parse(fragment.toString(), null, null, null);
    MadeTool made = ToolMaker.make(request, 1, reader.header().coordinateSystem());
    ToolLegsFile judge = new ToolLegsFile(segments, made.tool(), 1);
    judge.judge(file("f.csv"), file("l.csv"));
    Map<String, String> report = FlatJson.read(file("r.json"));
    assertEquals("1", report.get("/freed"));
    assertEquals(2L * made.tool().count(), judge.releases());
    assertEquals("401", report.get("/frames"));
    double[] first = ToolLegsFile.numbers(Files.readAllLines(file("f.csv")).get(1));
    assertEquals(0, Math.hypot(first[8], Math.hypot(first[9], first[10])), "the force is ramped");
    assertReleasedWithTheOrientationOfTheDevice(segments, made.tool());
  }

  /** In the first rows every point lies where the identity and one translation put it. */
  private void assertReleasedWithTheOrientationOfTheDevice(SegmentedVolume volume, RigidTool tool)
      throws IOException {
    List<String> rows = Files.readAllLines(file("l.csv"));
    Vec3 translation = null;
    for (int point = 0; point < tool.count(); point++) {
      double[] row = ToolLegsFile.numbers(releaseOf(rows, point));
      Vec3 at = volume.grid().gridToWorld(new Vec3(row[4], row[5], row[6]), new Vec3());
      at.sub(tool.point(point, new Vec3()), at);
      translation = translation == null ? at : translation;
      assertEquals(0, at.sub(translation, new Vec3()).length(), 1e-9, "point " + point);
    }
  }

  private static String releaseOf(List<String> rows, int point) {
    String start = "0,-1,0," + point + ",";
    return rows.stream().filter(row -> row.startsWith(start)).findFirst().orElseThrow();
  }

  private static boolean blob(int[] v, double x, double y, double z, double radius) {
    double dx = v[0] + 0.5 - x;
    double dy = v[1] + 0.5 - y;
    double dz = v[2] + 0.5 - z;
    return dx * dx + dy * dy + dz * dz < radius * radius;
  }

  @Test
  void writesTheSameBytesTwiceAndPartsOfTheLegsOnRequest() throws IOException {
    trajectory(300, new Vec3(24, 24, 24));
    Object[] scene = {"--phantom", "sphere:48", "--tool", "sphere:4"};
    for (String name : new String[] {"a", "b"}) {
      replay(with(scene, "--out", file(name + "f"), "--legs", file(name + "l"))).mustSucceed();
    }
    assertArrayEquals(Files.readAllBytes(file("af")), Files.readAllBytes(file("bf")));
    assertArrayEquals(Files.readAllBytes(file("al")), Files.readAllBytes(file("bl")));
    replay(with(scene, "--legs", file("part"), "--legs-every", "7", "--legs-frames", "100..199"))
        .mustSucceed();
    String expected =
        Files.readAllLines(file("al")).stream()
            .filter(line -> line.startsWith("frame") || isPart(line))
            .collect(Collectors.joining("\n"));
    assertEquals(expected, Files.readString(file("part")).strip());
    assertTrue(expected.lines().count() > 100);
  }

  @Test
  void aTableOfFramesReplaysToTheSameFrames() throws IOException {
    trajectory(100, new Vec3(24, 24, 24));
    Object[] scene = {"--phantom", "sphere:48", "--tool", "capsule:2,6"};
    replay(with(scene, "--out", file("once"))).mustSucceed();
    Files.copy(file("once"), file("t.csv"), StandardCopyOption.REPLACE_EXISTING);
    replay(with(scene, "--out", file("again"))).mustSucceed();
    assertArrayEquals(Files.readAllBytes(file("once")), Files.readAllBytes(file("again")));
  }

  private static boolean isPart(String line) {
    double[] row = ToolLegsFile.numbers(line);
    return row[0] >= 100 && row[0] <= 199 && row[3] % 7 == 0;
  }

  private static Object[] with(Object[] scene, Object... more) {
    List<Object> all = new ArrayList<>(List.of(scene));
    all.addAll(List.of(more));
    return all.toArray();
  }

  @Test
  void limitsStiffnessAndTimeAreThoseOfTheOptions() throws IOException {
    Files.writeString(
        file("t.csv"),
        "t_ms,x,y,z,qw,qx,qy,qz\n0,24,24,50,1,0,0,0\n"
            + IntStream.range(1, 200)
                .mapToObj(n -> n + ",24,24,34,0.5,0.5,0.5,0.5\n")
                .collect(Collectors.joining()));
    Object[] scene = {"--phantom", "sphere:48", "--tool", "box:6,4,8", "--report", file("r.json")};
    replay(with(scene, "--stiffness", "2", "--max-force", "0.5", "--repeat", "3")).mustSucceed();
    Map<String, String> limited = FlatJson.read(file("r.json"));
    assertEquals(0.5, Double.parseDouble(limited.get("/max_force_n")), 1e-12);
    assertTrue(Double.parseDouble(limited.get("/ns_per_frame/median")) > 0);
    double torque = Double.parseDouble(limited.get("/max_torque_nmm"));
    replay(with(scene, "--rotational-stiffness", "1", "--mass", "0.1")).mustSucceed();
    Map<String, String> soft = FlatJson.read(file("r.json"));
    assertEquals("0.1", soft.get("/tool/mass_kg"));
    assertTrue(Double.parseDouble(soft.get("/max_torque_nmm")) < torque);
  }

  @Test
  void aRawDeviceKeepsTheLastOrientationThatWasOne() throws IOException {
    Files.writeString(
        file("t.csv"),
        """
        t_ms,x,y,z,qw,qx,qy,qz
        0,24,24,60,0,1,0,0
        1,24,24,59,NaN,0,0,0
        2,24,24,58,0,0,0,0
        3,24,NaN,58,1,0,0,0
        4,24,24,57,3,0,0,0
        """);
    Object[] scene = {"--phantom", "sphere:48", "--tool", "sphere:4", "--out", file("f.csv")};
    String line = replay(scene).mustRefuse();
    assertTrue(line.contains("line 3"), line);
    replay(with(scene, "--raw-device", "--report", file("r.json"))).mustSucceed();
    Map<String, String> report = FlatJson.read(file("r.json"));
    assertEquals("3", report.get("/faults/bad_orientations"));
    assertEquals("1", report.get("/faults/not_finite"));
    double[] last = ToolLegsFile.numbers(Files.readAllLines(file("f.csv")).get(5));
    assertEquals(57, last[7]);
    assertEquals(1, Math.abs(last[18]), "the tool keeps the orientation 0,1,0,0");
  }

  @Test
  void wrongUseIsOneLineAndExitCodeTwo() throws IOException {
    trajectory(10, new Vec3(24, 24, 24));
    String[][] wrong = {
      {"--tool", "sphere:4", "--coordinates", "grid"},
      {"--tool", "sphere:4", "--solver", "smooth"},
      {"--tool", "sphere:4", "--friction", "-0.1"},
      {"--tool", "sphere:4", "--friction-form", "cone"},
      {"--tool", "sphere:4", "--rotational-stiffness", "-1"},
      {"--tool", "sphere:4", "--legs-frames", "5..2"},
      {"--tool", "sphere:4", "--legs-frames", "1..2..3"},
      {"--tool", "sphere:4", "--legs-every", "0"},
      {"--tool", "sphere:4", "--mass", "0"},
      {"--legs-every", "2"},
      {"--tool", "missing.nrrd"},
      {"--tool", "cube:3"},
    };
    for (String[] arguments : wrong) {
      String line =
          replay(with(new Object[] {"--phantom", "sphere:32"}, (Object[]) arguments)).mustRefuse();
      String option = arguments[arguments.length - 2];
      String value = arguments[arguments.length - 1];
      assertTrue(line.contains(option) || line.contains(value), line);
    }
  }
}
