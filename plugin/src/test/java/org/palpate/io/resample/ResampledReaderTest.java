package org.palpate.io.resample;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.io.GreyVolumes;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.io.volume.SliceSink;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeHeader;
import org.palpate.io.volume.VolumeReader;
import org.palpate.io.volume.VoxelSlice;
import org.palpate.io.volume.VoxelType;
import org.palpate.volume.ScalarVolume;
import org.palpate.volume.VoxelGrid;

class ResampledReaderTest {
  private static final VoxelGrid GRID =
      new VoxelGrid(
          9,
          7,
          5,
          new Vec3(0.5, 0.7, 2),
          new RigidTransform(
              new Vec3(0, 1, 0), new Vec3(-1, 0, 0), new Vec3(0, 0, 1), new Vec3(10, -20, 30)));

  /** A volume of random values. */
  private record Random(VoxelType type) implements VolumeReader {
    @Override
    public VolumeHeader header() {
      return new VolumeHeader(
          "random",
          GRID,
          type,
          VolumeHeader.ValueRange.of(type),
          CoordinateSystem.LPS,
          Optional.empty(),
          List.of());
    }

    @Override
    public void read(SliceSink sink) throws VolumeFormatException {
      SplittableRandom random = new SplittableRandom(4);
      VoxelSlice slice = new VoxelSlice(9, 7, type.fitsInt());
      for (int k = 0; k < 5; k++) {
        for (int n = 0; n < 63; n++) {
          if (type.fitsInt()) {
            slice.integers()[n] = random.nextInt(200);
          } else {
            slice.doubles()[n] = random.nextInt(-1000, 3000) / 8.0;
          }
        }
        sink.accept(k, slice);
      }
    }

    @Override
    public String sourceName() {
      return "random";
    }

    @Override
    public List<Path> files() {
      return List.of();
    }
  }

  private static ScalarVolume read(VoxelType type, Resampling resampling, boolean isLabels)
      throws VolumeFormatException {
    return GreyVolumes.read(new ResampledReader(new Random(type), resampling, isLabels));
  }

  @Test
  void aCropHasTheVoxelsOfTheBoxAtTheirWorldPositions() throws VolumeFormatException {
    Resampling crop = Resampling.crop(GRID, "2..5,0..6,1..3");
    ScalarVolume whole = GreyVolumes.read(new Random(VoxelType.FLOAT32));
    ScalarVolume box = read(VoxelType.FLOAT32, crop, false);
    assertEquals(4 * 7 * 3, box.grid().voxelCount());
    for (int k = 0; k < 3; k++) {
      for (int j = 0; j < 7; j++) {
        for (int i = 0; i < 4; i++) {
          assertEquals(whole.value(i + 2, j, k + 1), box.value(i, j, k));
        }
      }
    }
    assertNear(
        GRID.gridToWorld(new Vec3(2, 0, 1), new Vec3()),
        crop.grid().gridToWorld(new Vec3(), new Vec3()));
  }

  @ParameterizedTest
  @ValueSource(strings = {"0.4", "0.5,0.7,2", "1,0.3,0.9", "x2", "x0.4", "x1.3"})
  void labelsAreThoseOfTheVoxelUnderTheCentre(String spacing) throws VolumeFormatException {
    Resampling to = Resampling.spacing(GRID, spacing);
    ScalarVolume whole = GreyVolumes.read(new Random(VoxelType.UINT8));
    ScalarVolume found = read(VoxelType.UINT8, to, true);
    forEach(
        found,
        (v, at) -> {
          boolean isInside = whole.grid().contains((int) at.x, (int) at.y, (int) at.z);
          assertEquals(
              isInside ? whole.value((int) at.x, (int) at.y, (int) at.z) : 0,
              found.value((int) v.x, (int) v.y, (int) v.z));
        });
  }

  @ParameterizedTest
  @ValueSource(strings = {"0.4", "0.5,0.7,2", "1,0.3,0.9", "x2", "x0.5"})
  void greyValuesAreInterpolatedAxisByAxis(String spacing) throws VolumeFormatException {
    Resampling to = Resampling.spacing(GRID, spacing);
    ScalarVolume whole = GreyVolumes.read(new Random(VoxelType.FLOAT32));
    ScalarVolume found = read(VoxelType.FLOAT32, to, false);
    forEach(
        found,
        (v, at) ->
            assertEquals(
                alongX(whole, at),
                found.value((int) v.x, (int) v.y, (int) v.z),
                1e-3,
                v.toString()));
  }

