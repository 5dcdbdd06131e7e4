package org.palpate.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.palpate.geometry.Vec3;
import org.palpate.io.VolumeFiles;
import org.palpate.io.volume.ReadOptions;
import org.palpate.testing.Scans;
import org.palpate.volume.VoxelGrid;

class FractureCommandTest {
  @TempDir private Path folder;

  @Test
  void aPhantomHasASegmentForEachFragment() throws IOException {
    Path report = folder.resolve("r.json");
    CommandRun.of("info", "--phantom", "fracture:64:5:7:0", "--report", report).mustSucceed();
    Map<String, String> json = FlatJson.read(report);
    assertEquals("phantom fracture:64:5:7:0", json.get("/volume"));
    for (int n = 0; n < 5; n++) {
      assertEquals("fragment" + (n + 1), json.get("/segments/" + n + "/name"));
      assertTrue(Integer.parseInt(json.get("/segments/" + n + "/voxels")) > 64);
    }
    assertFalse(json.containsKey("/segments/5/name"));
  }

  @Test
  void theOnlySegmentOfAVolumeIsCutIntoLabels() throws IOException {
    Path parts = folder.resolve("parts.nrrd");
    Path report = folder.resolve("r.json");
    CommandRun.of("info", "--phantom", "torus:64", "--fracture", "4:9:0", "--export", parts)
        .mustSucceed();
    CommandRun.of("info", "--volume", parts, "--report", report).mustSucceed();
    Map<String, String> cut = FlatJson.read(report);
    CommandRun.of("info", "--phantom", "torus:64", "--report", report).mustSucceed();
    long sum = 0;
    for (int n = 0; n < 4; n++) {
      assertEquals("fragment" + (n + 1), cut.get("/segments/" + n + "/name"));
      sum += Long.parseLong(cut.get("/segments/" + n + "/voxels"));
    }
    assertEquals(FlatJson.read(report).get("/segments/0/voxels"), Long.toString(sum));
  }

  @Test
  void theJawOfAScanIsCut() throws IOException {
    Path labels = Scans.file("labels/HN-Atlas-labels.nrrd");
    Path parts = folder.resolve("parts.nii.gz");
    String out =
        CommandRun.of(
                "info",
                "--volume",
                labels,
                "--segment",
                "jaw=label:25",
                "--fracture",
                "8:2",
                "--export",
                parts)
            .mustSucceed()
            .out();
    assertTrue(out.contains("fragment8"), out);
  }

  @Test
  void aPlaneAndComponentsSplitASegment() throws IOException {
    Path parts = folder.resolve("parts.nrrd");
    Path again = folder.resolve("again.nrrd");
    Path report = folder.resolve("r.json");
    CommandRun.of(
            "info", "--phantom", "sphere:32", "--split", "plane:16,16,16,1,0,0", "--export", parts)
        .mustSucceed();
    CommandRun.of(
            "info",
            "--volume",
            parts,
            "--segment",
            "one=label:1",
            "--split",
            "components",
            "--export",
            again)
        .mustSucceed();
    CommandRun.of("info", "--volume", parts, "--report", report).mustSucceed();
    String voxels = FlatJson.read(report).get("/segments/0/voxels");
    CommandRun.of("info", "--volume", again, "--report", report).mustSucceed();
    assertEquals(voxels, FlatJson.read(report).get("/segments/0/voxels"));
    assertFalse(FlatJson.read(report).containsKey("/segments/1/name"));
  }

