package org.palpate.app.output;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.app.output.ToolTables.LegSelection;
import org.palpate.app.process.PalpateException;
import org.palpate.device.Trajectory;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;

class ReplayTablesTest {
  private static final Vec3 DEVICE = new Vec3(9, 8, 7);
  private static final Vec3 POINT = new Vec3(1, 2, 3);
  private static final Vec3 FORCE = new Vec3(0.1, 0.2, 0.3);

  @TempDir private Path folder;

  private final StringWriter said = new StringWriter();
  private final WriteFailures failures = new WriteFailures(new PrintWriter(said));
  private final Trajectory trajectory = new Trajectory();
  private final InteractionPoint state = new InteractionPoint();

  private ReplayTables checked(Path frames, Path legs, Path... inputs) {
    return ReplayTables.checked(frames, legs, Optional.empty(), List.of(inputs), failures);
  }

  /** Adds two frames: one that sets the point free and moves it twice, and one at rest. */
  private void addFrames(ReplayTables tables) throws IOException {
    trajectory.add(0, 0, 0, 0);
    trajectory.add(1.5, 0, 0, 0);
    tables.open(trajectory);
    state.position.set(5, 5, 5);
    state.legs.add(1, 1, 1, 2, 1, 1, 1, false);
    state.legs.add(2, 1, 1, 2, 3, 1, 2, true);
    state.contact = true;
    tables.accept(0, DEVICE, POINT, FORCE, state, true);
    state.legs.clear();
    state.contact = false;
    tables.accept(1, POINT, DEVICE, FORCE, state, false);
  }

  @Test
  void framesAndLegsStandInTheirTables() throws IOException {
    Path frames = folder.resolve("f.csv");
    Path legs = folder.resolve("l.csv");
    try (ReplayTables tables = checked(frames, legs)) {
      addFrames(tables);
      assertFalse(Files.exists(frames), "nothing is there before it is whole");
      tables.commit();
    }
    assertEquals(
        """
        frame,t_ms,dx,dy,dz,px,py,pz,fx,fy,fz,contact,path
        0,0.0,9.0,8.0,7.0,1.0,2.0,3.0,0.1,0.2,0.3,1,3.0
        1,1.5,1.0,2.0,3.0,9.0,8.0,7.0,0.1,0.2,0.3,0,0.0
        """,
        Files.readString(frames));
    assertEquals(
        """
        frame,leg,x0,y0,z0,x1,y1,z1
        0,-1,1.0,1.0,1.0,1.0,1.0,1.0
        0,0,1.0,1.0,1.0,2.0,1.0,1.0
        0,1,2.0,1.0,1.0,2.0,3.0,1.0
        """,
        Files.readString(legs));
    assertEquals("", said.toString());
  }

  @Test
  void aPointThatWasSetFreeAndDidNotMoveBeginsWhereItIs() throws IOException {
    Path legs = folder.resolve("l.csv");
    try (ReplayTables tables = checked(null, legs)) {
      trajectory.add(0, 0, 0, 0);
      tables.open(trajectory);
      state.position.set(5, 6, 7);
      tables.accept(0, DEVICE, POINT, FORCE, state, true);
      tables.commit();
    }
    assertEquals(
        "frame,leg,x0,y0,z0,x1,y1,z1\n0,-1,5.0,6.0,7.0,5.0,6.0,7.0\n", Files.readString(legs));
  }

  @Test
  void whatIsNotCommittedIsDiscarded() throws IOException {
    Path frames = folder.resolve("f.csv");
    try (ReplayTables tables = checked(frames, null)) {
      addFrames(tables);
    }
    assertFalse(Files.exists(frames));
    try (var left = Files.list(folder)) {
      assertEquals(List.of(), left.toList());
    }
  }

  @Test
  void targetsAreCheckedBeforeTheWork() throws IOException {
    Path input = Files.writeString(folder.resolve("in.csv"), "");
    refuses("the target is an input: --out " + input, () -> checked(input, null, input));
    refuses("the target is an input: --legs " + input, () -> checked(null, input, input));
    Path one = folder.resolve("one.csv");
    refuses("two outputs have the same file: " + one, () -> checked(one, one));
    refuses(
        "two outputs have the same file: " + one,
        () -> ReplayTables.checked(one, null, Optional.of(one), List.of(), failures));
  }

  private static void refuses(String start, org.junit.jupiter.api.function.Executable call) {
    PalpateException refusal = assertThrows(PalpateException.class, call);
    assertTrue(refusal.getMessage().startsWith(start), refusal.getMessage());
    assertEquals(PalpateException.WRONG_USE, refusal.exitCode());
  }

  @Test
  @EnabledOnOs(value = OS.LINUX, disabledReason = "skipped: no /dev/full on this system")
  void aTableThatFailsDoesNotTakeTheOtherAlong() throws IOException {
    Path legs = folder.resolve("l.csv");
    Path full = Path.of("/dev/full");
    try (ReplayTables tables = checked(full, legs)) {
      addFrames(tables);
      for (int n = 0; n < 2000; n++) {
        tables.accept(1, POINT, DEVICE, FORCE, state, false);
      }
      tables.commit();
    }
    assertEquals(4, Files.readAllLines(legs).size());
    assertEquals(
        "palpate: could not be written (No space left on device): /dev/full: check the disk and its"
            + " permissions"
            + System.lineSeparator(),
        said.toString());
    assertEquals(1, failures.exitCode());
  }

  @Test
  void legsMayBeSelected() {
    assertEquals(LegSelection.ALL, LegSelection.parse(null, null));
    assertEquals(new LegSelection(10, 0, Long.MAX_VALUE), LegSelection.parse(10, null));
    assertEquals(new LegSelection(1, 3, 999), LegSelection.parse(null, "3..999"));
    assertEquals(new LegSelection(2, 7, 7), LegSelection.parse(2, " 7 .. 7 "));
  }

  @ParameterizedTest
  @ValueSource(strings = {"9..3", "3", "3..", "..3", "-1..3", "a..b", "3...4", "1.5..2", ""})
  void aRangeOfFramesHasTwoNumbersInOrder(String range) {
    PalpateException refusal =
        assertThrows(PalpateException.class, () -> LegSelection.parse(null, range));
    assertEquals(
        "a range of frames is needed: --legs-frames "
            + range
            + ": write A..B with the first and the last frame, as in --legs-frames 0..999",
        refusal.getMessage());
  }

  @ParameterizedTest
  @CsvSource({"0, 0", "-1, -1"})
  void everySoManyPointsIsAtLeastOne(int every, String text) {
    PalpateException refusal =
        assertThrows(PalpateException.class, () -> LegSelection.parse(every, null));
    assertEquals(
        "the number must be a number from 1 to 2,147,483,647: --legs-every "
            + text
            + ": try --legs-every 10",
        refusal.getMessage());
  }
}