  private static double alongX(ScalarVolume v, Vec3 at) {
    double x = Math.max(0, Math.min(8, at.x - 0.5));
    int low = (int) Math.min(7, Math.floor(x));
    return (low + 1 - x) * alongY(v, low, at) + (x - low) * alongY(v, low + 1, at);
  }

  private static double alongY(ScalarVolume v, int i, Vec3 at) {
    double y = Math.max(0, Math.min(6, at.y - 0.5));
    int low = (int) Math.min(5, Math.floor(y));
    return (low + 1 - y) * alongZ(v, i, low, at) + (y - low) * alongZ(v, i, low + 1, at);
  }

  private static double alongZ(ScalarVolume v, int i, int j, Vec3 at) {
    double z = Math.max(0, Math.min(4, at.z - 0.5));
    int low = (int) Math.min(3, Math.floor(z));
    return (low + 1 - z) * v.value(i, j, low) + (z - low) * v.value(i, j, low + 1);
  }

  private interface Visitor {
    void accept(Vec3 voxel, Vec3 inSource);
  }

  /** Visits each voxel with the position of its centre in the source, by way of the world. */
  private static void forEach(ScalarVolume volume, Visitor visitor) {
    VoxelGrid grid = volume.grid();
    for (int n = 0; n < grid.voxelCount(); n++) {
      int i = n % grid.sizeX();
      int j = n / grid.sizeX() % grid.sizeY();
      int k = n / grid.sizeX() / grid.sizeY();
      Vec3 world = grid.gridToWorld(new Vec3(i + 0.5, j + 0.5, k + 0.5), new Vec3());
      visitor.accept(new Vec3(i, j, k), GRID.worldToGrid(world, world));
    }
  }

  @Test
  void aVoxelAndItsMirrorImageHaveTheSameLabel() throws VolumeFormatException {
    Vec3 middle = GRID.gridToWorld(new Vec3(4.5, 3.5, 2.5), new Vec3());
    String plane = middle.x + "," + middle.y + "," + middle.z + ",0,3,0";
    ScalarVolume whole = GreyVolumes.read(new Random(VoxelType.UINT8));
    ScalarVolume mirrored = read(VoxelType.UINT8, Resampling.mirror(GRID, plane), true);
    for (int n = 0; n < 9 * 7 * 5; n++) {
      int i = n % 9;
      int j = n / 9 % 7;
      int k = n / 63;
      assertEquals(whole.value(8 - i, j, k), mirrored.value(i, j, k));
    }
  }

  @Test
  void aMirroredPointIsAsFarBehindAnObliquePlane() throws VolumeFormatException {
    Resampling mirror = Resampling.mirror(GRID, "9,-18,33,1,2,-2");
    Vec3 normal = new Vec3(1 / 3.0, 2 / 3.0, -2 / 3.0);
    Vec3 point = new Vec3(9, -18, 33);
    Vec3 image = mirror.toSource().transform(new Vec3(2.5, 3.5, 1.5), new Vec3());
    Vec3 a = GRID.gridToWorld(new Vec3(2.5, 3.5, 1.5), new Vec3()).sub(point, new Vec3());
    Vec3 b = GRID.gridToWorld(image, new Vec3()).sub(point, new Vec3());
    assertEquals(a.dot(normal), -b.dot(normal), 1e-12);
    assertTrue(a.sub(b, new Vec3()).cross(normal, new Vec3()).length() < 1e-12);
  }

  @Test
  void wrongTextsAreRefused() {
    for (String box :
        List.of("", "1..2,3..4", "0..9,0..6,0..4", "3..2,0..6,0..4", "a..b,0..1,0..1")) {
      assertThrows(VolumeFormatException.class, () -> Resampling.crop(GRID, box), box);
    }
    for (String spacing : List.of("0", "x0", "-1", "1,2", "x", "1e-9", "1,1,1,1", "NaN", "1e300")) {
      assertThrows(VolumeFormatException.class, () -> Resampling.spacing(GRID, spacing), spacing);
    }
    for (String plane : List.of("", "1,2,3", "1,2,3,0,0,0", "1,2,3,4,5,x", "1,2,3,4,5,6,7")) {
      assertThrows(VolumeFormatException.class, () -> Resampling.mirror(GRID, plane), plane);
    }
  }

  private static void assertNear(Vec3 expected, Vec3 found) {
    assertTrue(expected.sub(found, new Vec3()).length() < 1e-9, expected + " " + found);
  }
}
