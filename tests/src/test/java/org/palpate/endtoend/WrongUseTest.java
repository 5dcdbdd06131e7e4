package org.palpate.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

class WrongUseTest {
  @TempDir private Path folder;

  static Stream<String> wrongArguments() {
    return Stream.of(
        "frobnicate",
        "touch --frobnicate",
        "touch extra",
        "touch --solver fast",
        "touch --collision sampled:0",
        "touch --solver guarded --collision gridplanes",
        "touch --border precalculated",
        "touch --solver guarded --border on-the-fly",
        "touch --solver paper --border sometimes",
        "touch --stiffness -1",
        "touch --stiffness NaN",
        "touch --friction -0.1",
        "touch --material bone",
        "touch --material bone=hard",
        "touch --material bone=stiffness:-1",
        "touch --material bone=stiffness:1,stiffness:2",
        "touch --material bone=friction:0.2,sliding:0.3",
        "touch --material bone=stiffness:1e999",
        "touch --phantom sphere:32 --material bone=stiffness:1",
        "touch --max-step 0",
        "touch --max-force much",
        "touch --guide rail:1,2,3",
        "touch --guide axis:1,2,3",
        "touch --guide axis:1,2,3,0,0,0",
        "touch --guide axis:1,2,3,0,0,x",
        "touch --guide hinge:1,2,3,0,0,1e7",
        "touch --guide plane:",
        "touch --guide sphere:1,2,3,0",
        "touch --guide path:",
        "touch --guide path:/no/such/file.csv --headless",
        "touch --guide align:0,0,1",
        "info --phantom sphere:32 --fit 0",
        "info --phantom fracture:64:2 --fit 9",
        "render --phantom sphere:32 --gaps --out gaps.png",
        "render --phantom fracture:64:2 --gaps --out gaps.stl",
        "render --phantom fracture:64:2 --poses p.csv --out film.stl",
        "touch --guide fit --headless --phantom sphere:32",
        "touch --guide fit:4 --headless --phantom fracture:64:2",
        "touch --guide fit:wide --headless --phantom fracture:64:2",
        "touch --guide fit --guide fit:1 --headless --phantom fracture:64:2",
        "replay --trajectory t.csv --guide fit",
        "touch --guide away:bone",
        "touch --guide away:bone,-1",
        "touch --headless --phantom sphere:32 --guide away:bone,2",
        "touch --effect glue:1",
        "touch --effect viscosity",
        "touch --effect viscosity:0",
        "touch --effect viscosity:1",
        "touch --effect stickslip:1,2",
        "touch --effect vibration:500,1",
        "touch --effect magnet:bone,1",
        "touch --headless --phantom sphere:32 --effect magnet:bone,1,3",
        "touch --headless --phantom sphere:32 --effect texture:0.2",
        "touch --effect texture:-1",
        "touch --headless --phantom sphere:32 --material-from-grey ct",
        "touch --material-from-grey ct --material sphere=stiffness:1",
        "touch --gravity 0,0,-9.81",
        "touch --mass 0.1 --gravity 0,0",
        "touch --mass 0.1 --gravity 0,0,-981",
        "touch --mass 0.1 --gravity 0,0,NaN",
        "replay --trajectory t.csv --mass 0.1 --elastic skin=young:1e4",
        "touch --tool sphere:2 --gravity 0,0,-9.81",
        "touch --rate 0",
        "touch --seconds -1",
        "touch --device banana",
        "touch --device replay",
        "touch --device simulated:x",
        "touch --collision-device opencl",
        "touch --tool sphere:4 --collision-device gpu",
        "touch --tool sphere:4 --collision-device opencl:",
        "touch --explain --collision-device cuda",
        "touch --fit-each-axis",
        "touch --axes sideways",
        "touch --axes view",
        "touch --headless --axes view --device hid",
        "touch --phantom cow",
        "touch --phantom head:3",
        "touch --phantom head:64 --volume x.nrrd",
        "touch --phantom sphere:32:grey",
        "touch --raw 1x1x1:u8:1,1,1",
        "touch --volume /no/such/file.nrrd",
        "touch --segment bone",
        "touch --segment bone=>=many",
        "touch --segment a=nonzero --segment a=>=1",
        "touch --report /no/such/folder/r.json",
        "touch --headless --record /no/such/folder/t.csv",
        "touch --headless --smooth-from other",
        "replay",
        "touch --headless --device mouse",
        "touch --headless --slices middle",
        "touch --surface gold",
        "touch --headless --clip x",
        "touch --clip sideways",
        "touch --headless --ghost pom.xml",
        "touch --headless --phantom fracture:64:2 --ghost /no/such/file.nrrd",
        "render --out x.png --ghost pom.xml",
        "render --out x.stl --ghost x.nrrd",
        "render --out x.png --clip view:3",
        "render --out x.png --clip y:far",
        "render --out x.png --colour-by stress",
        "render --out x.png --colour-by strain",
        "render --out x.stl --clip x",
        "render --out x.stl --slices middle",
        "render --out x.ply --trajectory t.csv",
        "render --out x.png --slices point",
        "render --out x.png --surface grey",
        "replay --trajectory /no/such/file.csv",
        "info --volume /no/such/file.nrrd",
        "info --solver guarded",
        "info --phantom sphere:32 --export bone.xyz",
        "info --phantom sphere:32 --export same.nrrd --report same.nrrd",
        "devices --seconds 3",
        "devices --watch hid --seconds 0",
        "devices --watch hid --json",
        "devices --watch simulated",
        "devices --check simulated",
        "devices --check capture:/no/such.hid",
        "devices --check capture:pom.xml",
        "devices --check hid --json",
        "devices --check capture:a.hid --capture b.hid",
        "devices --capture x.hid",
        "jitter --out pom.xml",
        "jitter --out jitter --seconds 0",
        "jitter --out jitter --heap 0",
        "jitter --out jitter --minutes NaN",
        "bench --out pom.xml",
        "bench --frames 5",
        "bench --table1 --seed 5",
        "bench --stability --solver smooth",
        "bench --stress --frames 0",
        "bench --stress --solver paper");
  }