  @Test
  void aToolPassesThroughAGhostAndTouchesTheSameVoxelsAsABody() throws IOException {
    Path plate = folder.resolve("plate.nrrd");
    Path block = folder.resolve("block.nrrd");
    TestFiles.nrrd(plate, 16, v -> v[2] == 2 ? 1 : 0);
    TestFiles.nrrd(block, 16, v -> v[2] >= 4 && v[2] < 12 ? 1 : 0);
    VoxelGrid grid = VolumeFiles.open(block, ReadOptions.defaults()).header().grid();
    StringBuilder rows = new StringBuilder("t_ms,x,y,z\n");
    for (int ms = 0; ms <= 1500; ms++) {
      Vec3 at = grid.gridToWorld(new Vec3(8.5, 8.5, 15 - ms / 125.0), new Vec3());
      rows.append(ms + "," + at.x + "," + at.y + "," + at.z + "\n");
    }
    Path down = Files.writeString(folder.resolve("down.csv"), rows);
    Path report = folder.resolve("r.json");
    String body = "{\"name\":\"%s\",\"volume\":\"%s.nrrd\",\"mobility\":\"movable\"}";
    String bodies = "{\"bodies\":[" + String.format(body, "plate", "plate") + "%s]}";
    Path one = Files.writeString(folder.resolve("one.json"), String.format(bodies, ""));
    Path two =
        Files.writeString(
            folder.resolve("two.json"),
            String.format(bodies, "," + String.format(body, "block", "block")));
    List<Object> touch = new ArrayList<>(List.of("touch", "--device", "replay:" + down));
    touch.addAll(List.of("--headless", "--seconds", 2, "--report", report, "--scene"));
    List<Object> solid = new ArrayList<>(touch);
    solid.add(two);
    CommandRun.of(solid.toArray()).mustSucceed();
    assertTrue(Integer.parseInt(FlatJson.read(report).get("/contact_frames")) > 0);
    touch.addAll(List.of(one, "--ghost", block + ":label:1"));
    String out = CommandRun.of(touch.toArray()).mustSucceed().out();
    Map<String, String> json = FlatJson.read(report);
    assertEquals("0", json.get("/contact_frames"));
    assertEquals("plate", json.get("/fracture/ghosts/0/body"));
    assertTrue(out.contains("plate to ghost: "), out);
    assertFalse(json.containsKey("/segments/1/name"), "a ghost is no segment that is touched");
  }

  /** A brush erases a plate along a line, and the two halves become fragments. */
  @Test
  void aPaintedCutSplitsASegment() throws IOException {
    Path plate = folder.resolve("plate.nrrd");
    TestFiles.nrrd(
        plate, 16, v -> v[0] > 1 && v[0] < 14 && v[1] > 1 && v[1] < 14 && v[2] == 8 ? 1 : 0);
    VoxelGrid grid = VolumeFiles.open(plate, ReadOptions.defaults()).header().grid();
    StringBuilder rows = new StringBuilder("t_ms,x,y,z\n");
    for (int ms = 0; ms <= 1500; ms++) {
      Vec3 at = grid.gridToWorld(new Vec3(8, ms / 100.0, 8.5), new Vec3());
      rows.append(ms + "," + at.x + "," + at.y + "," + at.z + "\n");
    }
    Path line = Files.writeString(folder.resolve("line.csv"), rows);
    Path cut = folder.resolve("cut.nrrd");
    List<Object> paint =
        new ArrayList<>(List.of("touch", "--volume", plate, "--segment", "a=nonzero"));
    paint.addAll(List.of("--brush", 1.5, "--paint", "erase", "--device", "replay:" + line));
    paint.addAll(List.of("--headless", "--seconds", 2, "--export", cut));
    CommandRun.of(paint.toArray()).mustSucceed();
    Path parts = folder.resolve("parts.nrrd");
    Path report = folder.resolve("r.json");
    CommandRun.of("info", "--volume", cut, "--split", "components:20", "--export", parts)
        .mustSucceed();
    CommandRun.of("info", "--volume", parts, "--report", report).mustSucceed();
    Map<String, String> json = FlatJson.read(report);
    assertTrue(Integer.parseInt(json.get("/segments/0/voxels")) >= 40, json.toString());
    assertTrue(Integer.parseInt(json.get("/segments/1/voxels")) >= 40, json.toString());
    assertFalse(json.containsKey("/segments/2/name"), json.toString());
  }

