package org.palpate.io.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.palpate.geometry.Vec3;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.volume.BitCube;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;

class BodyReaderTest {
  private static final String LPS = "left-posterior-superior";
  private static final String RAS = "right-anterior-superior";

  @TempDir private Path folder;

  /** Writes a volume of 4 x 4 x 4 voxels of 0.5 mm that are all 1. */
  private void volume(String name, String space, String origin) throws IOException {
    String sign = space.equals(RAS) ? "-" : "";
    String header =
        "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 4 4 4\n"
            + (space.isEmpty() ? "space dimension: 3" : "space: " + space)
            + "\nspace directions: ("
            + sign
            + "0.5,0,0) (0,"
            + sign
            + "0.5,0) (0,0,0.5)\nspace origin: "
            + origin
            + "\nencoding: raw\n\n";
    byte[] start = header.getBytes(StandardCharsets.US_ASCII);
    byte[] bytes = Arrays.copyOf(start, start.length + 64);
    Arrays.fill(bytes, start.length, bytes.length, (byte) 1);
    Files.write(folder.resolve(name), bytes);
  }

  private void mesh(String name, String comment, boolean isOpen) throws IOException {
    BoxMesh.write(folder.resolve(name), comment, isOpen);
  }

  /** Reads a scene of bodies, each {@code volume:FILE} or {@code mesh:FILE}. */
  private PlacedVolume read(String... sources) throws IOException {
    List<String> bodies = new ArrayList<>();
    for (String source : sources) {
      int colon = source.indexOf(':');
      bodies.add(
          "{\"name\": \"b"
              + bodies.size()
              + "\", \""
              + source.substring(0, colon)
              + "\": \""
              + source.substring(colon + 1)
              + "\"}");
    }
    Path file = folder.resolve("s.json");
    Files.writeString(file, "{\"bodies\": [" + String.join(", ", bodies) + "]}");
    return BodyReader.read(SceneReader.read(file), file);
  }

  private static Vec3 corner(VoxelGrid grid) {
    return grid.gridToWorld(new Vec3(), new Vec3());
  }

  @Test
  void aVolumeThatLiesOnTheFirstSharesItsGridInWhicheverWorld() throws IOException {
    volume("a.nrrd", LPS, "(1,2,3)");
    volume("same.nrrd", RAS, "(-1,-2,3)");
    volume("beside.nrrd", RAS, "(-1.1,-2,3)");
    SegmentedVolume rest = read("volume:a.nrrd", "volume:same.nrrd", "volume:beside.nrrd").rest();
    assertSame(rest.grid(), rest.grid(1));
    assertFalse(rest.hasOneGrid());
    assertEquals(
        0, corner(rest.grid(2)).sub(new Vec3(0.85, 1.75, 2.75), new Vec3()).length(), 1e-12);
    assertNotEquals(rest.segments().get(0).rgb(), rest.segments().get(1).rgb());
  }

  @Test
  void axesThatAreNotKnownAreTakenAsTheyAreWithANote() throws IOException {
    volume("a.nrrd", LPS, "(1,2,3)");
    volume("unknown.nrrd", "", "(7,2,3)");
    mesh("m.obj", "a box", false);
    PlacedVolume bodies = read("volume:a.nrrd", "volume:unknown.nrrd", "mesh:m.obj");
    assertEquals(CoordinateSystem.LPS, bodies.world());
    assertEquals(6.75, corner(bodies.rest().grid(1)).x, 1e-12);
    assertEquals(2, bodies.notes().size(), bodies.notes().toString());
    assertTrue(bodies.notes().get(1).contains("m.obj are taken as those of the scene"));
    PlacedVolume known = read("volume:unknown.nrrd", "volume:a.nrrd", "mesh:m.obj");
    assertEquals(CoordinateSystem.UNKNOWN, known.world());
    assertEquals(1, known.notes().size(), known.notes().toString());
    mesh("m.obj", "SPACE=LPS", false);
    assertEquals(List.of(), read("volume:a.nrrd", "mesh:m.obj").notes());
  }

  @Test
  void aMeshHasVoxelsAsFineAsTheVolumesInTheWorldOfTheFirst() throws IOException {
    volume("a.nrrd", LPS, "(1,2,3)");
    mesh("m.obj", "SPACE=RAS", false);
    PlacedVolume bodies = read("mesh:m.obj", "volume:a.nrrd");
    VoxelGrid grid = bodies.rest().grid(0);
    assertEquals(0.5, grid.spacingMm().x);
    assertSame(bodies.rest().grid(), bodies.rest().grid(1), "the grid is that of a volume");
    BitCube bits = bodies.rest().segments().get(0).bits();
    assertEquals(8 * 6 * 10, bits.solidCount());
    Vec3 inside = grid.worldToGrid(new Vec3(-3.9, -2.9, 4.9), new Vec3());
    assertTrue(bits.get((int) inside.x, (int) inside.y, (int) inside.z));
    assertTrue(bodies.files().contains(folder.resolve("m.obj")), bodies.files().toString());
  }

  @Test
  void withoutAVolumeTheFirstMeshChoosesWorldAndVoxels() throws IOException {
    mesh("ras.obj", "SPACE=RAS", false);
    mesh("lps.obj", "SPACE=LPS", false);
    PlacedVolume bodies = read("mesh:ras.obj", "mesh:lps.obj");
    assertEquals(CoordinateSystem.RAS, bodies.world());
    SegmentedVolume rest = bodies.rest();
    assertEquals(5.0 / 256, rest.grid(0).spacingMm().x);
    assertEquals(5.0 / 256, rest.grid(1).spacingMm().x);
    assertSame(rest.grid(), rest.grid(0));
    assertEquals(-4, corner(rest.grid(1)).x, 0.05);
  }

  @Test
  void openMeshesAndOtherFilesAreRefused() throws IOException {
    volume("a.nrrd", LPS, "(1,2,3)");
    mesh("open.obj", "SPACE=LPS", true);
    assertRefused("the mesh is open", "mesh:open.obj");
    assertRefused("this kind of file is no mesh", "mesh:a.nrrd");
    assertRefused("no such file", "volume:a.nrrd", "mesh:absent.stl");
    mesh("m.obj", "SPACE=LPS", false);
    volume("fine.nrrd", LPS, "(1,2,3)");
    Path fine = folder.resolve("fine.nrrd");
    String text = Files.readString(fine, StandardCharsets.ISO_8859_1).replace("0.5", "0.001");
    Files.writeString(fine, text, StandardCharsets.ISO_8859_1);
    assertRefused("too large for voxels of 0.001 mm", "volume:fine.nrrd", "mesh:m.obj");
  }

  private void assertRefused(String what, String... sources) {
    VolumeFormatException refusal = assertThrows(VolumeFormatException.class, () -> read(sources));
    assertTrue(refusal.getMessage().contains(what), refusal.getMessage());
  }
}
