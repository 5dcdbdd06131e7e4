package org.palpate.tool;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.geometry.Vec3;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.rigid.Clearance;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

class ToolMakerTest {
  @TempDir Path folder;

  @Test
  void aShapeKeepsHalfAVoxelFromTheVoxelsOfItsScene() throws Exception {
    MadeTool made = make("sphere:4", null, null, null);
    assertEquals(OptionalDouble.of(0), made.clearanceMm());
    Clearance clearance = made.clearances(scene()).get(0);
    assertEquals(0.5, clearance.growthMm(), 0.01);
    assertTrue(clearance.growthMm() <= 0.5, "so that one cell of half a voxel is enough");
    assertTrue(made.tool().count() > 300 && made.tool().count() < 1000, "" + made.tool().count());
  }

  @Test
  void aLargeShapeIsSampledMoreCoarselyAndAHugeOneIsRefused() throws Exception {
    MadeTool made = make("sphere:150", null, null, null);
    assertTrue(made.tool().count() <= 1.2 * ToolMaker.MOST_POINTS_OF_SHAPE);
    assertTrue(made.tool().coverRadiusMm() > 0.9);
    assertTrue(refusal("sphere:9999", null, null, null).contains("too large"));
  }

  @Test
  void aThinnedToolSaysThatItsWholeIsNotKeptClear() throws Exception {
    MadeTool made = make("sphere:4", null, 145, null);
    assertEquals(145, made.tool().count());
    assertFalse(made.tool().isCovered());
    assertEquals(OptionalDouble.empty(), made.clearanceMm());
    assertEquals(List.of(Clearance.POINTS), made.clearances(scene()));
    assertTrue(made.notes().get(0).contains("145 of its"), made.notes().toString());
    assertTrue(make("sphere:4", null, 90_000, null).tool().isCovered());
  }

  @Test
  void aMarginWidensOrDeepens() throws Exception {
    MadeTool wide = make("sphere:4", null, null, "1.5");
    assertEquals(2, wide.clearances(scene()).get(0).growthMm(), 0.01);
    MadeTool deep = make("sphere:4", null, null, "-1.5");
    assertEquals(OptionalDouble.of(-1.5), deep.clearanceMm());
    assertEquals(0.5, deep.clearances(scene()).get(0).growthMm(), 0.01);
    assertEquals(2.5, deep.tool().radiusMm(), 1e-6);
    assertEquals(wide.tool().rmsRadiusMm(), deep.tool().rmsRadiusMm(), 1e-12);
    assertTrue(refusal("sphere:4", null, null, "-4").contains("--clearance -4"));
    MadeTool far = make("sphere:4", null, null, "100");
    assertThrows(VolumeFormatException.class, () -> far.clearances(scene()));
  }

  private static BodyScene scene() {
    BitCube bits = new BitCube(20, 20, 20);
    bits.set(3, 3, 3);
    VoxelGrid grid = VoxelGrid.ofUnitVoxels(20, 20, 20);
    return new BodyScene(List.of(new Body("bone", bits, grid, Mobility.FIXED)));
  }

  @Test
  void aSegmentOfAVolumeIsATool() throws Exception {
    Path file = volume("left-posterior-superior");
    MadeTool made = make(file.toString(), null, null, null);
    assertEquals(7, made.tool().count());
    assertEquals(List.of(file), made.files());
    Vec3 reference = made.tool().referenceMm(new Vec3());
    assertEquals(0, reference.sub(new Vec3(11, 20, 30), reference).length(), 1e-12);
    assertEquals(1, make(file.toString(), "tool=label:2", null, null).tool().count());
    assertTrue(refusal(file.toString(), "tool=label:9", null, null).contains("no voxel"));
    assertTrue(refusal(file.toString(), null, null, "-2").contains("lies deeper"));
  }

  @Test
  void aVolumeInOtherAxesIsTurnedIntoTheWorldOfTheScene() throws Exception {
    Path file = volume("right-anterior-superior");
    Vec3 reference = make(file.toString(), null, null, null).tool().referenceMm(new Vec3());
    assertEquals(0, reference.sub(new Vec3(-11, -20, 30), reference).length(), 1e-12);
  }

