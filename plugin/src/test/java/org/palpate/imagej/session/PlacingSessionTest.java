package org.palpate.imagej.session;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import ij.ImagePlus;
import ij.ImageStack;
import ij.io.FileInfo;
import ij.macro.Interpreter;
import ij.process.ByteProcessor;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.locks.LockSupport;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.palpate.frame.ToolFrame;
import org.palpate.imagej.dialog.PlaceOptions;
import org.palpate.imagej.dialog.StackWorkspace;
import org.palpate.imagej.stack.StackVolume;
import org.palpate.imagej.stack.TouchRefusedException;

class PlacingSessionTest {
  private static final int SIZE = 40;

  @TempDir private Path folder;

  /** Returns a stack with a large block of label 3 and a small one of label 7 beside it. */
  private static ImagePlus labels() {
    ImageStack stack = new ImageStack(SIZE, SIZE);
    for (int k = 0; k < SIZE; k++) {
      ByteProcessor slice = new ByteProcessor(SIZE, SIZE);
      for (int j = 10; j < 30 && k >= 10 && k < 30; j++) {
        for (int i = 5; i < 23; i++) {
          slice.set(i, j, i < 15 ? 3 : i >= 17 ? 7 : 0);
        }
      }
      stack.addSlice(slice);
    }
    ImagePlus image = new ImagePlus("labels", stack);
    image.setDimensions(1, SIZE, 1);
    return image;
  }

  private static PlaceOptions options(int fixed) {
    return options(fixed, false);
  }

  private static PlaceOptions options(int fixed, boolean resume) {
    return new PlaceOptions(
        fixed, 0.2, "simulated", new StackWorkspace(StackWorkspace.Kind.FIT, 1), 0, false, resume);
  }

  /** Returns the same stack as if it had been opened from a file. */
  private ImagePlus opened() throws IOException {
    Files.write(folder.resolve("labels.tif"), new byte[] {1});
    ImagePlus image = labels();
    FileInfo info = new FileInfo();
    info.directory = folder + "/";
    info.fileName = "labels.tif";
    image.setFileInfo(info);
    return image;
  }

  private List<String> autosaved() throws IOException {
    try (Stream<Path> all = Files.list(folder)) {
      return all.map(file -> file.getFileName().toString())
          .filter(name -> name.contains("autosave"))
          .sorted()
          .toList();
    }
  }

  @Test
  @Timeout(60)
  void aFragmentIsMovedUntilAnotherHoldsItBackAndTheResultIsALabelStack() throws Exception {
    ImagePlus image = opened();
    StackVolume stack = StackVolume.shownIn(image);
    try (PlacingSession session = new PlacingSession(stack, options(0))) {
      Thread runner = new Thread(() -> run(session));
      runner.start();
      session.awaitForce();
      assertThrows(TouchRefusedException.class, () -> session.move("label 3", "1,0,0,1,0,0,0"));
      assertThrows(TouchRefusedException.class, () -> session.move("label 7", "1,0,0,2,0,0,0"));
      assertThrows(TouchRefusedException.class, () -> session.move("label 7", "here"));
      session.move("label 7", "5,0,0,1,0,0,0");
      awaitPose(session, "5.0,0.0,0.0,1.0,0.0,0.0,0.0");
      session.move("label 7", "-9,0,0,1,0,0,0");
      LockSupport.parkNanos(1_000_000_000L);
      double x = Double.parseDouble(session.pose("label 7").split(",", -1)[0]);
      assertTrue(x > -3 && x < 0, "held back by the other fragment: " + x);
      session.move("label 7", "4,0,0,1,0,0,0");
      awaitPose(session, "4.0,0.0,0.0,1.0,0.0,0.0,0.0");
      session.requestStop();
      runner.join();
      ImagePlus result = session.result();
      assertEquals("placed-labels", result.getTitle());
      for (int k = 0; k < SIZE; k++) {
        for (int v = 0; v < SIZE * SIZE; v++) {
          int i = v % SIZE;
          int before = i < 4 ? 0 : value(image, i - 4, v / SIZE, k);
          int own = value(image, i, v / SIZE, k);
          int expected = own == 3 ? 3 : before == 7 ? 7 : 0;
          assertEquals(expected, value(result, i, v / SIZE, k), i + " " + v / SIZE + " " + k);
        }
      }
    }
  }

