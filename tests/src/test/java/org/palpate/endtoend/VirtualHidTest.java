package org.palpate.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Runs commands with a hand-built device that the unmodified hidapi finds behind umockdev. Its
 * firmware prints at the end the forces that it received. {@code
 * native/src/test/sh/touch-virtual-device.sh} does the same.
 */
class VirtualHidTest {
  private static final Path DEVICE = Path.of("..", "native", "target", "cmake-tests", "umock_hid");
  private static final Path JAVA_HOME = Path.of(System.getProperty("java.home"));
  private static final Pattern FIRMWARE_LINE =
      Pattern.compile(
          "umock_hid: .* (\\d+) forces, .* (\\d+) with a push, largest (\\d+) mN, .* (\\d+) mN at"
              + " the end");

  @TempDir private Path folder;

  @BeforeEach
  void needsUmockdev() {
    Assumptions.assumeTrue(
        Files.isExecutable(DEVICE),
        "skipped: no " + DEVICE + ": apt-get install umockdev libumockdev-dev pkg-config");
  }

  @Test
  void hidapiListsTheDevice() throws Exception {
    String out = run("", "devices").out();
    assertTrue(out.contains("libhidapi-hidraw.so.0"), out);
    assertTrue(out.contains("SN0001  Virtual hand-built device"), out);
  }

  @Test
  void aSessionTouchesThroughTheDeviceAndLeavesItWithoutForce() throws Exception {
    Path report = folder.resolve("r.json");
    CommandRun run =
        run(
            "",
            "touch",
            "--device",
            "hid:SN0001",
            "--phantom",
            "head:64",
            "--seconds",
            "4",
            "--headless",
            "--report",
            report);
    Map<String, String> json = FlatJson.read(report);
    assertTrue(Long.parseLong(json.get("/contact_frames")) > 0, json.toString());
    Matcher felt = felt(run.err());
    assertTrue(Integer.parseInt(felt.group(2)) > 0, run.err());
    assertTrue(
        Integer.parseInt(felt.group(3)) <= 6000, "beyond the device's maximum: " + run.err());
    assertEquals("0", felt.group(4), run.err());
  }

  @Test
  void aCheckFindsNoFaultInTheExampleFirmware() throws Exception {
    Path capture = folder.resolve("c.hid");
    String out = run("", "devices", "--check", "hid:SN0001", "--capture", capture).out();
    assertTrue(out.contains("no rule is broken"), out);
    assertTrue(out.contains("ok      the descriptor states feature report 3"), out);
    String again = CommandRun.of("devices", "--check", "capture:" + capture).mustSucceed().out();
    assertEquals(out, again);
  }

  @Test
  void aKeyRequestsForceWhileTheDeviceIsWatched() throws Exception {
    Path report = folder.resolve("r.json");
    CommandRun run =
        run("\n", "devices", "--watch", "hid:SN0001", "--seconds", "4", "--report", report);
    assertTrue(run.out().contains("samples/s"), run.out());
    assertTrue(run.out().contains("hold it still"), run.out());
    assertTrue(run.out().contains("pushing"), run.out());
    String samples = FlatJson.read(report).get("/samples");
    assertTrue(run.out().contains("\n" + samples + " samples"), run.out());
    Matcher felt = felt(run.err());
    // A tenth of its maximum; less if this machine delayed the watch.
    int largest = Integer.parseInt(felt.group(3));
    assertTrue(largest > 0 && largest <= 600, run.err());
    assertEquals("0", felt.group(4), run.err());
  }

  @Test
  void anUnknownSerialIsRefusedWithTheKnownOne() throws Exception {
    CommandRun run = start("", "touch", "--device", "hid:SN9", "--headless");
    assertEquals(1, run.exitCode(), run.err());
    assertTrue(run.err().contains("use one of SN0001"), run.err());
  }

  private static Matcher felt(String err) {
    Matcher felt = FIRMWARE_LINE.matcher(err);
    assertTrue(felt.find(), "the device printed nothing: " + err);
    assertTrue(Integer.parseInt(felt.group(1)) > 0, err);
    return felt;
  }

  private static CommandRun run(String keys, Object... arguments) throws Exception {
    return start(keys, arguments).mustSucceed();
  }

  /** Starts the device, which runs the command, and presses keys after the hand was held still. */
  private static CommandRun start(String keys, Object... arguments)
      throws IOException, InterruptedException {
    ProcessBuilder own = CommandRun.inOwnJvm(JAVA_HOME, List.of(), arguments);
    List<String> command = new ArrayList<>(List.of(DEVICE.toAbsolutePath().toString()));
    command.addAll(own.command());
    ProcessBuilder builder = new ProcessBuilder(command);
    builder.environment().put("LD_PRELOAD", "libumockdev-preload.so.0");
    builder.environment().remove("LD_LIBRARY_PATH");
    Path err = Files.createTempFile("palpate-err", ".txt");
    Process process = builder.redirectError(err.toFile()).start();
    StringBuilder out = new StringBuilder();
    try (var lines = process.inputReader(StandardCharsets.UTF_8);
        OutputStream input = process.getOutputStream()) {
      boolean pressed = keys.isEmpty();
      for (String line = lines.readLine(); line != null; line = lines.readLine()) {
        out.append(line).append('\n');
        // The force is enabled within a second after it is switched on.
        if (!pressed && line.contains("samples/s") && !line.contains("hold it still")) {
          pressed = out.toString().lines().filter(said -> said.contains("samples/s")).count() > 9;
          if (pressed) {
            input.write(keys.getBytes(StandardCharsets.US_ASCII));
            input.flush();
          }
        }
      }
    }
    int exitCode = process.waitFor();
    String errors = Files.readString(err);
    Files.delete(err);
    return new CommandRun(exitCode, out.toString(), errors);
  }
}