  @Test
  void anExportIsCroppedAndResampled() throws IOException {
    Path small = folder.resolve("small.nrrd");
    Path report = folder.resolve("r.json");
    CommandRun.of(
            "info",
            "--phantom",
            "sphere:32:grey",
            "--crop",
            "2..21,0..31,4..23",
            "--resample",
            "2,1,0.5",
            "--export",
            small)
        .mustSucceed();
    CommandRun.of("info", "--volume", small, "--report", report).mustSucceed();
    Map<String, String> json = FlatJson.read(report);
    assertEquals("10", json.get("/sizes/0"));
    assertEquals("32", json.get("/sizes/1"));
    assertEquals("40", json.get("/sizes/2"));
  }

  @Test
  void theReadingsOfAPhantomInPlaceAreThoseOfItsKerf() throws IOException {
    Path parts = folder.resolve("parts.nrrd");
    Path scene = folder.resolve("s.json");
    Path report = folder.resolve("r.json");
    CommandRun.of(
            "info",
            "--phantom",
            "torus:96",
            "--fracture",
            "2:3:1",
            "--export",
            parts,
            "--save-scene",
            scene)
        .mustSucceed();
    String placed = Files.readString(scene).replaceAll("\"pose\" : \\{[^}]*\\}", "\"pose\" : {}");
    Files.writeString(scene, placed);
    CommandRun.of("info", "--scene", scene, "--report", report).mustSucceed();
    Map<String, String> json = FlatJson.read(report);
    assertEquals(0, Double.parseDouble(json.get("/fracture/residual_mm")));
    assertEquals("0", json.get("/fracture/overlap_voxels"));
    double gap = Double.parseDouble(json.get("/fracture/pairs/0/gap_mean_mm"));
    assertTrue(gap > 1 && gap < 2, "gap " + gap);
  }

  @Test
  void aSessionIsGuidedToAFit() throws IOException {
    Path report = folder.resolve("r.json");
    CommandRun.of(
            "touch",
            "--phantom",
            "fracture:64:2:3:1",
            "--guide",
            "fit:1",
            "--headless",
            "--seconds",
            "12",
            "--report",
            report)
        .mustSucceed();
    Map<String, String> json = FlatJson.read(report);
    assertTrue(Double.parseDouble(json.get("/fracture/residual_mm")) < 0.5, json.toString());
    double heldAfter = Double.parseDouble(json.get("/first_hold_s"));
    double forceOn = Double.parseDouble(json.get("/force_on_s"));
    assertTrue(heldAfter > forceOn && heldAfter < forceOn + 12, heldAfter + " after " + forceOn);
  }

  /** The plan of this fracture takes many seconds, and the session waits for it. */
  @Test
  @EnabledOnOs(value = OS.LINUX, disabledReason = "skipped: no /proc on this system")
  void aSignalWhileTheHandIsPlannedEndsTheSessionInOrder()
      throws IOException, InterruptedException {
    Path out = folder.resolve("out.txt");
    Path report = folder.resolve("r.json");
    Process process =
        CommandRun.inOwnJvm(
                Path.of(System.getProperty("java.home")),
                List.of(),
                "touch",
                "--phantom",
                "fracture:256:8",
                "--headless",
                "--report",
                report)
            .redirectErrorStream(true)
            .redirectOutput(out.toFile())
            .start();
    try {
      while (process.isAlive() && !ProcessThreads.has(process.pid(), "palpate-haptic")) {
        Thread.onSpinWait();
      }
      process.destroy(); // SIGTERM, as Ctrl-C is SIGINT
      assertTrue(process.waitFor(60, TimeUnit.SECONDS), "the process does not end");
    } finally {
      process.destroyForcibly();
    }
    String said = Files.readString(out);
    assertEquals(0, process.exitValue(), said);
    assertTrue(said.contains("planning how a simulated hand"), said);
    assertFalse(said.contains("force is on"), said);
    assertFalse(said.contains("Exception"), said);
    Map<String, String> json = FlatJson.read(report);
    assertEquals("stopped", json.get("/end"));
    assertEquals("0", json.get("/frames"));
    assertEquals("null", json.get("/force_on_s"));
  }

