package org.palpate.host.placing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.palpate.body.BodyGroups;
import org.palpate.body.Mobility;
import org.palpate.body.Placement;
import org.palpate.frame.ToolFrame;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.host.ToolScene;
import org.palpate.host.TouchSession;
import org.palpate.io.scene.AutosaveFiles;
import org.palpate.io.scene.BodyReader;
import org.palpate.io.scene.OpenedScene;
import org.palpate.io.scene.PlacedVolume;
import org.palpate.io.scene.SavedScene;
import org.palpate.io.scene.SceneFile;
import org.palpate.io.scene.SceneReader;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.testing.SameVoxels;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;

class SceneAutosaveTest {
  private static final long PERIOD_NANOS = 50_000_000;
  private static final BodyGroups FREE = BodyGroups.none(2);

  @TempDir private Path folder;

  private final VoxelGrid grid = VoxelGrid.ofUnitVoxels(32, 32, 32);
  private final BitCube floor = box(0, 32, 4);
  private final BitCube block = box(8, 16, 12);
  private final List<IOException> failures = new ArrayList<>();
  private SavedScene target;

  private BitCube box(int low, int high, int top) {
    BitCube bits = new BitCube(grid.sizeX(), grid.sizeY(), grid.sizeZ());
    for (int k = low; k < top; k++) {
      for (int j = low; j < high; j++) {
        for (int i = low; i < high; i++) {
          bits.set(i, j, k);
        }
      }
    }
    return bits;
  }

  private PlacedVolume bodies(Optional<OpenedScene> origin) {
    List<Segment> segments =
        List.of(new Segment("floor", floor, 1), new Segment("block", block, 2));
    List<Placement> placements =
        List.of(
            new Placement(Mobility.FIXED, new Pose()),
            new Placement(Mobility.MOVABLE, Pose.at(0, 0, 1)));
    return new PlacedVolume(
        new SegmentedVolume(grid, segments),
        placements,
        CoordinateSystem.LPS,
        List.of(),
        List.of(),
        origin);
  }

  @BeforeEach
  void claim() throws IOException {
    target = AutosaveFiles.beside(folder.resolve("jaw.json")).claim();
  }

  @AfterEach
  void giveBack() throws IOException {
    target.close();
  }

  private SceneAutosave autosave(PlacedVolume bodies, boolean cuts) {
    return new SceneAutosave(bodies, cuts, null, target, failures::add);
  }

  private static List<Pose> poses(double xMm) {
    Pose pose = Pose.at(xMm, 1 / 3.0, 0.1);
    pose.rotation.setRotationVector(new Vec3(0.1, 0.2, -0.3));
    return List.of(new Pose(), pose);
  }

  private PlacedVolume saved() throws IOException {
    SceneFile scene = SceneReader.read(target.file());
    return BodyReader.read(scene, target.file());
  }

  private List<String> names() throws IOException {
    try (Stream<Path> all = Files.list(folder)) {
      return all.map(file -> file.getFileName().toString())
          .filter(name -> !name.endsWith(".lock"))
          .sorted()
          .toList();
    }
  }

  @Test
  void aMovedFragmentIsSavedWithItsVoxelsToTheBit() throws IOException {
    SceneAutosave autosave = autosave(bodies(Optional.empty()), false);
    autosave.save(poses(1), FREE);
    assertEquals(List.of(), names(), "nothing moved since the session began");
    autosave.save(poses(1), FREE);
    assertEquals(List.of(), names());
    autosave.save(poses(2), FREE);
    assertEquals(List.of("jaw.autosave.json", "jaw.autosave.nrrd"), names());
    PlacedVolume saved = saved();
    assertTrue(saved.poses().get(1).sameBits(poses(2).get(1)));
    assertEquals(Mobility.FIXED, saved.placements().get(0).mobility());
    assertEquals(Mobility.MOVABLE, saved.placements().get(1).mobility());
    assertEquals("block", saved.rest().segments().get(1).name());
    assertEquals(CoordinateSystem.LPS, saved.world());
    SameVoxels.require(floor, saved.rest().segments().get(0).bits(), "floor");
    SameVoxels.require(block, saved.rest().segments().get(1).bits(), "block");
    Files.delete(folder.resolve("jaw.autosave.nrrd"));
    Files.delete(target.file());
    autosave.save(poses(2), FREE);
    assertEquals(List.of(), names(), "nothing moved since");
    autosave.save(poses(3), FREE);
    assertEquals(List.of("jaw.autosave.json"), names(), "voxels are written once");
    target.delete();
    assertEquals(List.of(), names());
    assertEquals(List.of(), failures);
  }