  /** The first session is not ended in order, so what it saved stays, as after a crash. */
  @Test
  @Timeout(120)
  void anotherSessionGoesOnFromWhatACrashLeft() throws Exception {
    StackVolume stack = StackVolume.shownIn(opened());
    Path saved = folder.resolve("labels.tif.autosave.json");
    String pose;
    try (PlacingSession session = new PlacingSession(stack, options(0))) {
      Thread runner = new Thread(() -> run(session));
      runner.start();
      session.awaitForce();
      LockSupport.parkNanos(500_000_000L);
      ToolFrame frame = session.session().toolFrame().orElseThrow();
      frame.requestGroups(frame.groups().withLock(1, true));
      session.move("label 7", "5,0.3,-0.1,0.9998,0.02,0,0");
      while (!Files.exists(saved)) {
        LockSupport.parkNanos(10_000_000L);
      }
      pose = session.pose("label 7");
      session.requestStop();
      runner.join();
    }
    assertEquals(
        List.of(
            "labels.tif.autosave.groups.csv",
            "labels.tif.autosave.json",
            "labels.tif.autosave.nrrd"),
        autosaved());
    try (PlacingSession session = new PlacingSession(stack, options(0, true))) {
      assertEquals(pose, session.pose("label 7"));
      assertTrue(session.session().toolFrame().orElseThrow().groups().isLocked(1));
      assertTrue(autosaved().contains(".labels.tif.autosave2.json.lock"));
      endInOrder(session);
    }
    assertEquals(3, autosaved().size(), "its own are deleted, what it resumed stays");
    ImagePlus other = opened();
    other.getStack().setVoxel(12, 12, 12, 0);
    assertRefuses(
        StackVolume.shownIn(other),
        folder.resolve("labels.tif.autosave.json") + " has other fragments than the stack");
    try (PlacingSession session = new PlacingSession(stack, options(0))) {
      assertEquals("0.0,0.0,0.0,1.0,0.0,0.0,0.0", session.pose("label 7"));
    }
  }

  /** Runs a session until it has saved a change, and lets it show its result. */
  private void endInOrder(PlacingSession session) throws Exception {
    Path own = folder.resolve("labels.tif.autosave2.json");
    Thread runner = new Thread(() -> run(session));
    runner.start();
    session.awaitForce();
    LockSupport.parkNanos(500_000_000L);
    session.move("label 7", "6,0,0,1,0,0,0");
    while (!Files.exists(own)) {
      LockSupport.parkNanos(10_000_000L);
    }
    session.requestStop();
    runner.join();
    boolean shows = Interpreter.batchMode;
    Interpreter.batchMode = true; // a result is shown without a window
    try {
      session.finish();
    } finally {
      Interpreter.batchMode = shows;
    }
  }

  @Test
  void whatCannotBeResumedIsRefusedInOneLine() throws Exception {
    StackVolume stack = StackVolume.shownIn(opened());
    assertRefuses(stack, "No earlier session of this stack is left to resume.");
    Path saved = folder.resolve("labels.tif.autosave.json");
    String body = "{\"bodies\": [{\"name\": \"label %d\", \"volume\": \"a.nrrd\"}]}";
    Files.writeString(saved, String.format(body, 3));
    assertRefuses(stack, saved + " has other fragments than the stack: leave Resume out.");
    Files.writeString(saved, String.format(body, 3).substring(0, 30));
    assertRefuses(stack, "The session cannot be resumed: ");
  }

  private static void assertRefuses(StackVolume stack, String line) {
    String refusal =
        assertThrows(TouchRefusedException.class, () -> new PlacingSession(stack, options(0, true)))
            .getMessage();
    assertTrue(refusal.startsWith(line), refusal);
    assertEquals(1, refusal.lines().count());
  }

  private static int value(ImagePlus image, int i, int j, int k) {
    return (int) image.getStack().getVoxel(i, j, k);
  }

  private static void run(PlacingSession session) {
    try {
      session.run();
    } catch (TouchRefusedException e) {
      throw new IllegalStateException(e);
    }
  }

  private static void awaitPose(PlacingSession session, String pose) throws Exception {
    while (!session.pose("label 7").equals(pose)) {
      LockSupport.parkNanos(10_000_000L);
    }
  }

  @Test
  void refusesAnUnknownLabelAndASingleOne() {
    ImagePlus image = labels();
    String refusal =
        assertThrows(
                TouchRefusedException.class,
                () -> new PlacingSession(StackVolume.shownIn(image), options(5)))
            .getMessage();
    assertEquals("The stack has no label 5.", refusal);
    for (int k = 0; k < SIZE; k++) {
      image.getStack().getProcessor(k + 1).min(7);
    }
    assertThrows(
        TouchRefusedException.class,
        () -> new PlacingSession(StackVolume.shownIn(image), options(0)));
  }
}
