package org.palpate.endtoend;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.io.mesh.MeshFiles;
import org.palpate.io.scene.BodyReader;
import org.palpate.io.scene.PlacedVolume;
import org.palpate.io.scene.SceneReader;
import org.palpate.io.table.BodyPose;
import org.palpate.io.table.PosesCsv;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.rigid.tool.TriangleMesh;
import org.palpate.volume.Segment;

/** Scenes of displaced fragments, through the command line. */
class SceneCommandTest {
  private static final int WITHOUT_SIMPLEITK = 3;

  @TempDir private Path folder;

  private Path scene;
  private Path transforms;

  @BeforeEach
  void breakAPhantom() {
    scene = folder.resolve("s.json");
    transforms = folder.resolve("poses");
    CommandRun.of(
            "info",
            "--phantom",
            "fracture:64:4:5",
            "--export",
            folder.resolve("parts.nrrd"),
            "--save-scene",
            scene,
            "--save-transforms",
            transforms)
        .mustSucceed();
  }

  private PlacedVolume bodies() throws IOException {
    return BodyReader.read(SceneReader.read(scene), scene);
  }

  @Test
  void aSessionWithoutMotionReportsAndWritesTheBodiesWhereTheyStand() throws IOException {
    Path report = folder.resolve("r.json");
    Path left = folder.resolve("left.json");
    CommandRun run =
        CommandRun.of(
            "touch",
            "--scene",
            scene,
            "--headless",
            "--seconds",
            0.3,
            "--report",
            report,
            "--export",
            folder.resolve("left.nrrd"),
            "--save-scene",
            left,
            "--save-transforms",
            folder.resolve("tfm"));
    run.mustSucceed();
    Map<String, String> fields = FlatJson.read(report);
    assertTrue(Double.parseDouble(fields.get("/fracture/residual_mm")) > 1, fields.toString());
    assertEquals("0", fields.get("/fracture/overlap_voxels"));
    List<Pose> before = bodies().poses();
    List<Pose> after = BodyReader.read(SceneReader.read(left), left).poses();
    assertEquals(before.size(), after.size());
    for (int n = 0; n < before.size(); n++) {
      double moved = before.get(n).translation.sub(after.get(n).translation, new Vec3()).length();
      assertTrue(moved <= 1e-9, "only the lattice of poses may move a body: " + moved);
    }
    assertTrue(Files.exists(folder.resolve("tfm").resolve("fragment2.tfm")));
  }

  @Test
  void aRecordingInWhichNoBodyMovedHasNoPosesAndLeavesNoOlderOnes() throws IOException {
    Path poses = Files.writeString(folder.resolve("t.poses.csv"), "older");
    List<Object> touch = new ArrayList<>(List.of("touch", "--scene", scene, "--headless"));
    touch.addAll(List.of("--seconds", 0.3, "--record", folder.resolve("t.csv")));
    CommandRun.of(touch.toArray()).mustSucceed();
    assertFalse(Files.exists(poses));
  }

  @Test
  void aLiveReductionIsReplayedToTheBit() throws IOException {
    List<Object> phantom = List.of("--phantom", "fracture:64:2:5");
    Path samples = folder.resolve("t.csv");
    Path poses = folder.resolve("t.poses.csv");
    Path left = folder.resolve("left.json");
    List<Object> touch = new ArrayList<>(List.of("touch", "--headless", "--seconds", 7));
    touch.addAll(phantom);
    touch.addAll(List.of("--record", samples, "--save-scene", left));
    touch.addAll(List.of("--export", folder.resolve("left.nrrd")));
    CommandRun.of(touch.toArray()).mustSucceed();
    Path report = folder.resolve("r.json");
    List<Object> replay = new ArrayList<>(List.of("replay", "--trajectory", samples));
    replay.addAll(phantom);
    replay.addAll(List.of("--poses", poses, "--report", report, "--legs", folder.resolve("l.csv")));
    CommandRun.of(replay.toArray()).mustSucceed();
    Map<String, String> json = FlatJson.read(report);
    assertEquals("0", json.get("/moving/elsewhere"), json.toString());
    List<BodyPose> rows = PosesCsv.read(poses, List.of("fragment1", "fragment2"));
    assertTrue(rows.size() > 500, rows.size() + " rows");
    Pose last = BodyReader.read(SceneReader.read(left), left).poses().get(1);
    assertTrue(last.sameBits(rows.get(rows.size() - 1).restToPresent()), last.toString());
  }

