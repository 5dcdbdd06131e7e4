package org.palpate.fracture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.Pose;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;
import org.palpate.volume.ScalarVolume;
import org.palpate.volume.ScalarVolume.Storage;
import org.palpate.volume.VoxelGrid;
import org.palpate.volume.fracture.PosedBits;

class PartialVoxelsTest {
  private static final int EDGE = 24;
  private static final VoxelGrid GRID = VoxelGrid.ofUnitVoxels(EDGE, EDGE, EDGE);
  private static final double SIGMA = 0.6;
  private static final double AIR = -1000;
  private static final double BONE = 1000;
  private static final double THRESHOLD = 0;
  private static final double CONTRAST = 1000;

  /** Returns grey values of bone from 4 up to a height, with partly full voxels at the top. */
  private static ScalarVolume slab(double top) {
    ScalarVolume values = ScalarVolume.of(GRID, Storage.FLOAT32);
    for (int k = 0; k < EDGE; k++) {
      double filled = k < 4 ? 0 : Math.max(0, Math.min(1, top - k));
      for (int j = 0; j < EDGE; j++) {
        for (int i = 0; i < EDGE; i++) {
          values.set(i, j, k, AIR + filled * (BONE - AIR));
        }
      }
    }
    return values;
  }

  private static BitCube above(ScalarVolume values, int lowX, int highX) {
    BitCube bits = new BitCube(EDGE, EDGE, EDGE);
    for (int k = 0; k < EDGE; k++) {
      for (int j = 0; j < EDGE; j++) {
        for (int i = lowX; i < highX; i++) {
          if (values.value(i, j, k) >= THRESHOLD) {
            bits.set(i, j, k);
          }
        }
      }
    }
    return bits;
  }

  private static Optional<PartialVoxels> partial(BitCube bits, ScalarVolume values) {
    return PartialVoxels.of(bits, GRID, values, GRID, THRESHOLD, CONTRAST);
  }

  private static double surfaceZ(BitCube bits, Optional<PartialVoxels> partial, double x) {
    SmoothedBits smoothed = new SmoothedBits(new PosedBits(bits, GRID, new Pose()), partial, SIGMA);
    Vec3 at = new Vec3();
    assertTrue(smoothed.surface(new Vec3(x, 12.3, 12), new Vec3(0, 0, 1), 4, at));
    return at.z;
  }

  private static double excess(PartialVoxels partial, int i, int j, int k) {
    float[] brick = partial.excess(i >> 2, j >> 2, k >> 2);
    return brick == null ? 0 : brick[(k & 3) << 4 | (j & 3) << 2 | (i & 3)];
  }

  @Test
  void theSurfaceLiesWhereTheGreyValuesFillItsVoxels() {
    for (double top = 11.5; top <= 13.5; top += 0.1) {
      ScalarVolume values = slab(top);
      BitCube bits = above(values, 0, EDGE);
      assertEquals(top, surfaceZ(bits, partial(bits, values), 12.4), 0.06);
      assertEquals(Math.floor(top + 0.5), surfaceZ(bits, Optional.empty(), 12.4), 0.01);
    }
  }

  @Test
  void aCutInsideBoneStaysWhereItsVoxelsAre() {
    ScalarVolume values = slab(12.7);
    BitCube left = above(values, 0, 12);
    PartialVoxels partial = partial(left, values).orElseThrow();
    for (int k = 5; k < 11; k++) {
      for (int j = 1; j < EDGE - 1; j++) {
        assertEquals(0, excess(partial, 11, j, k));
        assertEquals(0, excess(partial, 12, j, k));
      }
    }
    assertEquals(-0.3, excess(partial, 5, 5, 12), 1e-6);
    SmoothedBits smoothed =
        new SmoothedBits(new PosedBits(left, GRID, new Pose()), Optional.of(partial), SIGMA);
    Vec3 at = new Vec3();
    assertTrue(smoothed.surface(new Vec3(12.2, 12.3, 8), new Vec3(1, 0, 0), 3, at));
    assertEquals(12, at.x, 1e-3);
  }

  @Test
  void aVoxelBetweenTwoFragmentsStaysEmpty() {
    ScalarVolume values = slab(12);
    for (int k = 4; k < 12; k++) {
      for (int j = 0; j < EDGE; j++) {
        values.set(12, j, k, -200);
      }
    }
    BitCube left = above(values, 0, 12);
    assertEquals(0, excess(partial(left, values).orElseThrow(), 12, 8, 8));
    for (int k = 4; k < 12; k++) {
      for (int j = 0; j < EDGE; j++) {
        values.set(13, j, k, AIR);
      }
    }
    assertEquals(0.4, excess(partial(left, values).orElseThrow(), 12, 8, 8), 1e-6);
  }