  @Test
  void aSceneNamesTheFilesThatItHad() throws IOException {
    Path scene = Files.createDirectory(folder.resolve("in")).resolve("jaw.json");
    Files.writeString(
        scene,
        """
        {"bodies": [{"name": "floor", "volume": "scans/jaw.nrrd", "segment": "label:1"},
                    {"name": "block", "mesh": "block.stl", "mobility": "movable",
                     "material": "friction:0.1"}],
         "tool": {"spec": "burr.stl"}, "carve": 20}
        """);
    OpenedScene opened = new OpenedScene(SceneReader.read(scene), scene);
    SceneAutosave autosave = autosave(bodies(Optional.of(opened)), false);
    autosave.save(poses(1), FREE);
    autosave.save(poses(2), FREE);
    assertEquals(List.of("in", "jaw.autosave.json"), names());
    SceneFile saved = SceneReader.read(target.file());
    assertEquals("in/scans/jaw.nrrd", saved.bodies().get(0).source());
    assertEquals("in/block.stl", saved.bodies().get(1).source());
    assertEquals(Optional.of("friction:0.1"), saved.bodies().get(1).material());
    assertEquals("in/burr.stl", saved.tool().orElseThrow().spec());
    assertEquals(20, saved.carve().orElseThrow());
    assertTrue(saved.bodies().get(1).pose().sameBits(poses(2).get(1)));
  }

  @Test
  void cutVoxelsAreSavedEvenIfNothingMoves() throws IOException {
    SceneAutosave autosave = autosave(bodies(Optional.empty()), true);
    autosave.save(poses(1), FREE);
    block.clear(8, 8, 8);
    autosave.save(poses(1), FREE);
    SameVoxels.require(block, saved().rest().segments().get(1).bits(), "block");
    BitCube before = block.copy();
    block.clear(9, 8, 8);
    SameVoxels.require(before, saved().rest().segments().get(1).bits(), "as saved before");
    autosave.save(poses(1), FREE);
    SameVoxels.require(block, saved().rest().segments().get(1).bits(), "block");
    block.set(8, 8, 8);
    autosave.save(poses(1), FREE);
    SameVoxels.require(block, saved().rest().segments().get(1).bits(), "block");
  }

  @Test
  void aBodyThatWasCutAwayIsLeftOutUntilUndoBringsItBack() throws IOException {
    SceneAutosave autosave = autosave(bodies(Optional.empty()), true);
    BodyGroups locked = FREE.withLock(1, true);
    autosave.save(poses(1), locked);
    BitCube whole = floor.copy();
    whole.forEachRimVoxel(floor::clear);
    while (floor.solidCount() > 0) {
      floor.copy().forEachRimVoxel(floor::clear);
    }
    autosave.save(poses(2), locked);
    PlacedVolume left = saved();
    assertEquals(List.of("block"), left.names());
    assertTrue(left.poses().get(0).sameBits(poses(2).get(1)));
    assertEquals(Mobility.MOVABLE, left.placements().get(0).mobility());
    SameVoxels.require(block, left.rest().segments().get(0).bits(), "block");
    assertTrue(left.groups().orElseThrow().isLocked(0));
    whole.forEachRimVoxel(floor::set);
    autosave.save(poses(3), FREE);
    assertEquals(List.of("floor", "block"), saved().names());
    assertTrue(saved().poses().get(1).sameBits(poses(3).get(1)));
    assertEquals(Optional.empty(), saved().groups());
  }

  @Test
  void locksAreSavedEvenIfNothingMoves() throws IOException {
    SceneAutosave autosave = autosave(bodies(Optional.empty()), false);
    autosave.save(poses(1), FREE);
    BodyGroups locked = FREE.withLock(1, true);
    autosave.save(poses(1), locked);
    BodyGroups read = saved().groups().orElseThrow();
    assertTrue(read.isLocked(1));
    assertFalse(read.isLocked(0));
    autosave.save(poses(1), locked.withLock(1, false));
    assertEquals(Optional.empty(), saved().groups());
    autosave.save(poses(1), locked);
    target.delete();
    assertEquals(List.of(), names());
  }