  @Test
  @EnabledOnOs(value = OS.LINUX, disabledReason = "skipped: no /dev/full on this system")
  void aFullDiskAtTheExportKeepsTheReport() throws IOException {
    Path full = Files.createSymbolicLink(folder.resolve("full.nrrd"), Path.of("/dev/full"));
    Path report = folder.resolve("r.json");
    List<Object> touch = new ArrayList<>(List.of("touch", "--scene", scene, "--headless"));
    touch.addAll(List.of("--seconds", 0.3, "--export", full, "--report", report));
    CommandRun run = CommandRun.of(touch.toArray());
    assertEquals(1, run.exitCode());
    assertTrue(run.err().contains("No space left on device): " + full), run.err());
    assertTrue(FlatJson.read(report).containsKey("/fracture/residual_mm"));
  }

  @Test
  void bodiesWithLikeNamesHaveATransformEach() throws IOException {
    String text = Files.readString(scene);
    text = text.replace("\"fragment1\"", "\"a b\"").replace("\"fragment2\"", "\"A_b\"");
    Path file = Files.writeString(folder.resolve("like.json"), text);
    Path own = folder.resolve("own");
    CommandRun.of("info", "--scene", file, "--save-transforms", own).mustSucceed();
    for (int n = 0; n < 2; n++) {
      assertArrayEquals(
          Files.readAllBytes(transforms.resolve("fragment" + (n + 1) + ".tfm")),
          Files.readAllBytes(own.resolve(List.of("a_b.tfm", "A_b-2.tfm").get(n))));
    }
  }

  @Test
  void posesAreWrittenOfPlacedBodiesAlone() {
    String refusal =
        CommandRun.of(
                "touch",
                "--phantom",
                "sphere:16",
                "--headless",
                "--save-scene",
                folder.resolve("x.json"),
                "--export",
                folder.resolve("x.nrrd"))
            .mustRefuse();
    assertTrue(refusal.contains("the volume has no bodies with poses"), refusal);
  }

  @Test
  void aPointStopsAtADisplacedFragmentAndNeverEntersIt() throws IOException {
    PlacedVolume bodies = bodies();
    int fragment = 2;
    Vec3 middle = middle(bodies, fragment);
    Path trajectory = folder.resolve("t.csv");
    StringBuilder rows = new StringBuilder("t_ms,x,y,z\n");
    for (int n = 0; n < 400; n++) {
      double z = middle.z + 30 - n * 0.1;
      rows.append(String.format(Locale.ROOT, "%d,%s,%s,%s%n", n, middle.x, middle.y, z));
    }
    Files.writeString(trajectory, rows);
    Path frames = folder.resolve("f.csv");
    Path report = folder.resolve("r.json");
    CommandRun.of(
            "replay",
            "--scene",
            scene,
            "--trajectory",
            trajectory,
            "--out",
            frames,
            "--report",
            report)
        .mustSucceed();
    Map<String, String> json = FlatJson.read(report);
    assertTrue(Integer.parseInt(json.get("/contact_frames")) > 20, json.toString());
    List<String> lines = Files.readAllLines(frames);
    List<String> columns = List.of(lines.get(0).split(",", -1));
    for (String line : lines.subList(1, lines.size())) {
      String[] row = line.split(",", -1);
      Vec3 point =
          new Vec3(
              Double.parseDouble(row[columns.indexOf("px")]),
              Double.parseDouble(row[columns.indexOf("py")]),
              Double.parseDouble(row[columns.indexOf("pz")]));
      for (int n = 0; n < 4; n++) {
        assertFalse(isSolid(bodies, n, point), "fragment " + n + " at " + point);
      }
    }
  }

  /** Whether a world position lies in a voxel of a placed body. */
  private static boolean isSolid(PlacedVolume bodies, int n, Vec3 world) {
    Vec3 rest = bodies.poses().get(n).inverseTransform(world, new Vec3());
    Vec3 grid = bodies.rest().grid().worldToGrid(rest, rest);
    return bodies
        .rest()
        .segments()
        .get(n)
        .bits()
        .get((int) Math.floor(grid.x), (int) Math.floor(grid.y), (int) Math.floor(grid.z));
  }

  /** Returns the mean of the centres of a placed body's voxels, world mm. */
  private static Vec3 middle(PlacedVolume bodies, int n) {
    Segment segment = bodies.rest().segments().get(n);
    Vec3 sum = new Vec3();
    int edge = bodies.rest().grid().sizeX();
    for (int v = 0; v < edge * edge * edge; v++) {
      int i = v % edge;
      int j = v / edge % edge;
      int k = v / edge / edge;
      if (segment.bits().get(i, j, k)) {
        sum.add(new Vec3(i + 0.5, j + 0.5, k + 0.5), sum);
      }
    }
    sum.mul(1.0 / segment.bits().solidCount(), sum);
    return bodies.poses().get(n).transform(bodies.rest().grid().gridToWorld(sum, sum), sum);
  }

