package org.palpate.app.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.palpate.app.options.SceneElasticity;
import org.palpate.app.options.VolumeOptions;
import org.palpate.app.options.VolumeSource;
import org.palpate.app.process.PalpateException;
import org.palpate.body.BodyGroups;
import org.palpate.body.Mobility;
import org.palpate.body.Placement;
import org.palpate.geometry.Pose;
import org.palpate.io.GreyVolumes;
import org.palpate.io.VolumeFiles;
import org.palpate.io.scene.BodyReader;
import org.palpate.io.scene.PlacedVolume;
import org.palpate.io.scene.SceneFile;
import org.palpate.io.scene.SceneReader;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.io.volume.ReadOptions;
import org.palpate.volume.BitCube;
import org.palpate.volume.ScalarVolume;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;
import picocli.CommandLine;

class FragmentExportTest {
  @TempDir private Path folder;

  /** Two cubes of 8 voxels; the second one is moved by 5 mm along x. */
  private PlacedVolume bodies(CoordinateSystem world) {
    Pose moved = new Pose();
    moved.translation.set(5, 0, 0);
    return new PlacedVolume(
        new SegmentedVolume(
            VoxelGrid.ofUnitVoxels(16, 8, 8), List.of(cube("base", 1), cube("part", 4))),
        List.of(new Placement(Mobility.FIXED, new Pose()), new Placement(Mobility.MOVABLE, moved)),
        world,
        List.of(),
        List.of(),
        Optional.empty());
  }

  private static Segment cube(String name, int low) {
    BitCube bits = new BitCube(16, 8, 8);
    for (int n = 0; n < 8; n++) {
      bits.set(low + (n & 1), 2 + (n >> 1 & 1), 2 + (n >> 2));
    }
    return new Segment(name, bits, 0x808080);
  }

  private static ScalarVolume labels(Path file) throws IOException {
    return GreyVolumes.read(VolumeFiles.open(file, ReadOptions.defaults()));
  }

  @Test
  void withoutPosesTheVolumeHoldsTheBodiesWhereTheyStand() throws IOException {
    Path file = folder.resolve("l.nrrd");
    FragmentExport export = new FragmentExport(file, Optional.empty(), Optional.empty());
    assertFalse(export.writesPoses());
    assertEquals(List.of(), export.checked(List.of(), false));
    assertEquals(
        List.of("written: " + file + ": NRRD, gzip"), export.write(bodies(CoordinateSystem.LPS)));
    assertEquals(1, labels(file).value(1, 2, 2));
    assertEquals(0, labels(file).value(4, 2, 2));
    assertEquals(2, labels(file).value(9, 2, 2));
  }

  @Test
  void aSceneNamesTheBodiesAtRestAndIsReadBack() throws IOException {
    Path below = Files.createDirectory(folder.resolve("below"));
    Path volume = below.resolve("l.nrrd");
    Path scene = folder.resolve("s.json");
    FragmentExport export = new FragmentExport(volume, Optional.of(scene), Optional.empty());
    assertTrue(export.writesPoses());
    Path table = folder.resolve("s.groups.csv");
    assertEquals(List.of(scene, table), export.checked(List.of(), false));
    assertEquals(2, export.write(bodies(CoordinateSystem.LPS)).size());
    assertEquals(2, labels(volume).value(4, 2, 2), "at rest");
    SceneFile read = SceneReader.read(scene);
    assertEquals("below/l.nrrd", read.bodies().get(0).source());
    PlacedVolume again = BodyReader.read(read, scene);
    assertEquals(Mobility.MOVABLE, again.placements().get(1).mobility());
    assertTrue(
        again
            .placements()
            .get(1)
            .pose()
            .sameBits(bodies(CoordinateSystem.LPS).placements().get(1).pose()));
    assertEquals(8, again.rest().segments().get(1).bits().solidCount());
  }

  private PlacedVolume read(Path scene) throws IOException {
    return BodyReader.read(SceneReader.read(scene), scene);
  }

  private FragmentExport sceneExport(String name) {
    return new FragmentExport(
        folder.resolve("l.nrrd"), Optional.of(folder.resolve(name)), Optional.empty());
  }

  @Test
  void locksLieBesideTheSceneAndAreKeptFromSceneToScene() throws IOException {
    Path scene = folder.resolve("s.json");
    Path table = folder.resolve("s.groups.csv");
    Optional<BodyGroups> locked = Optional.of(BodyGroups.none(2).withLock(1, true));
    List<String> lines =
        sceneExport("s.json").write(bodies(CoordinateSystem.LPS), locked, SceneElasticity.NONE);
    assertEquals("written: " + table + ": locks and attachments", lines.get(2));
    assertTrue(read(scene).groups().orElseThrow().isLocked(1));
    sceneExport("copy.json").write(read(scene));
    assertTrue(read(folder.resolve("copy.json")).groups().orElseThrow().isLocked(1));
    sceneExport("s.json").write(bodies(CoordinateSystem.LPS));
    assertFalse(Files.exists(table), "the locks of another scene are not those of this one");
  }

