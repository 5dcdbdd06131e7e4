package org.palpate.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;
import org.palpate.io.VolumeFiles;
import org.palpate.io.label.SegmentBuilder;
import org.palpate.io.label.SegmentSpec;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.io.volume.ReadOptions;
import org.palpate.io.volume.VolumeReader;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.testing.Seeds;
import org.palpate.tool.ToolMaker;
import org.palpate.tool.ToolRequest;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;

/** Needles in the commands: layers of skin and fat around a ball of bone. */
class NeedleCommandTest {
  private static final String NEEDLE = "needle:0.6,30";
  private static final int EDGE = 24;

  @TempDir private Path folder;
  private Path scan;

  @BeforeEach
  void writeScan() throws IOException {
    scan = TestFiles.nrrd(folder.resolve("scan.nrrd"), EDGE, NeedleCommandTest::label);
  }

  /** Returns 1 for bone, 2 for fat and 3 for skin; the axis z has voxels of 2 mm. */
  private static int label(int[] v) {
    double radius = Math.hypot(Math.hypot(v[0] - 11.5, v[1] - 11.5), 2 * (v[2] - 11.5));
    return radius < 4 ? 1 : radius < 7 ? 2 : radius < 9 ? 3 : 0;
  }

  private List<Object> replay(Object... more) {
    List<Object> all = new ArrayList<>(List.of("replay", "--volume", scan));
    all.addAll(List.of("--segment", "bone=label:1", "--segment", "fat=label:2"));
    all.addAll(List.of("--segment", "skin=label:3", "--tool", NEEDLE));
    all.addAll(List.of(more));
    return all;
  }

  /** Writes a hand that stabs at the bone again and again, bends the needle, and draws it out. */
  private Path hostile(int frames) throws IOException {
    SplittableRandom random = new SplittableRandom(Seeds.seed());
    StringBuilder rows = new StringBuilder("t_ms,x,y,z,qw,qx,qy,qz\n");
    Vec3 middle = new Vec3(1.5, -8.5, 53);
    Vec3 at = new Vec3();
    Quaternion q = new Quaternion();
    Quaternion turn = new Quaternion();
    for (int n = 0; n < frames; n++) {
      double phase = n % 400 / 400.0;
      double reach = phase < 0.6 ? 30 - 30 * phase : 12 + 60 * (phase - 0.6);
      double wild = n % 400 == 399 ? 1 : 0.004;
      Vec3 by =
          new Vec3(random.nextDouble(-1, 1), random.nextDouble(-1, 1), 0).mul(wild, new Vec3());
      turn.setRotationVector(by).multiply(q, q);
      q.normalize();
      q.rotate(new Vec3(random.nextDouble(-2, 2) * phase, 0, reach + 5), at);
      at.add(middle, at);
      rows.append(n).append(',').append(at.x).append(',').append(at.y).append(',').append(at.z);
      rows.append(',').append(q.w).append(',').append(q.x).append(',').append(q.y).append(',');
      rows.append(q.z).append('\n');
    }
    return Files.writeString(folder.resolve("hostile.csv"), rows.toString());
  }

  /** Returns the segments without the voxels of those that a needle may enter. */
  private SegmentedVolume solids() throws IOException {
    VolumeReader reader = VolumeFiles.open(scan, ReadOptions.defaults());
    SegmentedVolume all =
        SegmentBuilder.read(
            reader,
            List.of(
                SegmentSpec.parse("bone=label:1"),
                SegmentSpec.parse("fat=label:2"),
                SegmentSpec.parse("skin=label:3")));
    BitCube none = new BitCube(EDGE, EDGE, EDGE);
    List<Segment> kept = new ArrayList<>();
    for (Segment segment : all.segments()) {
      boolean isBone = segment.name().equals("bone");
      kept.add(new Segment(segment.name(), isBone ? segment.bits() : none, segment.rgb()));
    }
    return new SegmentedVolume(all.grid(), kept);
  }

  @Test
  void noLegTouchesBoneAndTheReportSaysWhatTheNeedleEntered() throws IOException {
    Path frames = folder.resolve("f.csv");
    Path legs = folder.resolve("l.csv");
    Path report = folder.resolve("r.json");
    List<Object> replay = replay("--trajectory", hostile(3000), "--clearance", "points");
    replay.addAll(List.of("--material", "skin=puncture:0.5,cutting:0.1,shaft:0.02"));
    replay.addAll(List.of("--material", "fat=puncture:0.2,shaft:0.01", "--out", frames));
    replay.addAll(List.of("--legs", legs, "--report", report));
    CommandRun.of(replay.toArray()).mustSucceed();
    ToolRequest request = ToolRequest.parse(NEEDLE, null, null, "points");
    RigidTool tool = ToolMaker.make(request, 1, CoordinateSystem.UNKNOWN).tool();
    ToolLegsFile judge = new ToolLegsFile(solids(), tool, 1);
    judge.judge(frames, legs);
    assertTrue(judge.legs() > 50_000, "legs " + judge.legs());
    Map<String, String> fields = FlatJson.read(report);
    assertEquals("fat", fields.get("/needle/penetrable/0/segment"), fields.toString());
    assertEquals("0.02", fields.get("/needle/penetrable/1/shaft_n_per_mm"));
    assertTrue(Long.parseLong(fields.get("/needle/punctures")) > 10, fields.toString());
    assertTrue(Double.parseDouble(fields.get("/needle/deepest_mm")) > 3, fields.toString());
    assertTrue(Long.parseLong(fields.get("/contact_frames")) > 50, "it meets the bone");
  }

  @Test
  void withoutPunctureANeedleIsARigidRod() throws IOException {
    Path report = folder.resolve("r.json");
    List<Object> replay = replay("--trajectory", hostile(800), "--report", report);
    CommandRun.of(replay.toArray()).mustSucceed();
    assertTrue(Files.readString(report).contains("\"tool\""));
    assertTrue(!Files.readString(report).contains("\"needle\" :"), "the mode is off");
  }

  @Test
  void aLiveSessionSaysWhatMayBeEntered() throws IOException {
    List<Object> touch = new ArrayList<>(List.of("touch", "--volume", scan, "--headless"));
    touch.addAll(List.of("--segment", "bone=label:1", "--segment", "fat=label:2,3"));
    touch.addAll(List.of("--tool", NEEDLE, "--seconds", 1, "--material", "fat=puncture:0.2"));
    CommandRun run = CommandRun.of(touch.toArray());
    run.mustSucceed();
    assertTrue(run.out().contains("The needle may enter fat; it enters nothing else."), run.out());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "fat=puncture:-1 |",
        "fat=puncture:NaN |",
        "fat=puncture:2e6 |",
        "fat=cutting:1 |",
        "fat=shaft:1 |",
        "fat=puncture:1,puncture:2 |",
        "fat=puncture:1 | --tool=sphere:2",
        "fat=puncture:1 | --tool=point",
        "fat=puncture:1 | --carve=40",
        "fat=puncture:1 | --protect=fat:1"
      })
  void whatDoesNotFitIsOneLine(String material, String other) throws IOException {
    List<Object> replay = replay("--trajectory", hostile(10), "--material", material);
    if (other != null && other.startsWith("--tool")) {
      replay.remove("--tool");
      replay.remove(NEEDLE);
    }
    if (other != null) {
      replay.add(other);
    }
    String said = CommandRun.of(replay.toArray()).mustRefuse();
    assertTrue(said.contains("fat"), said);
  }
}
