package org.palpate.endtoend;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Breaks a tube, lets the fragments be fitted, and reads how far they are from the truth. */
class ReassemblyCommandTest {
  @TempDir private Path folder;

  private Path file(String name) {
    return folder.resolve(name);
  }

  private Map<String, String> read(String scene) throws IOException {
    CommandRun.of("info", "--scene", file(scene), "--report", file("r.json")).mustSucceed();
    return FlatJson.read(file("r.json"));
  }

  @Test
  void aBrokenTubeIsProposedWhole() throws IOException {
    TestFiles.nrrd(
        file("tube.nrrd"),
        80,
        v -> {
          double r = Math.hypot(v[0] - 39.5, v[1] - 39.5);
          return r >= 7 && r <= 13 && v[2] >= 4 && v[2] < 76 ? 1 : 0;
        });
    Object[] fracture = {
      "info",
      "--volume",
      file("tube.nrrd"),
      "--fracture",
      "3:2:0",
      "--export",
      file("p.nrrd"),
      "--save-scene",
      file("broken.json")
    };
    CommandRun.of(fracture).mustSucceed();
    Object[] fit = {
      "info", "--scene", file("broken.json"), "--fit", 0, "--save-scene", file("whole.json")
    };
    String out = CommandRun.of(fit).mustSucceed().out();
    assertTrue(out.contains("proposal  fragment"), out);
    assertTrue(Double.parseDouble(read("broken.json").get("/fracture/residual_mm")) > 3);
    Map<String, String> whole = read("whole.json");
    double mm = Double.parseDouble(whole.get("/fracture/residual_mm"));
    double degrees = Double.parseDouble(whole.get("/fracture/residual_deg"));
    assertTrue(mm < 0.4, "slices lie 2 mm apart: " + mm);
    assertTrue(degrees < 0.5, "degrees: " + degrees);
  }

  /** Writes a scene of two cubes, of which the second is displaced along x. */
  private Path cubes(double displacedMm) throws IOException {
    TestFiles.nrrd(
        file("cubes.nrrd"),
        24,
        v -> {
          boolean isIn = Math.min(v[1], v[2]) >= 4 && Math.max(v[1], v[2]) < 12;
          return !isIn ? 0 : v[0] >= 2 && v[0] < 10 ? 1 : v[0] >= 12 && v[0] < 20 ? 2 : 0;
        });
    String text =
        "{'bodies':[{'name':'low','volume':'cubes.nrrd','segment':'label:1'},"
            + "{'name':'high','volume':'cubes.nrrd','segment':'label:2','mobility':'movable',"
            + "'pose':{'translation_mm':["
            + displacedMm
            + ",0,0]}}]}";
    return Files.writeString(file("cubes.json"), text.replace('\'', '"'));
  }

  @Test
  void aFragmentThatFitsNowhereIsNamed() throws IOException {
    Object[] fit = {"info", "--scene", cubes(500), "--fit", 0};
    String out = CommandRun.of(fit).mustSucceed().out();
    assertTrue(out.contains("proposal  high: none, because no pose that was tried"), out);
  }

  @Test
  void bodiesThatOverlapAreNamedWithTheirVoxelsAndTheFile() throws IOException {
    Path scene = cubes(-4);
    String out = CommandRun.of("info", "--scene", scene).mustSucceed().out();
    assertTrue(out.contains("reading   high and low overlap in "), out);
    String refusal =
        CommandRun.of("touch", "--scene", scene, "--headless", "--seconds", 1).mustRefuse();
    assertTrue(
        refusal.startsWith("palpate: the bodies high and low overlap: --scene " + scene + ": "),
        refusal);
  }

  @Test
  void aFitNeedsFragments() {
    String refusal = CommandRun.of("info", "--phantom", "sphere:32", "--fit", 0).mustRefuse();
    assertTrue(refusal.contains("there are no fragments to fit: --fit"), refusal);
    CommandRun.of("info", "--phantom", "fracture:64:2", "--fit", 9).mustRefuse();
  }
}
