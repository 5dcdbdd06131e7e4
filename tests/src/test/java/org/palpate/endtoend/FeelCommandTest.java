package org.palpate.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Guides and effects in the commands. */
class FeelCommandTest {
  @TempDir Path folder;

  /** Writes a hand that rests far from the ball of {@code sphere:32} and returns its file. */
  private Path resting() throws IOException {
    StringBuilder rows = new StringBuilder("t_ms,x,y,z\n");
    for (int n = 0; n < 400; n++) {
      rows.append(n).append(",-5,4,40\n");
    }
    return Files.writeString(folder.resolve("t.csv"), rows.toString());
  }

  private double[] lastForce(Object... options) throws IOException {
    Path out = folder.resolve("f.csv");
    List<Object> replay = new ArrayList<>(List.of("replay", "--phantom", "sphere:32"));
    replay.addAll(List.of("--trajectory", resting(), "--out", out, "--stiffness", 0.5));
    replay.addAll(List.of(options));
    CommandRun.of(replay.toArray()).mustSucceed();
    List<String> rows = Files.readAllLines(out);
    List<String> header = List.of(rows.get(0).split(",", -1));
    String[] last = rows.get(rows.size() - 1).split(",", -1);
    double[] force = new double[3];
    for (int axis = 0; axis < 3; axis++) {
      force[axis] = Double.parseDouble(last[header.indexOf("f" + "xyz".charAt(axis))]);
    }
    return force;
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "axis:-5,0,0,0,0,1 | point | 0 | -1 | 0",
        "axis:-5,0,0,0,0,1 | sphere:2 | 0 | -1 | 0",
        "plane:0,0,42,0,0,1 | point | 0 | 0 | 0.5",
        "sphere:-5,0,40,1 | sphere:2 | 0 | -0.75 | 0",
        "hinge:0,0,0,0,0,1 | point | 0 | 0 | 0",
        "hinge:0,0,0,0,0,1 | sphere:2 | 0 | 0 | 0",
        "align:1,0,0 | sphere:2 | 0 | 0 | 0",
        "away:sphere,60 | point | -2 | 2 | 2"
      })
  void aGuidePullsAHandInEmptySpace(String guide, String tool, double x, double y, double z)
      throws IOException {
    double[] force = lastForce("--guide", guide, "--tool", tool);
    if (guide.startsWith("away")) {
      assertEquals(2, Math.hypot(Math.hypot(force[0], force[1]), force[2]), 0.1, "the largest");
      assertTrue(force[0] * x > 0 && force[2] * z > 0, "away from the ball");
    } else {
      assertEquals(x, force[0], 1e-9);
      assertEquals(y, force[1], 1e-9);
      assertEquals(z, force[2], 1e-9);
    }
  }

  @Test
  void strengthAndRangeOfAGuideCanBeChosen() throws IOException {
    String plane = "plane:0,0,30,0,0,1";
    assertEquals(-2, lastForce("--guide", plane)[2], 1e-12);
    assertEquals(-2.5, lastForce("--guide", plane, "--guide-force", 9)[2], 1e-12);
    assertEquals(-1, lastForce("--guide", plane, "--guide-stiffness", 0.1)[2], 1e-12);
    assertEquals(0, lastForce("--guide", plane, "--guide-range", 9.5)[2], 1e-12);
    double[] both = lastForce("--guide", plane, "--guide", "plane:-6,0,0,1,0,0");
    assertEquals(-2, both[2], 1e-12);
    assertEquals(-0.25, both[0], 1e-12);
  }

  @Test
  void aPathComesFromATableOfPositions() throws IOException {
    Path path =
        Files.writeString(
            folder.resolve("path.csv"), "name,x,y,z\nentry,-5,0,0\ntarget,-5,0,100\n");
    assertEquals(-1, lastForce("--guide", "path:" + path)[1], 1e-12);
    assertEquals(-1, lastForce("--guide", "path:" + path, "--tool", "sphere:2")[1], 1e-12);
  }

  @Test
  void faultsOfAPathAreOneLineThatNamesIt() throws IOException {
    Path one = Files.writeString(folder.resolve("one.csv"), "x,y,z\n1,2,3\n");
    Path bad = Files.writeString(folder.resolve("bad.csv"), "x,y,z\n1,2,3\n1,NaN,3\n");
    Path other = Files.writeString(folder.resolve("other.csv"), "a,b\n1,2\n");
    for (Path path : List.of(one, bad, other, folder.resolve("none.csv"))) {
      Object[] replay = {
        "replay", "--phantom", "sphere:32", "--trajectory", resting(), "--guide", "path:" + path
      };
      String said = CommandRun.of(replay).mustRefuse();
      assertTrue(said.contains(path.getFileName().toString()), said);
    }
  }

  @Test
  void aLiveSessionIsGuided() throws IOException {
    Path report = folder.resolve("r.json");
    List<Object> touch = new ArrayList<>(List.of("touch", "--phantom", "sphere:32", "--headless"));
    touch.addAll(List.of("--seconds", 1, "--report", report, "--max-force", 0.75));
    touch.addAll(List.of("--guide", "plane:16,16,90,0,0,1", "--stiffness", 1e-6));
    touch.addAll(List.of("--guide-stiffness", 1));
    CommandRun.of(touch.toArray()).mustSucceed();
    String text = Files.readString(report);
    assertTrue(text.contains("\"max_force_n\" : 0.7"), text); // of contact there is next to none
  }

  /** Writes a hand that slides over the ball of {@code sphere:32} and returns its file. */
  private Path sliding() throws IOException {
    StringBuilder rows = new StringBuilder("t_ms,x,y,z\n");
    for (int n = 0; n < 600; n++) {
      rows.append(n).append(',').append(10 + 0.02 * n).append(",16,");
      rows.append(n < 200 ? 35 - 0.05 * n : 25).append('\n');
    }
    return Files.writeString(folder.resolve("slide.csv"), rows.toString());
  }

  private List<String> slide(Object... options) throws IOException {
    Path out = folder.resolve("f.csv");
    List<Object> replay = new ArrayList<>(List.of("replay", "--trajectory", sliding()));
    replay.addAll(List.of("--out", out));
    replay.addAll(List.of(options));
    CommandRun.of(replay.toArray()).mustSucceed();
    return Files.readAllLines(out);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "viscosity:0.01",
        "magnet:sphere,0.5,6",
        "stickslip:0.3",
        "vibration:100,0.2",
        "texture:0.5"
      })
  void anEffectChangesTheForceAndNotThePoint(String effect) throws IOException {
    Object[] ball = {"--phantom", "sphere:32:grey", "--segment", "sphere=>=500"};
    List<String> plain = slide(ball);
    Object[] with = Stream.concat(Stream.of(ball), Stream.of("--effect", effect)).toArray();
    List<String> felt = slide(with);
    assertEquals(plain.size(), felt.size());
    int differing = 0;
    for (int row = 1; row < plain.size(); row++) {
      String[] before = plain.get(row).split(",", -1);
      String[] now = felt.get(row).split(",", -1);
      for (int column : new int[] {2, 3, 4, 5, 6, 7, 11, 12}) {
        assertEquals(before[column], now[column], effect + " row " + row);
      }
      differing += before[9].equals(now[9]) && before[8].equals(now[8]) ? 0 : 1;
    }
    assertTrue(differing > 100, effect + " differs in " + differing + " frames");
  }

  @Test
  void aPointWithMassSagsByItsWeightAndReportsItsEnergy() throws IOException {
    Path report = folder.resolve("r.json");
    double[] force =
        lastForce("--mass", 0.02, "--gravity", "0,0,-9.81", "--max-force", 5, "--report", report);
    assertEquals(-0.02 * 9.81, force[2], 1e-3);
    assertEquals(0, force[0], 1e-9);
    String text = Files.readString(report);
    assertTrue(text.contains("\"kg\" : 0.02") && text.contains("\"debt_mj\" : "), text);
  }

  @Test
  void aLiveSessionHasAMass() throws IOException {
    Path report = folder.resolve("r.json");
    List<Object> touch = new ArrayList<>(List.of("touch", "--phantom", "sphere:32", "--headless"));
    touch.addAll(List.of("--seconds", 2, "--report", report, "--mass", 0.05));
    CommandRun.of(touch.toArray()).mustSucceed();
    String text = Files.readString(report);
    assertTrue(text.contains("\"taken_mj\""), text);
    assertFalse(text.contains("\"contact_frames\" : 0,"), text);
  }

  private double largestForce(Object... options) throws IOException {
    Path report = folder.resolve("r.json");
    List<Object> replay = new ArrayList<>(List.of("replay", "--trajectory", sliding()));
    replay.addAll(List.of("--phantom", "sphere:32:grey", "--segment", "sphere=>=500"));
    replay.addAll(List.of("--friction", 0, "--report", report));
    replay.addAll(List.of(options));
    CommandRun.of(replay.toArray()).mustSucceed();
    return FlatJson.number(report, "max_force_n");
  }

  @Test
  void materialsFollowFromATableOfGreyValues() throws IOException {
    Path table =
        Files.writeString(
            folder.resolve("m.csv"), "grey,stiffness,friction,damping\n-1e4,0.5,0,0\n");
    for (String tool : new String[] {"point", "sphere:2"}) {
      double plain = largestForce("--tool", tool);
      double soft = largestForce("--tool", tool, "--material-from-grey", table);
      assertEquals(0.5 * plain, soft, 1e-9 * plain, tool);
    }
    double weighty = largestForce("--mass", 0.02, "--material-from-grey", table);
    assertTrue(weighty > 0 && weighty < largestForce("--mass", 0.02), "with mass " + weighty);
    assertTrue(largestForce("--material-from-grey", "ct") > 0);
  }

  @Test
  void faultsOfATableOfMaterialsAreOneLine() throws IOException {
    String header = "grey,stiffness,friction,damping\n";
    String[] tables = {
      header,
      header + "0,1,0,0\n0,1,0,0\n",
      header + "0,11,0,0\n",
      header + "0,1,-1,0\n",
      header + "0,1,0,NaN\n",
      header + "x,1,0,0\n",
      "grey,stiffness\n0,1\n"
    };
    Path table = folder.resolve("m.csv");
    Object[] replay = {
      "replay",
      "--trajectory",
      sliding(),
      "--phantom",
      "sphere:32:grey",
      "--segment",
      "sphere=>=500",
      "--material-from-grey",
      table
    };
    for (String text : tables) {
      Files.writeString(table, text);
      String said = CommandRun.of(replay).mustRefuse();
      assertTrue(said.contains("m.csv"), said);
    }
    Files.delete(table);
    assertTrue(CommandRun.of(replay).mustRefuse().contains("m.csv"));
  }
}