  @Test
  void aFailureIsReportedOnceAndTheNextPeriodTriesAgain() throws IOException {
    Path disk = Files.createDirectory(folder.resolve("disk"));
    try (SavedScene removed = AutosaveFiles.beside(disk.resolve("jaw.json")).claim()) {
      SceneAutosave autosave =
          new SceneAutosave(bodies(Optional.empty()), false, null, removed, failures::add);
      autosave.save(poses(1), FREE);
      Path away = Files.move(disk, folder.resolve("away"));
      autosave.save(poses(2), FREE);
      autosave.save(poses(2), FREE);
      assertEquals(1, failures.size(), failures.toString());
      assertFalse(removed.isWritten());
      Files.move(away, disk);
      autosave.save(poses(2), FREE);
      assertTrue(removed.isWritten());
      assertEquals(1, failures.size());
      removed.delete();
    }
  }

  @Test
  void aClosedAutosaveWritesNothing() throws IOException {
    SceneAutosave autosave = autosave(bodies(Optional.empty()), false);
    autosave.save(poses(1), FREE);
    autosave.close();
    autosave.save(poses(2), FREE);
    assertEquals(List.of(), names());
  }

  /** A pose that is not saved to the bit may begin in a solid, and then no scene can be made. */
  @Test
  void aBodyThatAnotherHoldsBackIsSavedWhereItIs() throws IOException, InterruptedException {
    PlacedVolume bodies = bodies(Optional.empty());
    ToolScene scene = PlacedScenes.scene(bodies);
    Pose goal = poses(3).get(1);
    goal.translation.z = -30;
    try (TouchSession session = PlacedScenes.session(scene)) {
      SceneAutosave autosave =
          new SceneAutosave(
              bodies,
              false,
              session.toolFrame().orElseThrow(),
              target,
              failures::add,
              PERIOD_NANOS);
      session.start();
      autosave.start();
      await(session, () -> session.status().frames() > 200);
      session.moveBody("block", goal);
      await(session, () -> Files.exists(target.file()));
      TimeUnit.NANOSECONDS.sleep(20 * PERIOD_NANOS);
      autosave.close();
      session.stop();
      Pose left = scene.bodies().body(1).pose();
      assertTrue(left.translation.z > -10 && left.translation.z < 0, "held back: " + left);
      assertTrue(saved().poses().get(1).sameBits(left));
      assertEquals(2, PlacedScenes.scene(saved()).bodies().count());
    }
    assertEquals(List.of(), failures);
  }

  @Test
  void aBodyIsNotSavedInAPlaceThatWasFilledAfterItHadLeft()
      throws InterruptedException, IOException {
    PlacedVolume bodies = bodies(Optional.empty());
    ToolScene scene = PlacedScenes.scene(bodies);
    try (TouchSession session = PlacedScenes.session(scene)) {
      ToolFrame frame = session.toolFrame().orElseThrow();
      SceneAutosave autosave =
          new SceneAutosave(bodies, true, frame, target, failures::add, 60_000_000_000L);
      autosave.start();
      runWhenAsked(frame, 0);
      scene.bodies().body(1).setPose(Pose.at(0, 0, 30));
      floor.set(10, 10, 12); // where the block was; before the autosave looks at voxels
      for (int n = 1; n < 100 && !Files.exists(target.file()); n++) {
        runWhenAsked(frame, n);
      }
      autosave.close();
    }
    assertEquals(30, saved().poses().get(1).translation.z);
    assertTrue(saved().rest().segments().get(0).bits().get(10, 10, 12));
    assertEquals(List.of(), failures);
  }

  /** Runs a frame as soon as the poses that it leaves are requested, or after 50 ms. */
  private static void runWhenAsked(ToolFrame frame, int n) throws InterruptedException {
    for (int wait = 0; wait < 50 && frame.snapshot().isReady(); wait++) {
      TimeUnit.MILLISECONDS.sleep(1);
    }
    frame.run(n * 1_000_000L);
  }

  private static void await(TouchSession session, BooleanSupplier isSo)
      throws InterruptedException {
    for (int tick = 0; tick < 2000 && !isSo.getAsBoolean(); tick++) {
      assertFalse(session.supervise(), "the session goes on");
      TimeUnit.MILLISECONDS.sleep(10);
    }
    assertTrue(isSo.getAsBoolean());
  }
}
