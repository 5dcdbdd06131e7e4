package org.palpate.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.testing.Seeds;
import org.palpate.volume.ScalarVolume;
import org.palpate.volume.ScalarVolume.Storage;
import org.palpate.volume.VoxelGrid;

class GreySlicesTest {
  private static final long SEED = Seeds.seed();

  private static ScalarVolume volume(int x, int y, int z, float... values) {
    Object[] slices = new Object[z];
    for (int k = 0; k < z; k++) {
      slices[k] = Arrays.copyOfRange(values, k * x * y, (k + 1) * x * y);
    }
    return ScalarVolume.over(VoxelGrid.ofUnitVoxels(x, y, z), slices);
  }

  @Test
  void theDarkestAndBrightestHundredthsAreBlackAndWhite() {
    SplittableRandom random = new SplittableRandom(SEED);
    float[] values = new float[20 * 10 * 6];
    for (int n = 0; n < values.length; n++) {
      values[n] = (float) random.nextDouble(-500, 500);
    }
    GreySlices grey = new GreySlices(volume(20, 10, 6, values));
    float[] sorted = values.clone();
    Arrays.sort(sorted);
    assertEquals(sorted[12], grey.black(), "seed=" + SEED);
    assertEquals(sorted[sorted.length - 13], grey.white(), "seed=" + SEED);
  }

  @Test
  void valuesThatAreNotFiniteHaveNoSay() {
    float[] values = new float[200];
    Arrays.fill(values, Float.NaN);
    values[3] = 4;
    values[9] = 6;
    values[10] = Float.POSITIVE_INFINITY;
    GreySlices grey = new GreySlices(volume(10, 10, 2, values));
    assertEquals(4, grey.black());
    assertEquals(6, grey.white());
  }

  @Test
  void aVolumeOfOneValueStillHasAContrast() {
    float[] same = new float[8];
    Arrays.fill(same, 7);
    GreySlices grey = new GreySlices(volume(2, 2, 2, same));
    assertEquals(7, grey.black());
    assertEquals(8, grey.white());
    Arrays.fill(same, Float.NaN);
    assertEquals(1, new GreySlices(volume(2, 2, 2, same)).white());
  }

  @Test
  void everyLongAxisIsSampledThroughout() {
    for (int size : new int[] {48, 95, 96, 97, 300}) {
      float[] values = new float[size];
      values[size - 1 - (size - 1) % Math.max(1, size / 48)] = 1000; // the last that is sampled
      GreySlices grey = new GreySlices(volume(size, 1, 1, values));
      assertEquals(0, grey.black());
      assertTrue(grey.white() == 1000 || grey.white() == 1, size + ": " + grey.white());
      assertEquals(size, grey.size(0));
      assertEquals(1, grey.size(2));
    }
  }

  @Test
  void planesStandInTheSceneAsTheVolumeDoes() {
    RigidTransform pose = RigidTransform.identity();
    pose.origin().set(1, 2, 3);
    VoxelGrid grid = new VoxelGrid(4, 5, 6, new Vec3(1, 2, 3), pose);
    GreySlices grey = new GreySlices(ScalarVolume.of(grid, Storage.UINT8));
    SceneModel model = new SceneModel(WorldAxes.RAS, Theme.DARK);
    SlicePlanes planes = grey.through(1, -1, 3, model);
    assertEquals(1, planes.plane(0));
    assertEquals(-1, planes.plane(1));
    assertEquals(3, planes.plane(2));
    assertEquals("(-1.0, -2.0, 3.0)", planes.pose().origin().toString());
    assertEquals("(1.0, 2.0, 3.0)", planes.spacingMm().toString());
    GreySlices other = grey.withContrast(-5, 5);
    assertEquals(-5, other.black());
    assertEquals(5, other.white());
    assertEquals(0, grey.black(), "the first stays as it is");
  }
}
