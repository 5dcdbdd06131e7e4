package org.palpate.platform;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutionException;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.palpate.app.PalpateCommandLine;
import org.palpate.scijava.ReplayFile;
import org.scijava.Context;
import org.scijava.command.CommandInfo;
import org.scijava.command.CommandModule;
import org.scijava.command.CommandService;

/** The SciJava command, found by its index and run without a display. */
class ScijavaTest {
  @TempDir Path folder;

  private Context context;
  private CommandService commands;
  private Path volume;
  private Path trajectory;

  @BeforeEach
  void open() throws Exception {
    context = new Context(CommandService.class);
    commands = context.service(CommandService.class);
    volume = folder.resolve("ball.tif");
    ImagejFiles.writeBall(volume);
    trajectory = folder.resolve("slide.csv");
    List<String> rows = new ArrayList<>(List.of("t_ms,x,y,z"));
    for (int n = 0; n < 300; n++) {
      rows.add(n + "," + (4 + n * 0.03) + ",16,16");
    }
    Files.write(trajectory, rows);
  }

  @AfterEach
  void dispose() {
    context.dispose();
  }

  @Test
  void theCommandIsFoundWithItsMenuAndRunsHeadless() {
    CommandInfo info = commands.getCommand(ReplayFile.class);
    assertEquals("[Plugins, Palpate, Replay Volume File...]", info.getMenuPath().toString());
    assertTrue(info.canRunHeadless());
  }

  @Test
  void aReplayGivesTheBytesOfTheCommandLine() throws Exception {
    Path frames = folder.resolve("frames.csv");
    CommandModule module = replay(frames, "ball=>=100");
    assertEquals("", module.getOutput("message"));
    assertEquals(true, module.getOutput("done"));
    Path expected = folder.resolve("expected.csv");
    ByteArrayOutputStream sink = new ByteArrayOutputStream();
    PrintStream stream = new PrintStream(sink, true, StandardCharsets.UTF_8);
    new PalpateCommandLine(stream, stream)
        .run(
            "replay",
            "--volume",
            volume.toString(),
            "--segment",
            "ball=>=100",
            "--trajectory",
            trajectory.toString(),
            "--solver",
            "guarded",
            "--out",
            expected.toString());
    assertTrue(Files.readString(expected).contains(",1,"), "some frame has contact");
    assertArrayEquals(Files.readAllBytes(expected), Files.readAllBytes(frames));
  }

  @Test
  void anErrorIsReportedInOneLine() throws Exception {
    CommandModule module = replay(folder.resolve("none.csv"), "ball=nonsense");
    assertEquals(false, module.getOutput("done"));
    String message = (String) module.getOutput("message");
    assertTrue(message.startsWith("palpate: "), message);
    assertEquals(1, message.lines().count());
  }

  private CommandModule replay(Path frames, String segment)
      throws InterruptedException, ExecutionException {
    return commands
        .run(
            ReplayFile.class,
            false,
            "volume",
            volume.toFile(),
            "segment",
            segment,
            "trajectory",
            trajectory.toFile(),
            "coordinates",
            "world",
            "solver",
            "guarded",
            "frames",
            frames.toFile())
        .get();
  }
}
