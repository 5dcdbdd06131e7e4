package org.palpate.io.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.palpate.geometry.Vec3;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

class GhostsTest {
  @TempDir private Path folder;

  /** Writes four voxels along x: 0, 1, 2 and 3. */
  private Path volume(String name, String space) throws IOException {
    String header =
        "NRRD0004\ntype: uint8\ndimension: 3\n"
            + space
            + "sizes: 4 1 1\nencoding: raw\nspace directions: (1,0,0) (0,1,0) (0,0,1)\n"
            + "space origin: (10.5,20.5,30.5)\n\n\0\1\2\3";
    return Files.write(folder.resolve(name), header.getBytes(StandardCharsets.ISO_8859_1));
  }

  private static Ghosts read(String... texts) throws VolumeFormatException {
    return Ghosts.read(List.of(texts), CoordinateSystem.LPS);
  }

  private static void mustRefuse(String text, String what, String remedy) {
    VolumeFormatException refusal =
        assertThrows(VolumeFormatException.class, () -> read(text), text);
    assertEquals(what + ": --ghost " + text + ": " + remedy, refusal.getMessage());
  }

  @Test
  void allThatIsNotZeroIsAGhostUnlessARuleChooses() throws IOException {
    Path file = volume("a.nrrd", "space: left-posterior-superior\n");
    Ghosts ghosts = read("" + file, file + ":label:2", file + ":>=2", file + ":1..2");
    assertEquals(
        List.of("ghost", "ghost2", "ghost3", "ghost4"),
        ghosts.segments().segments().stream().map(ghost -> ghost.name()).toList());
    assertEquals(
        List.of(3L, 1L, 2L, 2L),
        ghosts.segments().segments().stream().map(ghost -> ghost.bits().solidCount()).toList());
    assertTrue(ghosts.segments().segments().get(1).bits().get(2, 0, 0));
    assertTrue(ghosts.files().contains(file));
    assertEquals(List.of(), ghosts.notes());
  }

  @Test
  void aFileIsTurnedIntoTheWorldOfTheSceneIfItsAxesAreKnown() throws IOException {
    Path turned = volume("ras.nrrd", "space: right-anterior-superior\n");
    Path unknown = volume("u.nrrd", "space dimension: 3\n");
    Ghosts ghosts = read("" + turned, "" + unknown);
    Vec3 corner = new Vec3();
    Vec3 inLps = ghosts.segments().grid(0).gridToWorld(corner, new Vec3());
    assertEquals(0, inLps.sub(new Vec3(-10, -20, 30), new Vec3()).length(), 1e-9, "" + inLps);
    Vec3 asIs = ghosts.segments().grid(1).gridToWorld(corner, new Vec3());
    assertEquals(0, asIs.sub(new Vec3(10, 20, 30), new Vec3()).length(), 1e-9, "" + asIs);
    assertEquals(
        List.of("The world axes of " + unknown + " are taken as those of the scene."),
        ghosts.notes());
  }

  @Test
  void aClosedMeshIsAGhostOfFineVoxelsInTheWorldOfTheScene() throws IOException {
    Path file = BoxMesh.write(folder.resolve("box.obj"), "SPACE=RAS", false);
    Ghosts ghosts = read("" + volume("a.nrrd", "space: left-posterior-superior\n"), "" + file);
    assertEquals("ghost2", ghosts.segments().segments().get(1).name());
    VoxelGrid grid = ghosts.segments().grid(1);
    assertEquals(5.0 / 256, grid.spacingMm().x);
    BitCube bits = ghosts.segments().segments().get(1).bits();
    double volume = bits.solidCount() * Math.pow(5.0 / 256, 3);
    assertEquals(4 * 3 * 5, volume, 0.02 * volume);
    Vec3 inside = grid.worldToGrid(new Vec3(-3.9, -2.9, 4.9), new Vec3());
    assertTrue(bits.get((int) inside.x, (int) inside.y, (int) inside.z));
    assertTrue(ghosts.files().contains(file));
    assertEquals(List.of(), ghosts.notes());
  }

  @Test
  void anOpenMeshAndOneWithARuleAreRefusedInOneLine() throws IOException {
    mustRefuse(
        BoxMesh.write(folder.resolve("box.obj"), "SPACE=RAS", false) + ":>=2",
        "a mesh has no values to choose from",
        "name the mesh alone");
    Path open = BoxMesh.write(folder.resolve("open.obj"), "SPACE=RAS", true);
    String refusal = assertThrows(VolumeFormatException.class, () -> read("" + open)).getMessage();
    assertEquals(
        "the mesh is open, so it has no inside: " + open + ": close its holes, and export it again",
        refusal);
  }

  @Test
  void aNameMayHaveAColon() throws IOException {
    Path file = volume("a:b.nrrd", "space: left-posterior-superior\n");
    assertEquals(1, read(file + ":label:3").segments().segments().get(0).bits().solidCount());
    assertEquals(3, read("" + file).segments().segments().get(0).bits().solidCount());
  }

  @Test
  void whatIsNoGhostIsRefusedInOneLine() throws IOException {
    Path file = volume("a.nrrd", "space: left-posterior-superior\n");
    String rules = "write FILE, 'FILE:>=1500', FILE:300..900, FILE:label:7 or FILE:name:Mandible";
    String what = "the voxels of the ghost are not understood";
    mustRefuse(file + ":label:", what, rules);
    mustRefuse(file + ":solid", what, rules);
    mustRefuse(
        file + ":label:9",
        "the ghost has no voxel",
        "palpate info --volume prints the values of a volume");
    mustRefuse(
        file + ":name:Mandible",
        "the volume has no label of this name",
        "choose one that palpate info prints, or write FILE:label:7");
    String missing = assertThrows(VolumeFormatException.class, () -> read("no.nrrd")).getMessage();
    assertEquals("no such file: no.nrrd: check the path", missing);
  }
}
