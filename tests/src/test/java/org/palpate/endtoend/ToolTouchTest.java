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
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Runs {@code touch --tool} without a window. */
class ToolTouchTest {
  @TempDir private Path folder;

  @Test
  void aRecordedSessionReplaysToTheSameFrames() throws IOException {
    Path record = folder.resolve("t.csv");
    Path live = folder.resolve("live.json");
    CommandRun run =
        CommandRun.of(
            "touch",
            "--phantom",
            "torus:64",
            "--tool",
            "capsule:2,6",
            "--device",
            "simulated:3",
            "--seconds",
            "2",
            "--headless",
            "--record",
            record,
            "--report",
            live);
    run.mustSucceed();
    assertTrue(run.out().contains("tool capsule:2,6 of "), run.out());
    Map<String, String> session = FlatJson.read(live);
    assertTrue(Long.parseLong(session.get("/frames")) > 200, session.toString());
    assertEquals("rigid", session.get("/solver"));
    assertEquals("0.2", session.get("/friction"));
    assertTrue(Long.parseLong(session.get("/skipped/neighbours")) > 1000, session.toString());
    assertEquals("0.0", session.get("/tool/clearance_mm"));
    assertTrue(Long.parseLong(session.get("/tool/points")) > 50);
    assertEquals("stopped", session.get("/end"));
    assertTrue(Files.readString(record).startsWith("t_ms,x,y,z,qw,qx,qy,qz,flags\n"));
    Path replayed = folder.resolve("replayed.json");
    CommandRun.of(
            "replay",
            "--phantom",
            "torus:64",
            "--tool",
            "capsule:2,6",
            "--trajectory",
            record,
            "--report",
            replayed)
        .mustSucceed();
    Map<String, String> replay = FlatJson.read(replayed);
    assertEquals(session.get("/frames"), replay.get("/frames"));
    assertEquals(session.get("/contact_frames"), replay.get("/contact_frames"));
    assertEquals(session.get("/freed"), replay.get("/freed"));
  }

  @Test
  void aToolIsHeldUprightWithoutAnOrientationAndAPointHasNoneToHold() throws IOException {
    Path still = folder.resolve("still.csv");
    Files.writeString(still, "t_ms,x,y,z\n0,-30,-30,-30\n100,-30,-30,-30\n");
    assertTrue(printedByTouch(still, "--tool", "sphere:2").contains("the tool is held upright"));
    assertFalse(printedByTouch(still, "--tool", "point").contains("upright"));
  }

  private static String printedByTouch(Path device, String... tool) {
    List<Object> all = new ArrayList<>(List.of("touch", "--headless", "--device"));
    all.addAll(List.of("replay:" + device, "--phantom", "fracture:64:2"));
    all.addAll(List.of(tool));
    CommandRun run = CommandRun.of(all.toArray());
    run.mustSucceed();
    return run.out();
  }

  @Test
  void aPictureOfAToolNeedsATrajectory() {
    Path out = folder.resolve("x.png");
    String line = CommandRun.of("render", "--tool", "sphere:4", "--out", out).mustRefuse();
    assertTrue(line.contains("add --trajectory"), line);
    Path surface = folder.resolve("x.stl");
    CommandRun.of("render", "--tool", "sphere:4", "--out", surface).mustRefuse();
  }

  @Test
  void wrongUseIsOneLineAndExitCodeTwo() {
    String[][] wrong = {
      {"--tool", "sphere:0"},
      {"--tool", "sphere:4", "--solver", "guarded"},
      {"--tool", "sphere:4", "--rotational-stiffness", "0"},
      {"--mass", "0"},
    };
    for (String[] arguments : wrong) {
      Object[] all = new Object[arguments.length + 2];
      all[0] = "touch";
      all[1] = "--headless";
      System.arraycopy(arguments, 0, all, 2, arguments.length);
      assertTrue(CommandRun.of(all).mustRefuse().startsWith("palpate: "));
    }
  }
}