  @Test
  void surfacesStandInTheirPlace() throws IOException {
    CommandRun.of("render", "--scene", scene, "--out", folder.resolve("p.stl"), "--separate")
        .mustSucceed();
    PlacedVolume bodies = bodies();
    for (int n = 0; n < 4; n++) {
      TriangleMesh mesh = MeshFiles.read(folder.resolve("p-fragment" + (n + 1) + ".stl"));
      Vec3 centroid = ToolSampler.ofClosedMesh(mesh, 0.5, 0).referenceMm(new Vec3());
      assertTrue(mesh.isClosed());
      assertTrue(centroid.sub(middle(bodies, n), new Vec3()).length() < 0.3, "fragment " + n);
    }
  }

  @Test
  void theExportShowsTheBodiesWhereTheyStand() throws IOException {
    Path whole = folder.resolve("whole.nrrd");
    CommandRun.of("info", "--scene", scene, "--export", whole).mustSucceed();
    Path report = folder.resolve("r.json");
    CommandRun.of("info", "--volume", whole, "--report", report).mustSucceed();
    Map<String, String> json = FlatJson.read(report);
    for (int n = 0; n < 4; n++) {
      assertEquals(
          Long.toString(bodies().present().segments().get(n).bits().solidCount()),
          json.get("/segments/" + n + "/voxels"));
    }
  }

  @Test
  void simpleItkReadsTheTransformsAsThePosesOfTheScene() throws Exception {
    PlacedVolume bodies = bodies();
    String python = System.getProperty("palpate.python", "python3");
    String script =
        "import sys\n"
            + "try:\n  import SimpleITK as s\n"
            + "except ImportError:\n  sys.exit("
            + WITHOUT_SIMPLEITK
            + ")\n"
            + "t = s.ReadTransform(sys.argv[1])\n"
            + "print(t.GetName(), *[repr(v) for v in t.TransformPoint((10.5, -20.25, 33.0))])\n";
    for (int n = 0; n < 4; n++) {
      String[] words = run(python, script, transforms.resolve("fragment" + (n + 1) + ".tfm"));
      assertEquals("AffineTransform", words[0]);
      Pose pose = bodies.poses().get(n);
      Vec3 expected = pose.transform(new Vec3(10.5, -20.25, 33), new Vec3());
      for (int axis = 0; axis < 3; axis++) {
        assertEquals(expected.get(axis), Double.parseDouble(words[1 + axis]), 1e-12);
      }
    }
  }

  private static String[] run(String python, String script, Path file) throws Exception {
    Process process;
    try {
      process = new ProcessBuilder(python, "-c", script, file.toString()).start();
    } catch (IOException e) {
      Assumptions.abort("skipped: there is no " + python + " (-Dpalpate.python=PYTHON)");
      throw e;
    }
    String out = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertTrue(process.waitFor(60, TimeUnit.SECONDS));
    Assumptions.assumeTrue(
        process.exitValue() != WITHOUT_SIMPLEITK,
        "skipped: SimpleITK is not installed (-Dpalpate.python=PYTHON)");
    assertEquals(0, process.exitValue());
    return out.strip().split(" ", -1);
  }

  @Test
  void wrongUseIsRefusedInOneLine() throws IOException {
    CommandRun.of("info", "--scene", scene, "--volume", folder.resolve("parts.nrrd")).mustRefuse();
    CommandRun.of("info", "--scene", folder.resolve("absent.json")).mustRefuse();
    CommandRun.of("info", "--phantom", "torus:64", "--save-transforms", transforms).mustRefuse();
    CommandRun.of("info", "--phantom", "fracture:64", "--save-scene", scene).mustRefuse();
    Path trajectory = Files.writeString(folder.resolve("t.csv"), "t_ms,x,y,z\n0,1,2,3\n");
    CommandRun.of("replay", "--scene", scene, "--tool", "sphere:2", "--trajectory", trajectory)
        .mustRefuse();
    for (String wrong :
        new String[] {
          "{\"bodies\":[{\"name\":\"a\",\"volume\":\"absent.nrrd\"}]}",
          "{\"bodies\":[{\"name\":\"a\",\"volume\":\"parts.nrrd\",\"segment\":\"label:99\"}]}",
          "{\"bodies\":[{\"name\":\"a\",\"volume\":\"parts.nrrd\",\"segment\":\"?\"}]}",
          "{\"bodies\":[{\"name\":\"a\",\"mesh\":\"a.stl\"}]}"
        }) {
      Path file = Files.writeString(folder.resolve("wrong.json"), wrong);
      CommandRun.of("info", "--scene", file).mustRefuse();
    }
    String same = "\"volume\":\"parts.nrrd\",\"mobility\":\"movable\"";
    String overlapping =
        "{\"bodies\":[{\"name\":\"a\"," + same + "},{\"name\":\"b\"," + same + "}]}";
    Path file = Files.writeString(folder.resolve("wrong.json"), overlapping);
    String line = CommandRun.of("replay", "--scene", file, "--trajectory", trajectory).mustRefuse();
    assertTrue(
        line.startsWith("palpate: the bodies a and b overlap: --scene " + file + ": "), line);
  }

