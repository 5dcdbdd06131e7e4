package org.palpate.io.nifti;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.io.volume.AxisSigns;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.io.volume.LabelTable;
import org.palpate.io.volume.ReadOptions;
import org.palpate.io.volume.VolumeHeader;
import org.palpate.io.volume.VolumeHeader.ValueRange;
import org.palpate.io.volume.VoxelType;
import org.palpate.testing.RandomGeometry;
import org.palpate.testing.Seeds;
import org.palpate.volume.VoxelGrid;

class NiftiHeaderWriterTest {
  private static final long SEED = Seeds.seed();

  @TempDir private Path folder;

  private static VolumeHeader header(
      VoxelGrid grid, VoxelType type, CoordinateSystem world, Optional<LabelTable> labels) {
    return new VolumeHeader("test", grid, type, ValueRange.of(type), world, labels, List.of());
  }

  private VolumeHeader readBack(VolumeHeader written) throws IOException {
    byte[] bytes = NiftiHeaderWriter.of(written, written.type());
    VoxelGrid grid = written.grid();
    int data = (int) (grid.voxelCount() * written.type().bytes());
    Path file = Files.write(folder.resolve("v.nii"), Arrays.copyOf(bytes, bytes.length + data));
    return NiftiReader.open(file, ReadOptions.defaults()).header();
  }

  @ParameterizedTest
  @EnumSource(VoxelType.class)
  void everyTypeIsReadBack(VoxelType type) throws IOException {
    VolumeHeader read =
        readBack(
            header(VoxelGrid.ofUnitVoxels(3, 4, 5), type, CoordinateSystem.RAS, Optional.empty()));
    assertEquals(type, read.type());
    assertEquals(5, read.grid().sizeZ());
    assertEquals("NIfTI-1", read.format());
    assertEquals(Optional.empty(), read.labels());
  }

  @ParameterizedTest
  @EnumSource(CoordinateSystem.class)
  void voxelsKeepTheirPlaceInThePatient(CoordinateSystem world) throws IOException {
    SplittableRandom random = new SplittableRandom(SEED);
    for (int round = 0; round < 20; round++) {
      RigidTransform pose = RandomGeometry.pose(random, 100).transform(RigidTransform.identity());
      VoxelGrid grid = new VoxelGrid(7, 8, 9, new Vec3(0.5, 1, 2), pose);
      VolumeHeader read = readBack(header(grid, VoxelType.INT16, world, Optional.empty()));
      assertEquals(CoordinateSystem.RAS, read.coordinateSystem(), "the format names its axes");
      Vec3 signs =
          AxisSigns.between(
                  world == CoordinateSystem.UNKNOWN ? CoordinateSystem.RAS : world,
                  CoordinateSystem.RAS)
              .orElseThrow();
      Vec3 at = new Vec3(6.5, 7.5, 8.5);
      Vec3 expected = grid.gridToWorld(at, new Vec3());
      Vec3 found = read.grid().gridToWorld(at, new Vec3());
      assertEquals(signs.x * expected.x, found.x, 1e-3, "seed=" + SEED);
      assertEquals(signs.y * expected.y, found.y, 1e-3, "seed=" + SEED);
      assertEquals(expected.z, found.z, 1e-3, "seed=" + SEED);
    }
  }

  @Test
  void labelsStayLabels() throws IOException {
    VolumeHeader labels =
        header(
            VoxelGrid.ofUnitVoxels(3, 4, 5),
            VoxelType.UINT8,
            CoordinateSystem.RAS,
            Optional.of(LabelTable.EMPTY));
    assertEquals(Optional.of(LabelTable.EMPTY), readBack(labels).labels());
  }

  @Test
  void aLongAxisNeedsTheSecondVersion() throws IOException {
    VolumeHeader wide =
        header(
            VoxelGrid.ofUnitVoxels(32_768, 1, 1),
            VoxelType.UINT8,
            CoordinateSystem.LPS,
            Optional.of(LabelTable.EMPTY));
    assertEquals(
        "NIfTI-2, because a size is above 32,767; some programs read NIfTI-1 alone",
        NiftiHeaderWriter.formatName(wide));
    VolumeHeader read = readBack(wide);
    assertEquals("NIfTI-2", read.format());
    assertEquals(32_768, read.grid().sizeX());
    assertEquals(Optional.of(LabelTable.EMPTY), read.labels());
    VolumeHeader fits =
        header(
            VoxelGrid.ofUnitVoxels(32_767, 1, 1),
            VoxelType.UINT8,
            CoordinateSystem.LPS,
            Optional.empty());
    assertEquals("NIfTI-1", NiftiHeaderWriter.formatName(fits));
  }

  @Test
  void positionsThatSinglePrecisionWouldMoveNeedTheSecondVersion() throws IOException {
    RigidTransform far = RigidTransform.identity();
    far.origin().set(1e6, 0, 0.1);
    VoxelGrid fine = new VoxelGrid(100, 100, 100, new Vec3(0.01, 0.01, 0.01), far);
    VolumeHeader header = header(fine, VoxelType.UINT8, CoordinateSystem.RAS, Optional.empty());
    assertEquals(
        "NIfTI-2, because single precision moves voxels; some programs read NIfTI-1 alone",
        NiftiHeaderWriter.formatName(header));
    VolumeHeader read = readBack(header);
    Vec3 at = new Vec3(99.5, 99.5, 99.5);
    Vec3 moved =
        read.grid().gridToWorld(at, new Vec3()).sub(fine.gridToWorld(at, new Vec3()), new Vec3());
    assertTrue(moved.length() < 1e-9, moved.toString());
  }
}
