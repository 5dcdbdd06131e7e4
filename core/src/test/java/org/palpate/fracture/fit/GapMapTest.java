package org.palpate.fracture.fit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.Pose;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/** Measures the gap between two blocks, one of which moves away. */
class GapMapTest {
  private static final VoxelGrid GRID = VoxelGrid.ofUnitVoxels(32, 32, 40);
  private final GapMap map = new GapMap(List.of(GRID, GRID), List.of(block(4, 20), block(20, 36)));

  private static BitCube block(int low, int high) {
    BitCube bits = new BitCube(32, 32, 40);
    for (int k = low; k < high; k++) {
      for (int j = 4; j < 28; j++) {
        for (int i = 4; i < 28; i++) {
          bits.set(i, j, k);
        }
      }
    }
    return bits;
  }

  private List<GapMap.Gap> gaps(double z, boolean together) {
    Pose moved = new Pose();
    moved.translation.z = z;
    return map.measure(1, other -> together, List.of(new Pose(), moved));
  }

  @Test
  void theGapIsTheDistanceFromFaceToFace() {
    for (double z : new double[] {0, 0.7, 2, 3.5}) {
      int middle = 0;
      for (GapMap.Gap gap : gaps(z, false)) {
        Vec3 at = gap.restMm();
        assertEquals(20, at.z, 1.5, "on the face: " + at);
        if (Math.abs(at.x - 16) < 8 && Math.abs(at.y - 16) < 8) {
          assertEquals(z, gap.gapMm(), 0.02, "at " + at);
          middle++;
        }
      }
      assertEquals(16 * 16, middle, "a point for each voxel of the middle");
    }
  }

  @Test
  void theGapOfABlockOnAFinerGridIsTheSame() {
    RigidTransform corner =
        new RigidTransform(
            new Vec3(1, 0, 0), new Vec3(0, 1, 0), new Vec3(0, 0, 1), new Vec3(4, 4, 20));
    VoxelGrid fine = new VoxelGrid(48, 48, 40, new Vec3(0.5, 0.5, 0.4), corner);
    BitCube above = new BitCube(48, 48, 40);
    for (int k = 0; k < 40; k++) {
      for (int j = 0; j < 48; j++) {
        for (int i = 0; i < 48; i++) {
          above.set(i, j, k);
        }
      }
    }
    GapMap mixed = new GapMap(List.of(GRID, fine), List.of(block(4, 20), above));
    for (double z : new double[] {0, 0.7, 2, 3.5}) {
      Pose moved = new Pose();
      moved.translation.z = z;
      int middle = 0;
      for (GapMap.Gap gap : mixed.measure(1, other -> false, List.of(new Pose(), moved))) {
        Vec3 at = gap.restMm();
        if (Math.abs(at.x - 16) < 8 && Math.abs(at.y - 16) < 8) {
          assertEquals(z, gap.gapMm(), 0.02, "at " + at);
          middle++;
        }
      }
      assertEquals(32 * 32, middle, "a point for each voxel of the middle");
    }
  }

  @Test
  void blocksThatMoveTogetherOrAreFarApartFaceNothing() {
    assertTrue(gaps(0, true).isEmpty());
    assertTrue(gaps(6, false).isEmpty());
  }
}