  @Test
  void everyVoxelFollowsTheRuleInRandomVolumes() {
    SplittableRandom random = new SplittableRandom(7);
    for (int round = 0; round < 20; round++) {
      ScalarVolume values = ScalarVolume.of(GRID, Storage.INT16);
      BitCube bits = new BitCube(EDGE, EDGE, EDGE);
      for (int n = 0; n < EDGE * EDGE * EDGE; n++) {
        int i = n % EDGE;
        int j = n / EDGE % EDGE;
        int k = n / EDGE / EDGE;
        values.set(i, j, k, random.nextInt(-1500, 1500) - (round % 3) * 400);
        if (values.value(i, j, k) >= THRESHOLD && random.nextInt(10) < 8) {
          bits.set(i, j, k);
        }
      }
      PartialVoxels partial = partial(bits, values).orElseThrow();
      for (int n = 0; n < EDGE * EDGE * EDGE; n++) {
        int i = n % EDGE;
        int j = n / EDGE % EDGE;
        int k = n / EDGE / EDGE;
        assertEquals(expected(bits, values, i, j, k), excess(partial, i, j, k), 1e-6);
      }
    }
  }

  /** Returns what the rule says of a voxel, by looking at all its neighbours. */
  private static double expected(BitCube bits, ScalarVolume values, int i, int j, int k) {
    boolean isBone = values.value(i, j, k) >= THRESHOLD;
    boolean isOwn = bits.get(i, j, k);
    boolean sharesEdge = false;
    boolean touchesOther = false;
    for (int n = 0; n < 27; n++) {
      int x = i + n % 3 - 1;
      int y = j + n / 3 % 3 - 1;
      int z = k + n / 9 - 1;
      if (GRID.contains(x, y, z)) {
        boolean sharesFace = Math.abs(x - i) + Math.abs(y - j) + Math.abs(z - k) == 1;
        boolean isBoneThere = values.value(x, y, z) >= THRESHOLD;
        sharesEdge |= sharesFace && (isOwn ? !isBoneThere : bits.get(x, y, z));
        touchesOther |= isBoneThere && !bits.get(x, y, z);
      }
    }
    if (!sharesEdge || isBone != isOwn || (!isOwn && touchesOther)) {
      return 0;
    }
    double fullness =
        Math.max(0, Math.min(1, 0.5 + (values.value(i, j, k) - THRESHOLD) / (2 * CONTRAST)));
    return isOwn ? fullness - 1 : fullness;
  }

  @Test
  void aFragmentOnAPartOfTheGridReadsTheSameValues() {
    ScalarVolume values = slab(12.7);
    BitCube bits = above(values, 0, 12);
    VoxelGrid part = grid(EDGE - 2, 2);
    BitCube cropped = new BitCube(EDGE, EDGE, EDGE - 2);
    bits.forEachRimVoxel((i, j, k) -> cropped.set(i, j, k - 2));
    PartialVoxels found =
        PartialVoxels.of(cropped, part, values, GRID, THRESHOLD, CONTRAST).orElseThrow();
    assertEquals(-0.3, excess(found, 5, 5, 10), 1e-6);
  }

  @Test
  void greyValuesWithOtherVoxelsTellNothing() {
    ScalarVolume values = slab(12.7);
    BitCube bits = above(values, 0, 12);
    VoxelGrid shifted = grid(EDGE, 0.4);
    VoxelGrid wide =
        new VoxelGrid(EDGE, EDGE, EDGE, new Vec3(1, 1, 1.01), RigidTransform.identity());
    assertTrue(PartialVoxels.of(bits, GRID, values, shifted, THRESHOLD, CONTRAST).isEmpty());
    assertTrue(PartialVoxels.of(bits, GRID, values, wide, THRESHOLD, CONTRAST).isEmpty());
  }

  /** Returns a grid as wide as the fragments, of some layers from a height on. */
  private static VoxelGrid grid(int layers, double z) {
    RigidTransform toWorld =
        new RigidTransform(
            new Vec3(1, 0, 0), new Vec3(0, 1, 0), new Vec3(0, 0, 1), new Vec3(0, 0, z));
    return new VoxelGrid(EDGE, EDGE, layers, new Vec3(1, 1, 1), toWorld);
  }

  @Test
  void anEditedVoxelCountsAsItsBitSays() {
    ScalarVolume values = slab(12.7);
    BitCube bits = above(values, 0, EDGE);
    Optional<PartialVoxels> partial = partial(bits, values);
    for (int j = 0; j < EDGE; j++) {
      for (int i = 0; i < EDGE; i++) {
        bits.clear(i, j, 12);
      }
    }
    assertEquals(12, surfaceZ(bits, partial, 12.4), 0.01);
  }
}