  @Test
  void aClosedMeshIsVoxelizedAndAnOpenOneIsSampled() throws Exception {
    String vertices =
        "v 10 0 0\nv 16 0 0\nv 10 6 0\nv 16 6 0\nv 10 0 6\nv 16 0 6\nv 10 6 6\nv 16 6 6\n";
    String sides = "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\n";
    Path open = Files.writeString(folder.resolve("open.obj"), vertices + sides);
    Path closed = Files.writeString(folder.resolve("closed.obj"), vertices + sides + "f 2 4 8 6\n");
    MadeTool solid = make(closed.toString(), null, null, null);
    Vec3 reference = solid.tool().referenceMm(new Vec3());
    assertEquals(0, reference.sub(new Vec3(13, 3, 3), reference).length(), 1e-9);
    assertEquals(OptionalDouble.of(0), solid.clearanceMm());
    assertTrue(solid.tool().solid().contains(2.9, -2.9, 2.9));
    assertEquals(List.of(closed), solid.files());
    MadeTool sheet = make(open.toString(), null, null, null);
    assertEquals(13 - 0.6, sheet.tool().referenceMm(new Vec3()).x, 1e-9);
    assertEquals(OptionalDouble.empty(), sheet.clearanceMm());
    assertTrue(sheet.notes().get(0).contains("open"), sheet.notes().toString());
    assertEquals(OptionalDouble.of(0), make(open.toString(), null, null, "body").clearanceMm());
    assertTrue(refusal(open.toString(), null, null, "-1").contains("no inside"));
    assertTrue(make(closed.toString(), null, null, "-1").tool().radiusMm() < 4.5);
    MadeTool fine = make(closed.toString(), null, null, "-0.001");
    assertTrue(fine.tool().count() > 30 * solid.tool().count(), "8 parts an edge");
    assertTrue(refusal(closed.toString(), null, null, "-4").contains("lies deeper"));
    assertTrue(refusal(closed.toString(), "a=nonzero", null, null).contains("segments"));
    Path large =
        Files.writeString(folder.resolve("large.obj"), vertices.replace("16", "9e6") + sides);
    assertTrue(refusal(large.toString(), null, null, null).contains("scale it to mm"));
  }

  @Test
  void aMeshThatAFineMarginWouldGiveTooManyPointsIsRefused() throws Exception {
    String vertices = "v 0 0 0\nv 80 0 0\nv 0 80 0\nv 0 0 80\n";
    Path file = folder.resolve("corner.obj");
    Files.writeString(file, vertices + "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    assertTrue(make(file.toString(), null, null, null).tool().count() < ToolMaker.MOST_POINTS);
    assertTrue(refusal(file.toString(), null, null, "-0.05").contains("points, more than"));
  }

  @Test
  void aFileThatIsMissingOrNoVolumeIsRefusedInOneLine() throws Exception {
    assertTrue(refusal("none.nrrd", null, null, null).contains("no such file"));
    Path text = Files.writeString(folder.resolve("a.txt"), "hello");
    assertTrue(refusal(text.toString(), null, null, null).contains("a.txt"));
  }

  /** Writes a row of seven voxels of label 1, the first of label 2, centred at 11, 20, 30. */
  private Path volume(String space) throws Exception {
    String header =
        "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 7 1 1\nencoding: ascii\nspace: "
            + space
            + "\nspace directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: (8,20,30)\n\n";
    return Files.writeString(folder.resolve("tool.nrrd"), header + "2 1 1 1 1 1 1\n");
  }

  private static MadeTool make(String tool, String segment, Integer points, String clearance)
      throws VolumeFormatException {
    ToolRequest request = ToolRequest.parse(tool, segment, points, clearance);
    return ToolMaker.make(request, 1, CoordinateSystem.LPS);
  }

  private static String refusal(String tool, String segment, Integer points, String clearance) {
    String line =
        assertThrows(VolumeFormatException.class, () -> make(tool, segment, points, clearance))
            .getMessage();
    assertEquals(1, line.lines().count(), line);
    return line;
  }
}
