package org.palpate.app.command;

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
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.app.process.PalpateException;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.io.mesh.MeshFiles;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.rigid.tool.TriangleMesh;
import org.palpate.scene.surface.AmbientOcclusion;
import org.palpate.scene.surface.SurfaceBrick;
import org.palpate.scene.surface.SurfaceExtractor;
import org.palpate.scene.surface.SurfaceSource;
import org.palpate.scene.surface.WeldedSurface;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;

class SurfaceExportTest {
  private static final int SIZE = 12;

  @TempDir private Path folder;

  private final SegmentedVolume volume =
      new SegmentedVolume(
          new VoxelGrid(
              SIZE,
              SIZE,
              SIZE,
              new Vec3(1, 1, 1),
              new RigidTransform(
                  new Vec3(1, 0, 0), new Vec3(0, 1, 0), new Vec3(0, 0, 1), new Vec3(100, 20, 3))),
          List.of(box("left bone", 2, 5), box("skin", 6, 9), box("none", 9, 8)));

  private static Segment box(String name, int low, int high) {
    BitCube bits = new BitCube(SIZE, SIZE, SIZE);
    for (int i = low; i <= high; i++) {
      for (int n = 0; n < 16; n++) {
        bits.set(i, 4 + n % 4, 4 + n / 4);
      }
    }
    return new Segment(name, bits, 0x102030);
  }

  private List<WeldedSurface> surfaces() {
    List<WeldedSurface> all = new ArrayList<>();
    for (Segment segment : volume.segments()) {
      SurfaceSource source = SurfaceSource.ofBits(segment.bits(), new Vec3(1, 1, 1));
      SurfaceBrick brick = new SurfaceExtractor().extract(source, AmbientOcclusion.NONE, 0);
      all.add(WeldedSurface.of(brick == null ? List.of() : List.of(brick)));
    }
    return all;
  }

  @ParameterizedTest
  @ValueSource(strings = {"stl", "ply", "obj"})
  void allSegmentsAreReadBackFromOneFile(String ending) throws IOException {
    Path file = folder.resolve("all." + ending);
    SurfaceExport export = new SurfaceExport(file, false);
    List<String> lines = export.write(surfaces(), volume, CoordinateSystem.LPS);
    assertEquals(1, lines.size());
    TriangleMesh mesh = MeshFiles.read(file);
    int triangles = surfaces().stream().mapToInt(WeldedSurface::triangleCount).sum();
    assertEquals(triangles, mesh.triangleCount());
    assertTrue(
        lines.get(0).startsWith("written: " + file + ": ")
            && lines.get(0).endsWith(" triangles of 3 segments, in mm, SPACE=LPS"),
        lines.get(0));
    assertEquals(102, mesh.low().x, 0.5, "the box begins at voxel 2 of a volume at 100 mm");
    assertEquals(110, mesh.high().x, 0.5);
    assertEquals(24, mesh.low().y, 0.5);
    assertEquals(11, mesh.high().z, 0.5);
  }

  @Test
  void eachSegmentMayHaveAFileOfItsOwn() throws IOException {
    SurfaceExport export = new SurfaceExport(folder.resolve("b.stl"), true);
    List<Path> targets = export.targets(volume.segments());
    assertEquals(
        List.of("b-left_bone.stl", "b-skin.stl", "b-none.stl"),
        targets.stream().map(file -> file.getFileName().toString()).toList());
    List<String> lines = export.write(surfaces(), volume, CoordinateSystem.UNKNOWN);
    assertTrue(
        lines
            .get(0)
            .endsWith(" triangles of segment left bone, in mm, axes not named by the volume"),
        lines.get(0));
    assertEquals("not written: segment none has no surface", lines.get(2));
    assertTrue(Files.exists(targets.get(1)));
    assertFalse(Files.exists(targets.get(2)));
    assertFalse(Files.exists(folder.resolve("b.stl")));
  }

  @Test
  void anObjFileHasItsMaterialsBesideIt() throws IOException {
    Path file = folder.resolve("b.OBJ");
    SurfaceExport export = new SurfaceExport(file, false);
    assertEquals(List.of(file, folder.resolve("b.mtl")), export.targets(volume.segments()));
    export.write(surfaces(), volume, CoordinateSystem.RAS);
    assertTrue(Files.readString(file).contains("mtllib b.mtl"));
    assertTrue(Files.readString(folder.resolve("b.mtl")).contains("newmtl "));
  }

  @ParameterizedTest
  @CsvSource({"LPS, 25.5", "RAS, 25.5", "LAS, -25.5"})
  void aWorldThatNoFileCanNameIsTurned(CoordinateSystem world, double middleY) throws IOException {
    Path file = folder.resolve("b.stl");
    new SurfaceExport(file, false).write(surfaces(), volume, world);
    TriangleMesh mesh = MeshFiles.read(file);
    assertEquals(middleY, (mesh.low().y + mesh.high().y) / 2, 0.6);
  }

  @Test
  void aFileThatCannotBeWrittenIsAFailure() {
    Path file = folder.resolve("none").resolve("b.stl");
    PalpateException failure =
        assertThrows(
            PalpateException.class,
            () -> new SurfaceExport(file, false).write(surfaces(), volume, CoordinateSystem.LPS));
    assertEquals(
        "could not be written (NoSuchFile): " + file + ": check the disk and its permissions",
        failure.getMessage());
    assertEquals(PalpateException.FAILED, failure.exitCode());
  }

  @ParameterizedTest
  @CsvSource({"a.stl, true", "a.PLY, true", "a.Obj, true", "a.png, false", "stl, false"})
  void surfaceFilesAreKnownByTheirEndings(Path file, boolean isSurface) {
    assertEquals(isSurface, SurfaceExport.isSurfaceName(file));
  }
}