  @Test
  void wrongUseIsRefusedInOneLine() {
    Path parts = folder.resolve("parts.nrrd");
    CommandRun.of("info", "--phantom", "torus:64", "--fracture", "4").mustRefuse();
    for (String fracture : new String[] {"1", "9", "4:x", "4:1:5", "", "4:1:1:1"}) {
      CommandRun.of("info", "--phantom", "torus:64", "--fracture", fracture, "--export", parts)
          .mustRefuse();
    }
    for (String split : new String[] {"", "plane:1,2,3", "components:x", "components:1:7"}) {
      CommandRun.of("info", "--phantom", "torus:64", "--split", split, "--export", parts)
          .mustRefuse();
    }
    CommandRun.of("info", "--phantom", "torus:64", "--crop", "0..9,0..9,0..9").mustRefuse();
    CommandRun.of("info", "--phantom", "torus:64", "--crop", "0..99,0..9,0..9", "--export", parts)
        .mustRefuse();
    CommandRun.of("touch", "--phantom", "torus:64", "--resample", "1", "--headless").mustRefuse();
    CommandRun.of("info", "--phantom", "head:64", "--fracture", "4", "--export", parts)
        .mustRefuse();
    for (String phantom :
        new String[] {"fracture:10", "fracture:x", "fracture:64:9", "fractures"}) {
      CommandRun.of("info", "--phantom", phantom).mustRefuse();
    }
  }

  /** The option is named although --export is missing too, or the file, or bodies to fit. */
  @Test
  void anOptionThatIsNotUnderstoodIsNamedBeforeOneThatIsMissing() {
    assertRefused("fracture not understood: --fracture 4:x", "--fracture", "4:x");
    assertRefused(
        "fracture not understood: --fracture 4:x", "--fracture", "4:x", "--volume", "missing.nrrd");
    assertRefused("the split is not understood", "--split", "plane:1,2,3");
    assertRefused("the split is not understood", "--split", "halves", "--fracture", "4");
    assertRefused("the width of the gap", "--fit", "-1");
    assertRefused("the width of the gap", "--fit", "-1", "--scene", "missing.json");
    assertRefused("the box is not understood", "--crop", "1..2,x", "--phantom", "torus:64");
    assertRefused(
        "the box is not understood or leaves the volume",
        "--crop",
        "0..64,0..9,0..9",
        "--phantom",
        "torus:64");
    assertRefused("the voxels are not understood", "--resample", "0", "--phantom", "torus:64");
    assertRefused("the plane is not understood", "--mirror", "1,2,3", "--phantom", "sphere:16");
    assertRefused("--raw 1x2", "--raw", "1x2");
  }

  private static void assertRefused(String expected, String... arguments) {
    List<Object> info = new ArrayList<>(List.of("info"));
    info.addAll(List.of(arguments));
    String said = CommandRun.of(info.toArray()).mustRefuse();
    assertTrue(said.contains(expected), said);
    assertFalse(said.contains("without a file"), said);
  }

  @Test
  void segmentsOfTheBrokenPhantomAreTouchedAsTheyAreChosen() throws IOException {
    Path report = folder.resolve("r.json");
    List<Object> touch = new ArrayList<>(List.of("touch", "--phantom", "fracture:64"));
    touch.addAll(List.of("--segment", "all=nonzero", "--headless", "--seconds", 0.3));
    touch.addAll(List.of("--report", report));
    CommandRun.of(touch.toArray()).mustSucceed();
    Map<String, String> json = FlatJson.read(report);
    assertEquals("all", json.get("/segments/0/name"));
    assertFalse(json.containsKey("/fracture/residual_mm"), json.toString());
  }
}
