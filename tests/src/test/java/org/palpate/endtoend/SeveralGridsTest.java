package org.palpate.endtoend;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.SplittableRandom;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.palpate.geometry.Vec3;
import org.palpate.io.scene.BodyReader;
import org.palpate.io.scene.PlacedVolume;
import org.palpate.io.scene.SceneReader;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.testing.Seeds;
import org.palpate.tool.MadeTool;
import org.palpate.tool.ToolMaker;
import org.palpate.tool.ToolRequest;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;
import org.palpate.volume.fracture.PosedBits;

/** A scene of a slab, a finer turned and mirrored ball, and a mesh, each on a grid of its own. */
class SeveralGridsTest {
  private static final int BALL = 1;
  private static final int BOX = 2;
  private static final double BOX_MM3 = 8 * 6 * 10;

  @TempDir private Path folder;

  private Path scene;

  private Path file(String name) {
    return folder.resolve(name);
  }

  @BeforeEach
  void writeScene() throws IOException {
    TestFiles.nrrd(file("slab.nrrd"), 24, v -> v[2] < 3 ? 1 : 0);
    Files.write(file("ball.nrrd"), ball(true));
    Files.write(file("ball-lps.nrrd"), ball(false));
    Files.writeString(file("box.obj"), box());
    scene = writeScene("s.json", "ball.nrrd");
  }

  /** Returns a ball on a turned grid of other voxels, in RAS or, at the same place, in LPS. */
  private static byte[] ball(boolean ras) {
    String place =
        ras
            ? """
            space: right-anterior-superior
            space directions: (-0.48,-0.36,0) (-0.42,0.56,0) (0,0,0.9)
            space origin: (3,12,38)\
            """
            : """
            space: left-posterior-superior
            space directions: (0.48,0.36,0) (0.42,-0.56,0) (0,0,0.9)
            space origin: (-3,-12,38)\
            """;
    return TestFiles.nrrdBytes(
        20, place, v -> Math.hypot(v[0] - 9.5, Math.hypot(v[1] - 9.5, v[2] - 9.5)) < 8 ? 3 : 0);
  }

  /** Returns a box of 8 x 6 x 10 mm in RAS; in LPS its lowest corner is (-9, -8, 40). */
  private static String box() {
    StringBuilder text = new StringBuilder("# SPACE=RAS\n");
    for (int n = 0; n < 8; n++) {
      double x = 9 - (n & 1) * 8;
      double y = 8 - (n >> 1 & 1) * 6;
      text.append(String.format(Locale.ROOT, "v %s %s %s%n", x, y, 40.0 + (n >> 2) * 10));
    }
    int[][] faces = {
      {1, 3, 4, 2}, {5, 6, 8, 7}, {1, 2, 6, 5}, {3, 7, 8, 4}, {1, 5, 7, 3}, {2, 4, 8, 6}
    };
    for (int[] f : faces) {
      text.append(String.format(Locale.ROOT, "f %d %d %d %d%n", f[0], f[1], f[2], f[3]));
    }
    return text.toString();
  }

  private Path writeScene(String name, String ball) throws IOException {
    return Files.writeString(
        file(name),
        "{\"bodies\": [{\"name\": \"slab\", \"volume\": \"slab.nrrd\"},"
            + " {\"name\": \"ball\", \"volume\": \""
            + ball
            + "\", \"segment\": \"label:3\", \"mobility\": \"movable\", \"pose\": {"
            + "\"translation_mm\": [-11, -13.5, 1.5], \"rotation\": [0.8, 0, 0, 0.6]}},"
            + " {\"name\": \"box\", \"mesh\": \"box.obj\", \"material\": \"friction:0.5\"}],"
            + " \"tool\": {\"spec\": \"capsule:1,3\"}}");
  }

  private PlacedVolume bodies() throws IOException {
    return BodyReader.read(SceneReader.read(scene), scene);
  }

  private CommandRun replay(Path ofScene, String suffix) {
    List<Object> arguments = new ArrayList<>(List.of("replay", "--scene", ofScene));
    arguments.addAll(List.of("--trajectory", file("t.csv"), "--report", file("r" + suffix)));
    arguments.addAll(List.of("--out", file("f" + suffix), "--legs", file("l" + suffix)));
    return CommandRun.of(arguments.toArray()).mustSucceed();
  }

  private void writeTrajectory() throws IOException {
    TestFiles.toolTrajectory(
        file("t.csv"), new SplittableRandom(Seeds.seed()), 900, new Vec3(0, -9, 42), 30);
  }

  @Test
  void everyLegIsFreeInTheGridOfItsBody() throws IOException {
    writeTrajectory();
    replay(scene, "1");
    PlacedVolume bodies = bodies();
    MadeTool made =
        ToolMaker.make(
            ToolRequest.parse("capsule:1,3", null, null, null),
            bodies.rest().shortestEdgeMm(),
            CoordinateSystem.LPS);
    ToolLegsFile judge = new ToolLegsFile(bodies.rest(), bodies.poses(), made.tool(), 1);
    judge.judge(file("f1"), file("l1"));
    assertTrue(judge.legs() > 100_000, "legs " + judge.legs());
    Map<String, String> report = FlatJson.read(file("r1"));
    assertTrue(Integer.parseInt(report.get("/contact_frames")) > 50, report.toString());
    assertEquals("[20, 20, 20]", list(report, "/bodies/1/sizes"));
    assertEquals("[0.6, 0.7, 0.9]", list(report, "/bodies/1/spacing_mm"));
  }

