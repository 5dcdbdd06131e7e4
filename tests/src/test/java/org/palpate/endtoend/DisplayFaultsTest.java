package org.palpate.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.palpate.platform.XServer;

/** Whatever fails at the display, the session continues and reports it in one line. */
@EnabledOnOs(value = OS.LINUX, disabledReason = "skipped: no X11 on this system")
class DisplayFaultsTest {
  private static final Path JAVA_HOME = Path.of(System.getProperty("java.home"));
  private static final List<String> SMALL = List.of("-Xmx512m");
  private static final long PATIENCE_S = 120;

  @TempDir Path folder;

  private Process started;

  /** Ends a session that a failed test has left behind. */
  @AfterEach
  void end() {
    if (started != null) {
      started.destroyForcibly();
    }
  }

  private static ProcessBuilder on(String display, Object... arguments) {
    ProcessBuilder builder = CommandRun.inOwnJvm(JAVA_HOME, SMALL, arguments);
    builder.environment().put("DISPLAY", display);
    return builder;
  }

  private ProcessBuilder session(String display) {
    return on(display, "touch", "--phantom", "sphere:32", "--seconds", "1", "--report", report());
  }

  private Path report() {
    return folder.resolve("r.json");
  }

  private void assertTouchedAndPrinted(CommandRun run, String line) throws IOException {
    run.mustSucceed();
    assertEquals(1, run.out().lines().filter(each -> each.contains(line)).count(), run.out());
    assertTrue(Long.parseLong(FlatJson.read(report()).get("/frames")) > 0, run.out());
  }

  @Test
  void aDriverWithoutOpenGl3LeavesTheSessionWithoutAWindow() throws Exception {
    try (XServer display = XServer.start()) {
      ProcessBuilder old = session(display.display());
      old.environment().put("MESA_GL_VERSION_OVERRIDE", "2.1");
      assertTouchedAndPrinted(
          CommandRun.waitFor(old), "no window (the graphics driver has no OpenGL 3.3)");
    }
  }

  @Test
  void aDriverWithoutOpenGl3EndsASessionWithTheMouse() throws Exception {
    try (XServer display = XServer.start()) {
      ProcessBuilder old =
          on(display.display(), "touch", "--phantom", "sphere:32", "--device", "mouse")
              .redirectErrorStream(true);
      old.environment().put("MESA_GL_VERSION_OVERRIDE", "2.1");
      CommandRun run = CommandRun.waitFor(old);
      assertEquals(1, run.exitCode(), run.out());
      assertTrue(run.out().contains("the mouse is lost with it"), run.out());
    }
  }

  private ProcessBuilder picture(String display) {
    return on(display, "render", "--phantom", "sphere:32", "--out", folder.resolve("x.png"));
  }

  @Test
  void renderingWithoutADisplaySaysWhichPictureItWrote() throws Exception {
    XServer.start().close(); // skips the test if there is no Xvfb
    CommandRun run = CommandRun.waitFor(picture("")).mustSucceed();
    assertEquals("written: " + folder.resolve("x.png") + ": 1280 x 960 pixels", run.out().strip());
    assertTrue(Files.size(folder.resolve("x.png")) > 0);
  }

  @Test
  void renderingWithoutOpenGl3IsRefusedInOneLine() throws Exception {
    try (XServer display = XServer.start()) {
      ProcessBuilder old = picture(display.display());
      old.environment().put("MESA_GL_VERSION_OVERRIDE", "2.1");
      CommandRun run = CommandRun.waitFor(old);
      assertEquals(1, run.exitCode(), run.err());
      assertTrue(run.err().contains("palpate: the graphics driver has no OpenGL 3.3: "), run.err());
    }
  }

  @Test
  void aDisplayThatDoesNotAnswerLeavesTheSessionWithoutAWindow() throws Exception {
    assertTouchedAndPrinted(
        CommandRun.waitFor(session(":6553")),
        "no display answers at DISPLAY=:6553: goes on without a window");
  }

  @Test
  void withoutADisplayTheSessionRunsAndTheMouseIsRefused() throws Exception {
    ProcessBuilder blind = session("");
    assertTouchedAndPrinted(
        CommandRun.waitFor(blind), "there is no display: goes on without a window");
    CommandRun.waitFor(on("", "touch", "--device", "mouse")).mustRefuse();
  }

  @Test
  void aLostDisplayLetsTheSessionEndWithReportAndRecording() throws Exception {
    Path recording = folder.resolve("t.csv");
    Path out = folder.resolve("out.txt");
    Process process;
    try (XServer display = XServer.start()) {
      process =
          start(
              on(display.display(), "touch", "--phantom", "sphere:32", "--record", recording), out);
      await(process, out, () -> draws(process.pid()));
      // Nothing is recorded before the warm-up is over.
      await(process, out, () -> Files.readString(out).contains("force is on"));
    }
    // Either Xlib detects the loss, or the driver does if it is drawing.
    await(process, out, () -> Files.readString(out).contains("the session goes on without it"));
    process.destroy(); // SIGTERM, as Ctrl-C is SIGINT
    assertTrue(process.waitFor(PATIENCE_S, TimeUnit.SECONDS), "the process does not end");
    assertEquals(0, process.exitValue(), Files.readString(out));
    assertTrue(Files.readString(out).contains("in contact"), "the measurements are printed");
    assertTrue(Files.readAllLines(recording).size() > 1, "the recording is complete");
  }

  @Test
  void anInterruptedSessionWithAWindowPrintsItsMeasurementsAndNoException() throws Exception {
    Path out = folder.resolve("out.txt");
    try (XServer display = XServer.start()) {
      Process process = start(on(display.display(), "touch", "--phantom", "sphere:32"), out);
      await(process, out, () -> draws(process.pid()));
      await(process, out, () -> Files.readString(out).contains("force is on"));
      process.destroy(); // SIGTERM, as Ctrl-C is SIGINT
      assertTrue(process.waitFor(PATIENCE_S, TimeUnit.SECONDS), "the process does not end");
      assertEquals(0, process.exitValue(), Files.readString(out));
    }
    assertTrue(Files.readString(out).contains("in contact"), "the measurements are printed");
    assertFalse(Files.readString(out).contains("Exception"), Files.readString(out));
    assertFalse(Files.readString(out).contains("X11"), Files.readString(out));
  }

  @Test
  void aLostDisplayEndsASessionWithTheMouse() throws Exception {
    Path out = folder.resolve("out.txt");
    Process process;
    try (XServer display = XServer.start()) {
      process =
          start(on(display.display(), "touch", "--phantom", "sphere:32", "--device", "mouse"), out);
      await(process, out, () -> draws(process.pid()));
    }
    assertTrue(process.waitFor(PATIENCE_S, TimeUnit.SECONDS), "the process does not end");
    assertEquals(1, process.exitValue(), Files.readString(out));
    assertTrue(Files.readString(out).contains("the mouse is lost with it"), Files.readString(out));
  }

  private Process start(ProcessBuilder builder, Path out) throws IOException {
    started = builder.redirectErrorStream(true).redirectOutput(out.toFile()).start();
    return started;
  }

  private interface Condition {
    boolean holds() throws IOException;
  }

  private static void await(Process process, Path out, Condition condition) throws IOException {
    long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_S);
    while (!condition.holds()) {
      if (System.nanoTime() >= end || !process.isAlive()) {
        fail("the condition never held; printed: " + Files.readString(out));
      }
      Thread.onSpinWait();
    }
  }

  /** Whether the process has its drawing thread. */
  private static boolean draws(long process) throws IOException {
    return ProcessThreads.has(process, "palpate-draw");
  }
}