  @ParameterizedTest
  @MethodSource("wrongArguments")
  void wrongUseIsReportedInOneLineWithExitCodeTwo(String arguments) {
    CommandRun.of((Object[]) arguments.split(" ")).mustRefuse();
  }

  @ParameterizedTest
  @ValueSource(strings = {"touch", "replay", "info", "devices", "render", "jitter"})
  void helpShowsExamplesAndSucceeds(String command) {
    CommandRun run = CommandRun.of(command, "--help").mustSucceed();
    assertTrue(run.out().contains("Examples:"), run.out());
    assertTrue(run.out().contains("palpate " + command), run.out());
  }

  @Test
  void helpWithoutACommandNamesAllCommands() {
    CommandRun run = CommandRun.of("--help").mustSucceed();
    for (String command : new String[] {"touch", "replay", "info", "render", "devices", "jitter"}) {
      assertTrue(run.out().contains(command), command + " is not in: " + run.out());
    }
  }

  @Test
  void aMissingOptionIsNamed() {
    String said = CommandRun.of("replay").mustRefuse();
    assertTrue(said.startsWith("palpate: missing --trajectory T.csv: "), said);
  }

  static Stream<List<String>> valuesThatDoNotFit() {
    return Stream.of(
        List.of("touch", "--seconds", "abc", "'abc' is not a number"),
        List.of("devices", "--seconds", "abc", "'abc' is not a number"),
        List.of("replay", "--repeat", "1.5", "'1.5' is not a whole number"),
        List.of("touch", "--axes", "up", "'up' is none of patient, view"),
        List.of(
            "render",
            "--view",
            "top",
            "'top' is none of front, back, left, right, head, foot, oblique"),
        List.of("info", "--volume", "", "the path is empty"),
        List.of("render", "--out", "", "the path is empty"));
  }

  @ParameterizedTest
  @MethodSource("valuesThatDoNotFit")
  void aValueThatDoesNotFitIsExplainedInPlainWords(List<String> words) {
    String said = CommandRun.of(words.subList(0, 3).toArray()).mustRefuse();
    String expected =
        "palpate: Invalid value for option '" + words.get(1) + "': " + words.get(3) + ": palpate ";
    assertTrue(said.startsWith(expected), said);
  }

  @Test
  @EnabledOnOs(value = OS.LINUX, disabledReason = "skipped: no /dev/full on this system")
  void aFullDiskIsReportedWithTheFile() {
    CommandRun run = CommandRun.of("info", "--phantom", "sphere:16", "--report", "/dev/full");
    assertEquals(1, run.exitCode());
    assertTrue(
        run.err().startsWith("palpate: could not be written (No space left on device): /dev/full:"),
        run.err());
  }

  @Test
  void aStackTraceIsShownOnlyWithDebug() {
    String[] quiet = {"info", "--volume", "/no/such/file.nrrd"};
    assertFalse(CommandRun.of((Object[]) quiet).err().contains("\tat "));
    CommandRun loud = CommandRun.of("info", "--volume", "/no/such/file.nrrd", "--debug");
    assertTrue(loud.err().contains("\tat "), loud.err());
    assertEquals(2, loud.exitCode());
  }

  @Test
  void anInputIsNeverOverwritten() throws IOException {
    Path volume = TestFiles.nrrd(folder.resolve("v.nrrd"), 16, v -> v[0] > 8 ? 1 : 0);
    Path trajectory = TestFiles.trajectory(folder.resolve("t.csv"), 20, 16, 1);
    byte[] volumeBytes = Files.readAllBytes(volume);
    byte[] trajectoryBytes = Files.readAllBytes(trajectory);
    Path link = Files.createSymbolicLink(folder.resolve("link.csv"), trajectory);
    for (Path target : new Path[] {volume, trajectory, link}) {
      for (String option : new String[] {"--out", "--legs", "--report"}) {
        CommandRun.of("replay", "--volume", volume, "--trajectory", trajectory, option, target)
            .mustRefuse();
      }
    }
    assertEquals(-1, java.util.Arrays.mismatch(volumeBytes, Files.readAllBytes(volume)));
    assertEquals(-1, java.util.Arrays.mismatch(trajectoryBytes, Files.readAllBytes(trajectory)));
  }

  @Test
  void intensitiesWithoutASegmentAreRefusedWithAProposal() throws IOException {
    Path volume =
        TestFiles.nrrd(
            folder.resolve("grey.nrrd"), 24, v -> (v[0] * 7 + v[1] * 3 + v[2] * 5) % 251);
    Path trajectory = TestFiles.trajectory(folder.resolve("t.csv"), 20, 24, 1);
    String line =
        CommandRun.of("replay", "--volume", volume, "--trajectory", trajectory).mustRefuse();
    assertTrue(line.contains("0 to 250") && line.contains("--segment 'bone=>="), line);
    CommandRun info = CommandRun.of("info", "--volume", volume).mustSucceed();
    assertTrue(info.out().contains("--segment 'bone=>="), info.out());
  }
}
