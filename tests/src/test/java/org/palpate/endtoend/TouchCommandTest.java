package org.palpate.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class TouchCommandTest {
  private static final Path JAVA_HOME = Path.of(System.getProperty("java.home"));

  @TempDir private Path folder;

  @Test
  void aSegmentWithoutVoxelsIsReported() {
    CommandRun run =
        CommandRun.of(
            "touch",
            "--phantom",
            "head:64:grey",
            "--segment",
            "bone=>=1e9",
            "--headless",
            "--seconds",
            "0.2");
    assertEquals(0, run.exitCode(), run.err());
    assertTrue(run.err().startsWith("palpate: segment bone has no voxel: phantom"), run.err());
  }

  @Test
  void voxelsThatAreTooLongForSmoothAreReported() throws IOException, InterruptedException {
    Path scan = Files.write(folder.resolve("long.raw"), new byte[4096]);
    String note = "palpate: voxels are 16 times as long as wide: " + scan + ": beyond 10 times";
    List<Object> volume = new ArrayList<>(List.of("--volume", scan, "--raw", "32x32x4:u8:1,1,16"));
    volume.addAll(List.of("--segment", "bone=>=1"));
    Path trajectory = TestFiles.trajectory(folder.resolve("t.csv"), 20, 32, 20130701);
    List<Object> touch = List.of("touch", "--headless", "--seconds", "0.2");
    assertEquals(1, occurrences(note, CommandRun.of(joined(touch, volume))));
    List<Object> moves = List.of("--trajectory", trajectory);
    assertEquals(1, occurrences(note, CommandRun.of(joined(List.of("replay"), moves, volume))));
    List<Object> render = List.of("render", "--size", "64x48", "--out", folder.resolve("x.png"));
    assertEquals(1, occurrences(note, onADisplay(joined(render, moves, volume))));
    assertEquals(0, occurrences(note, onADisplay(joined(render, volume))), "no solver moves");
  }

  private static Object[] joined(List<?>... parts) {
    return Arrays.stream(parts).flatMap(List::stream).toArray();
  }

  /** Runs a command that starts another one if there is no display. */
  private static CommandRun onADisplay(Object... arguments)
      throws IOException, InterruptedException {
    return CommandRun.waitFor(CommandRun.inOwnJvm(JAVA_HOME, List.of(), arguments));
  }

  private static int occurrences(String text, CommandRun run) {
    assertEquals(0, run.exitCode(), run.err());
    return run.err().split(Pattern.quote(text), -1).length - 1;
  }

  @Test
  void aSessionTouchesAndReportsTheFieldsOfTheContract() throws IOException {
    Path report = folder.resolve("r.json");
    CommandRun.of(
            "touch", "--phantom", "head:64", "--headless", "--seconds", "3", "--report", report)
        .mustSucceed();
    Map<String, String> json = FlatJson.read(report);
    for (String field :
        new String[] {
          "/seconds",
          "/rate_hz",
          "/late_frames",
          "/period_us/p50",
          "/period_us/p99_9",
          "/work_us/p99",
          "/work_us/max",
          "/freed",
          "/max_force_n",
          "/realtime/class",
          "/realtime/affinity",
          "/realtime/memory_lock",
          "/realtime/wait",
          "/realtime/throttled",
          "/sync/rate_hz",
          "/sync/writes",
          "/sync/applied",
          "/sync/redraws",
          "/sha256",
          "/segments/0/name"
        }) {
      assertTrue(json.containsKey(field), field + " is not in " + json);
    }
    assertEquals("simulated", json.get("/device"));
    assertTrue(Long.parseLong(json.get("/frames")) > 0, json.toString());
    assertTrue(Long.parseLong(json.get("/contact_frames")) > 0, json.toString());
    double force = Double.parseDouble(json.get("/max_force_n"));
    assertTrue(force > 0 && force <= 3.3, "longest force: " + force);
  }

  @Test
  void replayReadsWhatTouchRecords() throws IOException {
    Path recording = folder.resolve("t.csv");
    CommandRun.of(
            "touch",
            "--phantom",
            "sphere:48",
            "--headless",
            "--seconds",
            "1",
            "--record",
            recording)
        .mustSucceed();
    Path report = folder.resolve("r.json");
    CommandRun.of("replay", "--phantom", "sphere:48", "--trajectory", recording, "--report", report)
        .mustSucceed();
    long samples = Files.readAllLines(recording).size() - 1L;
    assertEquals(Long.toString(samples), FlatJson.read(report).get("/frames"));
    assertTrue(samples > 0, "nothing was recorded");
  }

  @Test
  void endsWithTheRecordingOfAReplayDevice() throws IOException {
    Path trajectory = TestFiles.trajectory(folder.resolve("t.csv"), 200, 48, 3);
    Path report = folder.resolve("r.json");
    CommandRun.of(
            "touch",
            "--phantom",
            "sphere:48",
            "--headless",
            "--device",
            "replay:" + trajectory,
            "--report",
            report)
        .mustSucceed();
    assertEquals("device_gone", FlatJson.read(report).get("/end"));
  }

  @Test
  void aSignalEndsTheSessionWithItsReportAndExitCodeZero()
      throws IOException, InterruptedException {
    Path report = folder.resolve("r.json");
    Path recording = folder.resolve("t.csv");
    Process process =
        CommandRun.inOwnJvm(
                JAVA_HOME,
                List.of(),
                "--phantom",
                "sphere:48",
                "--headless",
                "--report",
                report,
                "--record",
                recording)
            .redirectErrorStream(true)
            .start();
    BufferedReader lines =
        new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8));
    String line = lines.readLine();
    assertTrue(line.startsWith("palpate "), line);
    while (!line.startsWith("force is on")) {
      line = lines.readLine();
    }
    process.destroy(); // SIGTERM, as Ctrl-C is SIGINT
    assertTrue(process.waitFor(60, TimeUnit.SECONDS), "the process does not end");
    assertEquals(0, process.exitValue());
    assertEquals("stopped", FlatJson.read(report).get("/end"));
    assertTrue(Files.exists(recording));
  }
}
