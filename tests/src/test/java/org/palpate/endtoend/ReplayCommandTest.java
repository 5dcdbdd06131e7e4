package org.palpate.endtoend;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class ReplayCommandTest {
  private static final String FRAMES_HEADER = "frame,t_ms,dx,dy,dz,px,py,pz,fx,fy,fz,contact,path";

  @TempDir private Path folder;
  private Path trajectory;

  @BeforeEach
  void makeTrajectory() throws IOException {
    trajectory = TestFiles.trajectory(folder.resolve("t.csv"), 400, 48, 20130701);
  }

  private Path file(String name) {
    return folder.resolve(name);
  }

  private CommandRun replay(Object... more) {
    List<Object> arguments = new ArrayList<>(List.of("replay", "--phantom", "sphere:48"));
    arguments.addAll(List.of("--trajectory", trajectory));
    arguments.addAll(List.of(more));
    return CommandRun.of(arguments.toArray());
  }

  private static double[][] rows(Path csv) throws IOException {
    return Files.readAllLines(csv).stream()
        .skip(1)
        .map(
            line ->
                java.util.Arrays.stream(line.split(",")).mapToDouble(Double::parseDouble).toArray())
        .toArray(double[][]::new);
  }

  @ParameterizedTest
  @ValueSource(strings = {"dot", "paper", "guarded", "smooth", "none"})
  void writesTheSameBytesTwice(String solver) throws IOException {
    for (String name : new String[] {"a", "b"}) {
      replay("--solver", solver, "--out", file(name + "f"), "--legs", file(name + "l"))
          .mustSucceed();
    }
    assertArrayEquals(Files.readAllBytes(file("af")), Files.readAllBytes(file("bf")));
    assertArrayEquals(Files.readAllBytes(file("al")), Files.readAllBytes(file("bl")));
  }

  @ParameterizedTest
  @ValueSource(strings = {"dot", "paper"})
  void writesTheSameBytesWithPrecalculatedBorderVoxels(String solver) throws IOException {
    for (String border : new String[] {"on-the-fly", "precalculated"}) {
      Path frames = file(border + ".csv");
      Path legs = file(border + "-legs.csv");
      replay("--solver", solver, "--border", border, "--out", frames, "--legs", legs).mustSucceed();
    }
    assertArrayEquals(
        Files.readAllBytes(file("on-the-fly.csv")), Files.readAllBytes(file("precalculated.csv")));
    assertArrayEquals(
        Files.readAllBytes(file("on-the-fly-legs.csv")),
        Files.readAllBytes(file("precalculated-legs.csv")));
  }

  @Test
  void writesTheSameBytesOnALaterJdkInAnotherLocale() throws IOException, InterruptedException {
    Path later = laterJdk();
    replay("--out", file("a"), "--legs", file("al"), "--solver", "smooth").mustSucceed();
    CommandRun.waitFor(
            CommandRun.inOwnJvm(
                later,
                List.of("-Duser.language=de", "-Duser.country=DE"),
                "replay",
                "--phantom",
                "sphere:48",
                "--trajectory",
                trajectory,
                "--solver",
                "smooth",
                "--out",
                file("b"),
                "--legs",
                file("bl")))
        .mustSucceed();
    assertArrayEquals(Files.readAllBytes(file("a")), Files.readAllBytes(file("b")));
    assertArrayEquals(Files.readAllBytes(file("al")), Files.readAllBytes(file("bl")));
  }

  private static Path laterJdk() throws IOException {
    Path folder = Path.of("/usr/lib/jvm");
    Assumptions.assumeTrue(Files.isDirectory(folder), "skipped: there is no " + folder);
    try (var homes = Files.list(folder)) {
      for (Path home : homes.sorted().toList()) {
        Path release = home.resolve("release");
        boolean is25 =
            Files.isRegularFile(release) && Files.readString(release).contains("JAVA_VERSION=\"25");
        if (is25) {
          return home;
        }
      }
    }
    Assumptions.abort("skipped: no JDK 25 in " + folder);
    return folder;
  }

  @Test
  void aMaterialOfTheOnlySegmentEqualsTheOptionsForAll() throws IOException {
    replayWithLongSteps("--stiffness", 1.25, "--friction", 0.4, "--out", file("a"));
    replayWithLongSteps("--material", "sphere=stiffness:1.25,friction:0.4", "--out", file("b"));
    assertArrayEquals(Files.readAllBytes(file("a")), Files.readAllBytes(file("b")));
  }

  @Test
  void aSofterMaterialGivesASmallerForce() throws IOException {
    replayWithLongSteps("--out", file("a"));
    replayWithLongSteps("--material", "sphere=stiffness:0.1", "--out", file("b"));
    assertEquals(largestForce("a") / 5, largestForce("b"), 1e-9);
  }

  /** Uses a long w_max, so that the point lags behind the device only in contact. */
  private void replayWithLongSteps(Object... more) {
    List<Object> arguments = new ArrayList<>(List.of("--max-step", "100"));
    arguments.addAll(List.of(more));
    replay(arguments.toArray()).mustSucceed();
  }

  private double largestForce(String name) throws IOException {
    double largest = 0;
    for (double[] row : rows(file(name))) {
      largest = Math.max(largest, Math.hypot(row[8], Math.hypot(row[9], row[10])));
    }
    return largest;
  }

  @Test
  void legsFormOneChainThatEndsAtEachFramesPoint() throws IOException {
    replay("--coordinates", "grid", "--out", file("f"), "--legs", file("l")).mustSucceed();
    double[][] frames = rows(file("f"));
    double[][] legs = rows(file("l"));
    assertTrue(legs.length > 300, "legs: " + legs.length);
    for (int n = 1; n < legs.length; n++) {
      for (int axis = 0; axis < 3; axis++) {
        assertEquals(legs[n - 1][5 + axis], legs[n][2 + axis], "start of row " + n);
      }
      boolean lastOfFrame = n + 1 == legs.length || legs[n + 1][0] != legs[n][0];
      if (lastOfFrame) {
        double[] frame = frames[(int) legs[n][0]];
        assertArrayEquals(
            new double[] {frame[5], frame[6], frame[7]},
            new double[] {legs[n][5], legs[n][6], legs[n][7]});
      }
    }
  }

  @Test
  void theForceIsThatOfTheSpringWithoutFriction() throws IOException {
    replay("--solver", "guarded", "--out", file("f"), "--friction", "0", "--stiffness", "2")
        .mustSucceed();
    int contacts = 0;
    for (double[] row : rows(file("f"))) {
      for (int axis = 0; axis < 3; axis++) {
        assertEquals(2 * (row[5 + axis] - row[2 + axis]), row[8 + axis]);
      }
      contacts += (int) row[11];
    }
    assertTrue(contacts > 50, "frames in contact: " + contacts);
  }

  @Test
  void maxForceIsTheOnlyLimitOfTheForce() throws IOException {
    replay("--out", file("f"), "--max-force", "0.75").mustSucceed();
    double longest = 0;
    for (double[] row : rows(file("f"))) {
      longest = Math.max(longest, Math.sqrt(row[8] * row[8] + row[9] * row[9] + row[10] * row[10]));
    }
    assertTrue(longest <= 0.75 && longest > 0.7499, "longest force: " + longest);
  }

  @Test
  void worldAndGridAgreeIfTheyAreTheSame() throws IOException {
    replay("--out", file("world")).mustSucceed();
    replay("--out", file("grid"), "--coordinates", "grid").mustSucceed();
    double[][] world = rows(file("world"));
    double[][] grid = rows(file("grid"));
    assertEquals(world.length, grid.length);
    for (int n = 0; n < world.length; n++) {
      assertArrayEquals(grid[n], world[n], 1e-11, "up to rounding, row " + n);
    }
  }

  @Test
  void worldPositionsAreMappedToTheGridByTheFilesAxes() throws IOException {
    Path volume = TestFiles.nrrd(file("v.nrrd"), 24, v -> v[2] < 12 ? 1 : 0);
    // z of the surface is 30 (centre of voxel 0) - 1 (half a voxel) + 12 * 2
    Path down =
        Files.writeString(file("down.csv"), "t_ms,x,y,z\n0,0,-10,60\n1,0,-10,50\n2,0,-10,49\n");
    CommandRun.of(
            "replay",
            "--volume",
            volume,
            "--trajectory",
            down,
            "--solver",
            "guarded",
            "--max-step",
            "100",
            "--out",
            file("f"))
        .mustSucceed();
    double[] last = rows(file("f"))[2];
    assertEquals(1, last[11], "contact");
    assertEquals(53, last[7], 1e-5);
    assertEquals(0.5 * 4, last[10], 1e-5);
    assertEquals(0, last[8], 1e-9);
  }

  @Test
  void aStartInASolidMovesToTheNearestEmptyVoxelAndRampsTheForce() throws IOException {
    Path volume = TestFiles.nrrd(file("v.nrrd"), 24, v -> v[2] < 12 ? 1 : 0);
    // In grid coordinates the nearest empty centre is straight up; also in mm, with 2 mm along z.
    Path inside =
        Files.writeString(
            file("in.csv"), "t_ms,x,y,z\n0,12.5,12.5,10.5\n1,12.5,12.5,10.5\n400,12.5,12.5,10.5\n");
    CommandRun.of(
            "replay",
            "--volume",
            volume,
            "--trajectory",
            inside,
            "--solver",
            "guarded",
            "--coordinates",
            "grid",
            "--legs",
            file("l"),
            "--out",
            file("f"))
        .mustSucceed();
    assertEquals("0,-1,12.5,12.5,12.5,12.5,12.5,12.5", Files.readAllLines(file("l")).get(1));
    double[][] frames = rows(file("f"));
    assertEquals(0, frames[0][10], "force of the first frame");
    assertTrue(frames[1][10] > 0 && frames[1][10] < 0.05, "ramped: " + frames[1][10]);
    assertEquals(0.5 * 2 * (frames[2][7] - 10.5), frames[2][10], 1e-12);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "t_ms,x,y,z\\n0,1,2,3\\n1,NaN,2,3 | line 3",
        "t_ms,x,y,z\\n0,1,2,3\\n1,1,inf,3 | line 3",
        "t_ms,x,y,z\\n5,1,2,3\\n4,1,2,3 | line 3",
        "t_ms,x,y,z\\n0,1,2 | line 2",
        "t_ms,x,y,z\\n0,1,2,three | line 2",
        "x,y,z\\n1,2,3 | t_ms",
        "t_ms,x,y,z | no sample",
      })
  void refusesAWrongTrajectoryWithItsLine(String text, String expected) throws IOException {
    Path bad = Files.writeString(file("bad.csv"), text.replace("\\n", "\n"));
    String line =
        CommandRun.of("replay", "--phantom", "sphere:48", "--trajectory", bad).mustRefuse();
    assertTrue(line.contains(expected), line);
  }

  @Test
  void treatsARawDeviceAsALiveSessionDoes() throws IOException {
    StringBuilder text = new StringBuilder("t_ms,x,y,z\n");
    for (int n = 0; n < 120; n++) {
      String x = n >= 40 && n < 80 ? "NaN" : "24";
      text.append(
          String.format(Locale.ROOT, "%d,%s,24,%d%n", n == 100 ? 5 : n, x, n < 5 ? 60 : 40));
    }
    Path raw = Files.writeString(file("raw.csv"), text.toString());
    CommandRun.of(
            "replay",
            "--phantom",
            "sphere:48",
            "--trajectory",
            raw,
            "--raw-device",
            "--out",
            file("f"),
            "--report",
            file("r"))
        .mustSucceed();
    double[][] frames = rows(file("f"));
    assertEquals(120, frames.length);
    assertEquals(frames[39][10], frames[50][10], "held");
    assertEquals(0, frames[79][10], "silent");
    assertTrue(frames[85][10] < frames[39][10], "ramped back");
    Map<String, String> json = FlatJson.read(file("r"));
    assertEquals("40", json.get("/faults/not_finite"));
    assertEquals("1", json.get("/faults/silences"));
  }

  @Test
  void reportsTheFieldsOfTheContract() throws IOException {
    replay("--report", file("r"), "--repeat", "4").mustSucceed();
    Map<String, String> json = FlatJson.read(file("r"));
    assertEquals("400", json.get("/frames"));
    assertEquals("smooth", json.get("/solver"));
    assertEquals("exact", json.get("/collision"));
    for (String field :
        new String[] {
          "/contact_frames",
          "/freed",
          "/max_force_n",
          "/skipped/friction",
          "/sha256",
          "/segments/0/voxels"
        }) {
      assertTrue(json.containsKey(field), field + " is not in " + json);
    }
    double min = Double.parseDouble(json.get("/ns_per_frame/min"));
    double median = Double.parseDouble(json.get("/ns_per_frame/median"));
    double max = Double.parseDouble(json.get("/ns_per_frame/max"));
    assertTrue(min > 0 && min <= median && median <= max, json.toString());
  }

  @Test
  void collisionAloneKeepsThePointAtTheDevice() throws IOException {
    replay("--solver", "none", "--out", file("f")).mustSucceed();
    boolean hit = false;
    for (double[] row : rows(file("f"))) {
      assertArrayEquals(
          new double[] {row[2], row[3], row[4]}, new double[] {row[5], row[6], row[7]});
      hit |= row[11] == 1;
    }
    assertTrue(hit, "no move hit the sphere");
  }

  @Test
  void tablesHaveTheirHeadersAndShortestDecimals() throws IOException {
    replay("--out", file("f"), "--legs", file("l")).mustSucceed();
    assertEquals(FRAMES_HEADER, Files.readAllLines(file("f")).get(0));
    assertEquals("frame,leg,x0,y0,z0,x1,y1,z1", Files.readAllLines(file("l")).get(0));
    String given = Files.readAllLines(trajectory).get(1).split(",", -1)[1];
    assertEquals(Double.parseDouble(given), rows(file("f"))[0][2]);
  }

  @Test
  void aFailureLeavesTheTargetUnchanged() throws IOException {
    Path target = Files.writeString(file("f"), "precious");
    Path bad = Files.writeString(file("bad.csv"), "t_ms,x,y,z\n0,1,2,3\n1,NaN,2,3\n");
    CommandRun.of("replay", "--phantom", "sphere:48", "--trajectory", bad, "--out", target)
        .mustRefuse();
    assertEquals("precious", Files.readString(target));
    try (var files = Files.list(folder)) {
      assertFalse(files.anyMatch(file -> file.toString().endsWith(".new")), "left a new file");
    }
  }
}
