package org.palpate.imagej.session;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import ij.ImagePlus;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.palpate.geometry.Vec3;
import org.palpate.host.MaterialOverride;
import org.palpate.host.TrajectoryRecording;
import org.palpate.imagej.TouchVolume;
import org.palpate.imagej.dialog.ChosenOptions;
import org.palpate.imagej.stack.StackVolume;
import org.palpate.imagej.stack.Stacks;
import org.palpate.imagej.stack.TouchRefusedException;

/** Whole sessions over a stack, without a window and without ImageJ's own. */
class StackSessionTest {
  private static final int SIZE = 24;

  @TempDir private Path folder;

  /** A floor of value 200 below a value of 10. */
  private final ImagePlus image =
      Stacks.of(8, SIZE, SIZE, SIZE, (i, j, k) -> k < SIZE / 2 ? 200 : 10);

  private final StackVolume volume = volume();

  private StackVolume volume() {
    try {
      return StackVolume.shownIn(image);
    } catch (TouchRefusedException e) {
      throw new IllegalStateException(e);
    }
  }

  @AfterEach
  void endTheSession() throws TouchRefusedException {
    CurrentSession.stop();
  }

  private void begin(String device) throws TouchRefusedException {
    StackSessionRunner.begin(volume, ChosenOptions.floor(device, 100, Map.of()), Optional.empty());
  }

  @Test
  void aStackWhoseSlicesLieTooFarApartForTheSolverIsLogged() throws TouchRefusedException {
    String note = "Palpate: voxels are 16 times as long as wide: stack: beyond 10 times";
    PrintStream shown = System.out;
    ByteArrayOutputStream log = new ByteArrayOutputStream(); // where ImageJ logs without a window
    System.setOut(new PrintStream(log, true, StandardCharsets.UTF_8));
    try {
      begin("simulated:98");
      CurrentSession.stop();
      assertFalse(log.toString(StandardCharsets.UTF_8).contains("Palpate: voxels"));
      image.getCalibration().pixelDepth = 16;
      begin("simulated:97");
      assertTrue(log.toString(StandardCharsets.UTF_8).contains(note));
    } finally {
      System.setOut(shown);
    }
  }

  @Test
  void aSessionCanBePaintedInAndEnds() throws TouchRefusedException {
    assertEquals("false", TouchVolume.isTouching());
    assertEquals("", TouchVolume.segments());
    assertEquals("0", TouchVolume.frames());
    assertEquals("0", TouchVolume.redraws());
    begin("simulated:99");
    assertEquals("true", TouchVolume.isTouching());
    long all = (long) SIZE * SIZE * SIZE / 2;
    assertEquals("floor\t" + all + "\n", TouchVolume.segments());
    assertEquals("0", TouchVolume.redraws(), "there is no window");
    StackSession session = CurrentSession.current();
    Vec3 point = session.touchedPointGrid();
    assertTrue(point.isFinite(), point.toString());
    assertTrue(Long.parseLong(TouchVolume.frames()) > 0);
    int painted = session.paint(2, true);
    assertEquals(painted, session.undo());
    assertEquals(painted, session.redo());
    assertEquals(
        "A volume is already being touched: press Escape to end that session first.",
        refusal(() -> begin("simulated")));
    CurrentSession.stop();
    assertFalse(CurrentSession.isRunning());
    assertEquals(
        "No volume is being touched: start with Plugins > Palpate > Touch Volume...",
        refusal(CurrentSession::current));
    CurrentSession.stop();
  }

  @Test
  void aReplayEndsByItselfAndItsSamplesAreRecorded() throws TouchRefusedException, IOException {
    StringBuilder rows = new StringBuilder("t_ms,x,y,z\n");
    for (int n = 0; n < 300; n++) {
      rows.append(n).append(",12,12,").append(20 - n / 50.0).append('\n');
    }
    Path input = Files.writeString(folder.resolve("t.csv"), rows);
    Path output = folder.resolve("recorded.csv");
    StackSessionRunner.begin(
        volume,
        ChosenOptions.floor("replay:" + input, 100, Map.of()),
        Optional.of(new TrajectoryRecording(output)));
    for (int n = 0; n < 3000 && CurrentSession.isRunning(); n++) {
      java.util.concurrent.locks.LockSupport.parkNanos(10_000_000);
    }
    assertFalse(CurrentSession.isRunning());
    List<String> lines = Files.readAllLines(output);
    assertTrue(lines.get(0).startsWith("t_ms,x,y,z"), lines.get(0));
    assertTrue(lines.size() > 100, lines.size() + " lines");
  }

  @Test
  void whatDoesNotAllowASessionIsSaidBeforeItStarts() {
    assertEquals(
        "No voxel has a value from 201.0 to 255.0: choose other thresholds.",
        refusal(
            () ->
                StackSessionRunner.begin(
                    volume, ChosenOptions.floor("simulated", 201, Map.of()), Optional.empty())));
    assertEquals(
        "There is no segment \"jaw\" for this material: choose one of floor.",
        refusal(
            () ->
                StackSessionRunner.begin(
                    volume,
                    ChosenOptions.floor("simulated", 100, Map.of("jaw", MaterialOverride.NONE)),
                    Optional.empty())));
    assertFalse(CurrentSession.isRunning());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "banana|There is no device \"banana\": write simulated, mouse, replay:FILE.csv, or see"
            + " Plugins > Palpate > Devices...",
        "replay:|The recorded trajectory is missing: enter its path.",
        "replay:/no/such.csv|The trajectory cannot be read: no such file: /no/such.csv: check the"
            + " path"
      })
  void aDeviceThatIsNotThereIsRefused(String device, String sentence) {
    assertEquals(sentence, refusal(() -> begin(device)));
    assertFalse(CurrentSession.isRunning());
  }

  private static String refusal(org.junit.jupiter.api.function.Executable call) {
    return assertThrows(TouchRefusedException.class, call).getMessage();
  }
}
