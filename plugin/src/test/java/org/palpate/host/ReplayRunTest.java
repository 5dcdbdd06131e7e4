package org.palpate.host;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.palpate.device.DeviceState;
import org.palpate.device.ReadStatus;
import org.palpate.device.Trajectory;
import org.palpate.edit.EditSchedule;
import org.palpate.edit.VoxelChange;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;

class ReplayRunTest {
  private static final int SIZE = 16;

  @TempDir private Path folder;

  /** Returns a floor of 8 voxels in a grid whose axes x and y are exchanged in the world. */
  private static ContactScene floor() {
    BitCube bits = new BitCube(SIZE, SIZE, SIZE);
    for (int n = 0; n < SIZE * SIZE * 8; n++) {
      bits.set(n % SIZE, n / SIZE % SIZE, n / SIZE / SIZE);
    }
    VoxelGrid grid =
        new VoxelGrid(
            SIZE,
            SIZE,
            SIZE,
            new Vec3(1, 1, 2),
            new RigidTransform(
                new Vec3(0, 1, 0), new Vec3(1, 0, 0), new Vec3(0, 0, 1), new Vec3(100, 0, 0)));
    return new ContactScene(
        new SegmentedVolume(grid, List.of(new Segment("floor", bits, 0))),
        ContactSettings.builder(SolverKind.GUARDED).stiffness(0.5).friction(0).build());
  }

  /** Returns a path down into the floor and along it, in grid coordinates or in the world. */
  private static Trajectory path(boolean world) {
    Trajectory path = new Trajectory();
    Vec3 at = new Vec3();
    for (int n = 0; n < 80; n++) {
      at.set(4 + 0.05 * n, 8, Math.max(6, 11 - 0.1 * n));
      if (world) {
        floor().grid().gridToWorld(at, at);
      }
      path.add(n, at.x, at.y, at.z);
    }
    return path;
  }

  private static List<String> rows(ReplayRun run) throws IOException {
    List<String> rows = new ArrayList<>();
    run.run(
        (frame, device, point, force, state, freed) ->
            rows.add(frame + " " + point + " " + force + " " + state.contact + " " + freed));
    return rows;
  }

  @Test
  void thePointStaysOnTheFloorAndTheForcePushesOut() throws IOException {
    ReplayRun.Result result =
        ReplayRun.inGrid(floor(), path(false))
            .run(
                (frame, device, point, force, state, freed) -> {
                  assertTrue(point.z > 8 - 1e-9, "frame " + frame + " at " + point);
                  if (device.z < 8 - 0.01) {
                    assertTrue(state.contact, "frame " + frame);
                    assertEquals(0.5 * 2 * (point.z - device.z), force.z, 1e-6, "frame " + frame);
                  } else if (device.z > 8 + 0.01) {
                    assertEquals(0, force.length(), "frame " + frame);
                  }
                });
    assertEquals(80, result.statistics().frames());
    assertTrue(result.statistics().contactFrames() >= 48);
    assertTrue(result.work().max() >= result.work().p50() && result.work().p50() > 0);
    assertFalse(result.elastic().isPresent() || result.mass().isPresent());
  }

  @Test
  void theSameInputGivesTheSameBits() throws IOException {
    assertEquals(
        rows(ReplayRun.inGrid(floor(), path(false))), rows(ReplayRun.inGrid(floor(), path(false))));
  }

  @Test
  void aPathInTheWorldGivesForcesAlongItsAxes() throws IOException {
    List<Vec3> grid = new ArrayList<>();
    List<Vec3> world = new ArrayList<>();
    ReplayRun.inGrid(floor(), path(false))
        .run((frame, device, point, force, state, freed) -> keep(point, force, grid));
    ReplayRun.inWorld(floor(), path(true))
        .run((frame, device, point, force, state, freed) -> keep(point, force, world));
    for (int n = 0; n < grid.size(); n += 2) {
      Vec3 expected = floor().grid().gridToWorld(grid.get(n), new Vec3());
      assertEquals(0, expected.sub(world.get(n), expected).length(), 1e-9, "frame " + n / 2);
      Vec3 force = floor().grid().gridMmToWorld().rotate(grid.get(n + 1), new Vec3());
      assertEquals(0, force.sub(world.get(n + 1), force).length(), 1e-9, "frame " + n / 2);
    }
  }

  private static void keep(Vec3 point, Vec3 force, List<Vec3> all) {
    all.add(new Vec3().set(point));
    all.add(new Vec3().set(force));
  }

  @Test
  void recordedEditsChangeTheVoxelsBeforeTheirFrame() throws IOException {
    ContactScene scene = floor();
    List<VoxelChange> changes = new ArrayList<>();
    for (int n = 0; n < SIZE * SIZE; n++) {
      changes.add(new VoxelChange(60, 0, n % SIZE, n / SIZE, 7, false));
    }
    changes.add(new VoxelChange(500, 0, 3, 3, 12, true));
    List<Double> heights = new ArrayList<>();
    ReplayRun.inGrid(scene, path(false))
        .withEdits(new EditSchedule(changes))
        .run((frame, device, point, force, state, freed) -> heights.add(point.z));
    assertTrue(heights.get(59) > 8 - 1e-9, "still on the floor: " + heights.get(59));
    assertTrue(heights.get(79) < 7.5, "a layer lower: " + heights.get(79));
    BitCube bits = scene.volume().segments().get(0).bits();
    assertFalse(bits.get(3, 3, 7));
    assertTrue(bits.get(3, 3, 12), "made after the last sample");
  }

