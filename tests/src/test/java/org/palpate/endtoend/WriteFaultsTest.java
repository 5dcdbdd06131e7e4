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
import org.junit.jupiter.params.provider.ValueSource;

/** Outputs that cannot be written, ends that come early, and displays that do not answer. */
@EnabledOnOs(value = OS.LINUX, disabledReason = "skipped: no /dev/full on this system")
class WriteFaultsTest {
  private static final String FULL = "palpate: could not be written (No space left on device): ";

  @TempDir private Path folder;

  @Test
  void aFullDiskAtOneTableKeepsTheOtherAndTheReport() throws IOException {
    Path trajectory = TestFiles.trajectory(folder.resolve("t.csv"), 50, 16, 1);
    for (String tool : new String[] {"point", "sphere:2"}) {
      Path legs = folder.resolve(tool.substring(0, 5) + "-legs.csv");
      Path report = folder.resolve(tool.substring(0, 5) + "-r.json");
      CommandRun run =
          CommandRun.of(
              "replay",
              "--phantom",
              "sphere:16",
              "--tool",
              tool,
              "--trajectory",
              trajectory,
              "--out",
              "/dev/full",
              "--legs",
              legs,
              "--report",
              report);
      assertEquals(1, run.exitCode());
      assertTrue(run.err().startsWith(FULL + "/dev/full: "), run.err());
      assertEquals(1, run.err().lines().count(), run.err());
      assertTrue(Files.size(legs) > 100 && Files.size(report) > 100);
    }
  }

  @Test
  void aFullDiskAtTheRecordingKeepsTheSessionAndTheReport() throws IOException {
    Path report = folder.resolve("r.json");
    CommandRun run =
        CommandRun.of(
            "touch",
            "--phantom",
            "sphere:16",
            "--headless",
            "--seconds",
            "0.3",
            "--record",
            "/dev/full",
            "--report",
            report);
    assertEquals(1, run.exitCode());
    assertTrue(run.err().startsWith(FULL + "/dev/full: "), run.err());
    assertTrue(run.out().contains(" frames, "), run.out());
    String text = Files.readString(report);
    assertTrue(text.contains("\"stiffness_n_per_mm\" : 1.4142135623730951"), text);
    assertTrue(text.contains("\"friction\" : 0.2"), text);
  }

  @ParameterizedTest
  @ValueSource(strings = {"a.nrrd", "a.nii", "a.nii.gz", "a.tif", "a.dcm"})
  void aFullDiskAtAnExportIsReportedWithItsCauseAndTheFile(String name) throws IOException {
    Path target = Files.createSymbolicLink(folder.resolve(name), Path.of("/dev/full"));
    CommandRun run = CommandRun.of("info", "--phantom", "head:64", "--export", target);
    assertEquals(2, run.exitCode());
    assertTrue(
        run.err()
            .startsWith(
                "palpate: the file cannot be written (No space left on device): " + target + ": "),
        run.err());
    assertEquals(1, run.err().lines().count(), run.err());
  }

  @Test
  void aFullDiskAtStandardOutputIsAnErrorAndKeepsTheReport()
      throws IOException, InterruptedException {
    Path report = folder.resolve("r.json");
    ProcessBuilder info =
        inOwnJvm("info", "--phantom", "sphere:16", "--report", report)
            .redirectOutput(Path.of("/dev/full").toFile());
    CommandRun run = CommandRun.waitFor(info);
    assertEquals(FULL + "standard output: check where it goes", run.err().strip());
    assertEquals(1, run.exitCode());
    assertTrue(Files.size(report) > 100);
  }

  @Test
  void anEndBeforeTheSessionStartsLeavesNothingAndIsOrdinary()
      throws IOException, InterruptedException {
    Path out = folder.resolve("out");
    Files.createDirectory(out);
    Process touch =
        inOwnJvm(
                "touch",
                "--phantom",
                "head:256",
                "--headless",
                "--record",
                out.resolve("t.csv"),
                "--report",
                out.resolve("r.json"))
            .start();
    // the first line is printed before the volume is made
    String line = touch.inputReader().readLine();
    touch.destroy();
    assertTrue(line.startsWith("palpate "), line);
    assertEquals(0, touch.waitFor());
    try (Stream<Path> left = Files.list(out)) {
      assertEquals(List.of(), left.toList());
    }
  }

  @Test
  void aDisplayThatDoesNotAnswerGetsOneLine() throws IOException, InterruptedException {
    ProcessBuilder touch = inOwnJvm("touch", "--phantom", "sphere:16", "--seconds", "0.2");
    touch.environment().put("DISPLAY", ":997");
    CommandRun run = CommandRun.waitFor(touch).mustSucceed();
    assertEquals("", run.err());
    assertTrue(
        run.out().contains("no display answers at DISPLAY=:997: goes on without a window"),
        run.out());
  }

  @Test
  void devicesListTheMouse() throws IOException, InterruptedException {
    ProcessBuilder devices = inOwnJvm("devices", "--json");
    devices.environment().remove("DISPLAY");
    String list = CommandRun.waitFor(devices).mustSucceed().out();
    int mouse = list.indexOf("\"name\" : \"mouse\"");
    assertTrue(mouse > 0 && mouse < list.indexOf("\"name\" : \"hid\""), list);
    assertTrue(list.substring(mouse).contains("\"why\" : \"there is no display\""), list);
    assertFalse(list.contains("--device mouse"), list);
  }

  private static ProcessBuilder inOwnJvm(Object... arguments) {
    return CommandRun.inOwnJvm(
        Path.of(System.getProperty("java.home")), List.of("-XX:TieredStopAtLevel=1"), arguments);
  }
}