  @Test
  void aTableThatCannotBeWrittenKeepsTheScene() throws IOException {
    Path scene = Files.writeString(folder.resolve("s.json"), "older");
    Path table = Files.createDirectory(folder.resolve("s.groups.csv"));
    Files.writeString(table.resolve("content"), "");
    FragmentExport export = sceneExport("s.json");
    assertTrue(
        assertThrows(PalpateException.class, () -> export.checked(List.of(), false))
            .getMessage()
            .startsWith("the target is a folder: --save-scene " + table));
    for (boolean isLocked : new boolean[] {false, true}) {
      Optional<BodyGroups> groups = Optional.of(BodyGroups.none(2).withLock(1, isLocked));
      PlacedVolume bodies = bodies(CoordinateSystem.LPS);
      assertThrows(
          PalpateException.class, () -> export.write(bodies, groups, SceneElasticity.NONE));
      assertEquals("older", Files.readString(scene));
    }
  }

  @Test
  @EnabledOnOs(value = OS.LINUX, disabledReason = "skipped: no /dev/null on this system")
  void aSceneThatGoesToADeviceHasNoTable() throws IOException {
    Path table = Files.writeString(folder.resolve("s.groups.csv"), "older");
    Files.createSymbolicLink(folder.resolve("s.json"), Path.of("/dev/null"));
    Optional<BodyGroups> locked = Optional.of(BodyGroups.none(2).withLock(1, true));
    PlacedVolume bodies = bodies(CoordinateSystem.LPS);
    assertEquals(2, sceneExport("s.json").write(bodies, locked, SceneElasticity.NONE).size());
    assertEquals("older", Files.readString(table));
  }

  @Test
  void transformsAreFilesOfTheirBodies() throws IOException {
    Path poses = folder.resolve("poses");
    FragmentExport export = new FragmentExport(null, Optional.empty(), Optional.of(poses));
    assertEquals(List.of(), export.checked(List.of(), false));
    assertEquals(
        List.of("written: " + poses + ": transforms"), export.write(bodies(CoordinateSystem.RAS)));
    String part = Files.readString(poses.resolve("part.tfm"));
    assertTrue(part.contains("Parameters: 1.0 0.0 0.0 0.0 1.0 0.0 0.0 0.0 1.0 -5.0 "), part);
    assertTrue(Files.exists(poses.resolve("base.tfm")));
    assertEquals(
        List.of("written: " + poses + ": transforms; the axes are not named and are taken as LPS"),
        export.write(bodies(CoordinateSystem.UNKNOWN)));
  }

  @Test
  void aSceneNeedsAVolume() {
    PalpateException refusal =
        assertThrows(
            PalpateException.class,
            () ->
                new FragmentExport(null, Optional.of(Path.of("s.json")), Optional.empty())
                    .checked(List.of(), false));
    assertEquals(
        "the bodies of the scene have no volume: --save-scene s.json: add --export FILE",
        refusal.getMessage());
  }

  @Test
  void aFolderIsNoFileAndASceneNoInput() throws IOException {
    Path file = Files.writeString(folder.resolve("f"), "");
    assertTrue(
        assertThrows(
                PalpateException.class,
                () ->
                    new FragmentExport(null, Optional.empty(), Optional.of(file))
                        .checked(List.of(), false))
            .getMessage()
            .startsWith("the target is not a folder: --save-transforms "));
    assertTrue(
        assertThrows(
                PalpateException.class,
                () ->
                    new FragmentExport(file, Optional.of(file), Optional.empty())
                        .checked(List.of(file), false))
            .getMessage()
            .startsWith("the target is an input: --save-scene "));
  }

  @Test
  void posesAreForVolumesThatHaveThem() throws IOException {
    PoseOptions options = CommandLine.populateCommand(new PoseOptions(), "--save-scene=s.json");
    assertEquals(Optional.of(Path.of("s.json")), options.scene());
    VolumeSource plain = source("--phantom=sphere:16");
    assertEquals(
        "the volume has no bodies with poses: phantom sphere:16: choose --scene or --phantom"
            + " fracture",
        assertThrows(PalpateException.class, () -> options.export(null, plain, false))
            .getMessage());
    assertTrue(options.export(null, source("--phantom=fracture:64:2"), false).writesPoses());
    PoseOptions none = CommandLine.populateCommand(new PoseOptions());
    assertFalse(none.export(null, plain, false).writesPoses());
  }

  private static VolumeSource source(String argument) throws IOException {
    return VolumeSource.open(CommandLine.populateCommand(new VolumeOptions(), argument));
  }
}