  @Test
  void rawModeKeepsTheLastSampleInsteadOfABadOne() throws IOException {
    Trajectory path = new Trajectory();
    path.add(0, 4, 8, 12);
    path.add(1, 4.5, 8, 12);
    path.add(2, Double.NaN, 8, 12);
    path.add(0.5, 9, 8, 12);
    path.add(3, 5, 8, 12);
    List<Double> x = new ArrayList<>();
    ReplayRun.Result result =
        ReplayRun.inGrid(floor(), path)
            .inRawMode()
            .run((frame, device, point, force, state, freed) -> x.add(point.x));
    assertEquals(List.of(4.0, 4.5, 4.5, 4.5, 5.0), x);
    assertEquals(1, result.statistics().faults().notFinite());
    assertEquals(1, result.statistics().faults().badTimes());
  }

  @Test
  void aStartInsideTheFloorIsSetFree() throws IOException {
    Trajectory path = new Trajectory();
    path.add(0, 4.5, 8.5, 7.5);
    path.add(1, 4.5, 8.5, 7.5);
    List<Boolean> freed = new ArrayList<>();
    ReplayRun.inGrid(floor(), path)
        .run((frame, device, point, force, state, wasFreed) -> freed.add(wasFreed));
    assertEquals(List.of(true, false), freed);
  }

  @Test
  void aTimingRunsTheSameFrames() {
    ReplayTiming timing = new ReplayTiming(floor(), path(false), false);
    ReplayTiming.NanosPerFrame nanos = timing.run(5);
    assertTrue(nanos.min() > 0 && nanos.min() <= nanos.median() && nanos.median() <= nanos.max());
  }

  @Test
  void onlyThePassesAfterTheFirstTwoAreCounted() {
    List<String> calls = new ArrayList<>();
    ReplayTiming.NanosPerFrame nanos =
        ReplayTiming.measure(
            3,
            10,
            () -> calls.add("begin"),
            () -> {
              calls.add("pass");
              long end = System.nanoTime() + (calls.size() < 5 ? 20_000_000 : 1_000_000);
              while (System.nanoTime() < end) {
                Thread.onSpinWait();
              }
            });
    assertEquals(List.of("begin", "pass", "begin", "pass", "begin", "pass"), calls);
    assertEquals(nanos.min(), nanos.max(), "one pass counts");
    assertTrue(nanos.min() >= 100_000, "a millisecond over ten frames: " + nanos.min());
  }

  @Test
  void aTrajectoryGivesASampleAtEachReadAndThenEnds() {
    Trajectory path = new Trajectory();
    path.add(5, 1, 2, 3);
    path.add(7.5, 4, 5, 6);
    DeviceState state = new DeviceState();
    TrajectoryDevice own = new TrajectoryDevice(path, true);
    assertEquals(ReadStatus.FRESH, own.read(state));
    assertEquals(5_000_000, state.timeNanos);
    assertEquals("(1.0, 2.0, 3.0)", own.lastPosition().toString());
    assertEquals(ReadStatus.FRESH, own.read(state));
    assertEquals(7_500_000, state.timeNanos);
    assertEquals(ReadStatus.DISCONNECTED, own.read(state));
    assertEquals("(4.0, 5.0, 6.0)", own.lastPosition().toString());
    Trajectory standing = new Trajectory();
    standing.add(5, 1, 2, 3);
    standing.add(5, 4, 5, 6);
    TrajectoryDevice ever = new TrajectoryDevice(standing, false);
    ever.read(state);
    assertEquals(5_000_000, state.timeNanos);
    ever.read(state);
    assertEquals(5_000_001, state.timeNanos, "a later sample is newer");
    assertTrue(ever.write(new Vec3(1, 1, 1), new Vec3()));
  }

  @Test
  void jumpsOfAMouseAreReadFromTheFile() throws IOException {
    Path file = folder.resolve("t.csv");
    Files.writeString(file, "t_ms,x,y,z,flags\n0,1,2,3,0\n1,7,8,9,4\n2,7,8,9,3\n3,7,8,9,5\n");
    Trajectory read = TrajectoryFile.read(file, true);
    DeviceState state = new DeviceState();
    List<Boolean> relocated = new ArrayList<>();
    for (int n = 0; n < read.size(); n++) {
      read.read(n, state);
      relocated.add(state.relocated);
    }
    assertEquals(List.of(false, true, false, true), relocated);
    Files.writeString(file, "t_ms,x,y,z\n0,1,2,nan\n");
    assertThrows(IOException.class, () -> TrajectoryFile.read(file, true));
    assertEquals(1, TrajectoryFile.read(file, false).size());
  }
}