  private static String list(Map<String, String> report, String key) {
    return List.of(report.get(key + "/0"), report.get(key + "/1"), report.get(key + "/2"))
        .toString();
  }

  @Test
  void aVolumeInAnotherWorldStandsWhereItsAxesSay() throws IOException {
    writeTrajectory();
    replay(scene, "1");
    replay(writeScene("lps.json", "ball-lps.nrrd"), "2");
    for (String table : new String[] {"f", "l"}) {
      assertArrayEquals(Files.readAllBytes(file(table + 1)), Files.readAllBytes(file(table + 2)));
    }
    VoxelGrid box = bodies().rest().grid(BOX);
    BitCube bits = bodies().rest().segments().get(BOX).bits();
    assertEquals(BOX_MM3 / Math.pow(0.6, 3), (double) bits.solidCount(), 400);
    Vec3 inside = box.worldToGrid(new Vec3(-5, -5, 45), new Vec3());
    assertTrue(bits.get((int) inside.x, (int) inside.y, (int) inside.z));
  }

  @Test
  void theExportHoldsWhatLiesInTheGridOfTheFirstVolume() throws IOException {
    CommandRun run = CommandRun.of("info", "--scene", scene, "--export", file("all.nrrd"));
    String out = run.mustSucceed().out();
    assertTrue(out.contains("own grid  ball: 20 x 20 x 20 voxels of 0.6 x 0.7 x 0.9 mm"), out);
    PlacedVolume bodies = bodies();
    List<PosedBits> placed = PosedBits.of(bodies.rest(), bodies.poses());
    assertEquals(0, placed.get(BALL).voxelsOutside(bodies.rest().grid()));
    CommandRun.of("info", "--volume", file("all.nrrd"), "--report", file("r.json")).mustSucceed();
    Map<String, String> report = FlatJson.read(file("r.json"));
    for (int n = 0; n < 3; n++) {
      VoxelGrid own = bodies.rest().grid(n);
      double voxelMm3 = own.spacingMm().x * own.spacingMm().y * own.spacingMm().z;
      double mm3 = voxelMm3 * placed.get(n).bits().solidCount();
      double exported = 2 * Double.parseDouble(report.get("/segments/" + n + "/voxels"));
      assertEquals(mm3, exported, 0.2 * mm3, "body " + n);
      long present = bodies.present().segments().get(n).bits().solidCount();
      assertEquals(Long.toString(present), report.get("/segments/" + n + "/voxels"));
    }
  }

  @Test
  void aReplayExportsWhatItLeftOnTheGridOfTheFirstVolume() throws IOException {
    Files.writeString(file("t.csv"), "t_ms,x,y,z\n0,0,0,76\n1,0,0,76\n");
    Files.writeString(
        file("p.csv"), "frame,body,x,y,z,qw,qx,qy,qz\n0,ball,-11,-13.5,3.5,0.8,0,0,0.6\n");
    List<Object> replay = new ArrayList<>(List.of("replay", "--scene", scene));
    replay.addAll(List.of("--trajectory", file("t.csv"), "--poses", file("p.csv")));
    replay.addAll(List.of("--export", file("left.nrrd")));
    CommandRun.of(replay.toArray()).mustSucceed();
    String moved = Files.readString(scene).replace("[-11, -13.5, 1.5]", "[-11, -13.5, 3.5]");
    Path there = Files.writeString(file("there.json"), moved);
    CommandRun.of("info", "--scene", there, "--export", file("there.nrrd")).mustSucceed();
    assertArrayEquals(
        Files.readAllBytes(file("there.nrrd")), Files.readAllBytes(file("left.nrrd")));
  }

  @Test
  void aGuideToAFitTakesBodiesOfSeveralGrids() {
    List<Object> fit = new ArrayList<>(List.of("touch", "--scene", scene, "--headless"));
    fit.addAll(List.of("--seconds", 0.3, "--guide", "fit"));
    CommandRun.of(fit.toArray()).mustSucceed();
  }

  @Test
  void aGuideToAFitTakesTheScanOfFragments() throws IOException {
    Path scan = TestFiles.nrrd(file("scan.nrrd"), 24, v -> v[2] == 11 || v[2] == 12 ? 40 : 120);
    Path parts = file("parts.json");
    List<Object> split = new ArrayList<>(List.of("info", "--volume", scan, "--segment"));
    split.addAll(List.of("bone=>=100", "--split", "components:50", "--export"));
    split.addAll(List.of(file("parts.nrrd"), "--save-scene", parts));
    CommandRun.of(split.toArray()).mustSucceed();
    List<Object> fit = new ArrayList<>(List.of("touch", "--scene", parts, "--headless"));
    fit.addAll(List.of("--seconds", 0.3, "--guide", "fit", "--fit-grey"));
    fit.add(scan + ":>=100");
    CommandRun.of(fit.toArray()).mustSucceed();
    fit.set(fit.size() - 1, file("ball.nrrd") + ":>=1");
    String refusal = CommandRun.of(fit.toArray()).mustRefuse();
    assertTrue(refusal.contains("no body has the voxels of the scan"), refusal);
    fit.set(fit.size() - 1, file("missing.nrrd") + ":>=1");
    CommandRun.of(fit.toArray()).mustRefuse();
  }