  @Test
  void aSimulatedHandNeedsNoMappingAndIgnoresThatOfTheScene() throws IOException {
    String mapping = "\"device\": {\"scale\": 2, \"axes\": \"view\", \"offset_mm\": [1, 2, 3]}, ";
    String text = Files.readString(scene).replace("\"version\"", mapping + "\"version\"");
    Path file = Files.writeString(folder.resolve("keys.json"), text);
    CommandRun.of("touch", "--scene", file, "--headless", "--seconds", 0.3).mustSucceed();
    CommandRun axes =
        CommandRun.of(
            "touch", "--scene", file, "--headless", "--seconds", 0.3, "--axes", "patient");
    axes.mustSucceed();
  }

  @Test
  void noOutputReplacesTheSceneOrItsVolumes() throws IOException {
    Path parts = folder.resolve("parts.nrrd");
    Path other = folder.resolve("other.nrrd");
    String sceneBefore = Files.readString(scene);
    byte[] partsBefore = Files.readAllBytes(parts);
    for (List<Object> command :
        List.of(
            List.<Object>of("info"), List.<Object>of("touch", "--headless", "--seconds", 0.3))) {
      for (List<Object> outputs :
          List.of(
              List.<Object>of("--export", other, "--save-scene", scene),
              List.<Object>of("--export", parts),
              List.<Object>of("--report", scene))) {
        List<Object> run = new ArrayList<>(command);
        run.addAll(List.of("--scene", scene));
        run.addAll(outputs);
        String line = CommandRun.of(run.toArray()).mustRefuse();
        assertTrue(line.startsWith("palpate: the target is an input: "), line);
      }
    }
    assertEquals(sceneBefore, Files.readString(scene));
    assertArrayEquals(partsBefore, Files.readAllBytes(parts));
  }

  @Test
  void anEndInOrderWritesLocksAndAttachmentsBesideTheScene() throws IOException {
    Path table = folder.resolve("s.groups.csv");
    String groups =
        "body,group,locked\nfragment1,1,0\nfragment2,2,1\nfragment3,3,0\nfragment4,2,1\n";
    Files.writeString(table, groups);
    Path left = folder.resolve("left.json");
    Path leftTable = Files.writeString(folder.resolve("left.groups.csv"), "of an earlier scene");
    Object[] touch = {
      "touch", "--scene", scene, "--headless", "--seconds", 0.3, "--save-scene", left
    };
    String out = CommandRun.of(touch).mustSucceed().out();
    assertTrue(out.contains("written: " + leftTable + ": locks and attachments"), out);
    assertEquals(groups, Files.readString(leftTable));
    String refusal =
        CommandRun.of("info", "--scene", scene, "--save-scene", left, "--report", leftTable)
            .mustRefuse();
    assertTrue(refusal.startsWith("palpate: two outputs have the same file: "), refusal);
    Path namesake = folder.resolve("s");
    for (Object[] outputs : new Object[][] {{"--report", table}, {"--save-scene", namesake}}) {
      List<Object> run = new ArrayList<>(List.of("touch", "--scene", scene, "--headless"));
      run.addAll(List.of("--seconds", 0.3));
      run.addAll(List.of(outputs));
      String line = CommandRun.of(run.toArray()).mustRefuse();
      assertTrue(line.startsWith("palpate: the target is an input: "), line);
      assertTrue(line.contains(table.toString()), line);
    }
    assertEquals(groups, Files.readString(table));
    Files.delete(table);
    out = CommandRun.of(touch).mustSucceed().out();
    assertFalse(out.contains("locks and attachments"), out);
    assertFalse(Files.exists(leftTable), "it would lock fragments of the scene that was saved");
  }

  @Test
  void theToolOfAScenePlaysInItsReplay() throws IOException {
    String text = Files.readString(scene);
    Path file =
        Files.writeString(
            folder.resolve("tool.json"),
            text.substring(0, text.lastIndexOf('}')) + ", \"tool\": {\"spec\": \"sphere:2\"}}");
    Path trajectory = Files.writeString(folder.resolve("t.csv"), "t_ms,x,y,z\n0,1,2,3\n1,1,2,3\n");
    String out =
        CommandRun.of("replay", "--scene", file, "--trajectory", trajectory).mustSucceed().out();
    assertTrue(out.contains("sphere:2"), out);
  }
}