  @Test
  void marginsAndElasticBodiesNeedOneGrid() throws IOException {
    List<Object> protect = new ArrayList<>(List.of("touch", "--scene", scene, "--headless"));
    protect.addAll(List.of("--seconds", 0.3, "--carve", 5, "--protect", "ball:1"));
    String refusal = CommandRun.of(protect.toArray()).mustRefuse();
    assertTrue(refusal.contains("margins are for bodies of one grid"), refusal);
    String soft =
        "{\"bodies\": [{\"name\": \"slab\", \"volume\": \"slab.nrrd\", \"mobility\": \"elastic\","
            + " \"young_pa\": 20000}, {\"name\": \"ball\", \"volume\": \"ball.nrrd\","
            + " \"segment\": \"label:3\"}]}";
    Path elastic = Files.writeString(file("soft.json"), soft);
    refusal = CommandRun.of("touch", "--scene", elastic, "--headless").mustRefuse();
    assertTrue(refusal.contains("need one grid"), refusal);
  }

  @Test
  void voxelsOutsideTheFirstGridAreNamed() throws IOException {
    String text = Files.readString(scene).replace("[-11, -13.5, 1.5]", "[-11, -13.5, 40]");
    Path far = Files.writeString(file("far.json"), text);
    String out = CommandRun.of("info", "--scene", far).mustSucceed().out();
    assertTrue(out.matches("(?s).* voxels of ball lie outside the grid of the first.*"), out);
    CommandRun.of("touch", "--scene", far, "--headless", "--seconds", 0.3).mustSucceed();
  }

  @Test
  void aSavedSceneNamesTheFilesOfItsBodies() throws IOException {
    Path left = Files.createDirectory(file("out")).resolve("left.json");
    List<Object> touch = new ArrayList<>(List.of("touch", "--scene", scene, "--headless"));
    touch.addAll(List.of("--seconds", 0.3, "--save-scene", left, "--report", file("r.json")));
    CommandRun.of(touch.toArray()).mustSucceed();
    PlacedVolume again = BodyReader.read(SceneReader.read(left), left);
    PlacedVolume before = bodies();
    for (int n = 0; n < 3; n++) {
      assertTrue(again.poses().get(n).sameBits(before.poses().get(n)), "body " + n);
      BitCube bits = before.rest().segments().get(n).bits();
      assertEquals(bits.solidCount(), again.rest().segments().get(n).bits().solidCount());
    }
    assertEquals("capsule:1,3", SceneReader.read(left).tool().orElseThrow().spec());
    String cutting = Files.readString(scene).replace("\"tool\"", "\"carve\": 5, \"tool\"");
    Path cut = Files.writeString(file("cut.json"), cutting);
    List<Object> carve = new ArrayList<>(List.of("touch", "--scene", cut, "--headless"));
    carve.addAll(List.of("--seconds", 0.3, "--save-scene", file("cut-left.json")));
    String refusal = CommandRun.of(carve.toArray()).mustRefuse();
    assertTrue(refusal.contains("would name files without the cuts"), refusal);
  }

  @Test
  void surfacesStandInTheirPlaceWithTheirOutsideOut() throws IOException {
    List<Object> render = List.of("render", "--scene", scene, "--separate", "--out");
    List<Object> all = new ArrayList<>(render);
    all.add(file("p.stl"));
    CommandRun.of(all.toArray()).mustSucceed();
    PlacedVolume bodies = bodies();
    for (int n = 0; n < 3; n++) {
      String name = bodies.rest().segments().get(n).name();
      double mm3 = signedMm3(Files.readAllBytes(file("p-" + name + ".stl")));
      Vec3 s = bodies.rest().grid(n).spacingMm();
      double expected = bodies.rest().segments().get(n).bits().solidCount() * s.x * s.y * s.z;
      assertEquals(expected, mm3, 0.06 * expected, name);
    }
  }

  /** Returns the volume of a binary STL file, negative if its triangles face inward. */
  private static double signedMm3(byte[] stl) {
    ByteBuffer in = ByteBuffer.wrap(stl).order(ByteOrder.LITTLE_ENDIAN);
    double sum = 0;
    for (int at = 84; at < stl.length; at += 50) {
      Vec3[] c = new Vec3[3];
      for (int n = 0; n < 3; n++) {
        int p = at + 12 + 12 * n;
        c[n] = new Vec3(in.getFloat(p), in.getFloat(p + 4), in.getFloat(p + 8));
      }
      sum += c[0].dot(c[1].cross(c[2], new Vec3())) / 6;
    }
    return sum;
  }
}
