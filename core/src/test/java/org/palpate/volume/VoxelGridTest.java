package org.palpate.volume;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;

class VoxelGridTest {
  private static final Vec3 SPACING = new Vec3(0.5, 1, 2);

  /** The x and y axes of the file point against those of the world, as in many scans. */
  private static final RigidTransform MIRRORED =
      new RigidTransform(
          new Vec3(-1, 0, 0), new Vec3(0, -1, 0), new Vec3(0, 0, 1), new Vec3(10, 20, 30));

  @Test
  void placesTheCentreOfTheFirstVoxelAsTheFileStates() {
    VoxelGrid grid = VoxelGrid.ofFirstCentre(4, 5, 6, SPACING, MIRRORED);
    Vec3 centre = grid.gridToWorld(new Vec3(0.5, 0.5, 0.5), new Vec3());
    assertTrue(centre.sameBits(new Vec3(10, 20, 30)), "" + centre);
    Vec3 next = grid.gridToWorld(new Vec3(1.5, 0.5, 1.5), new Vec3());
    assertTrue(next.sameBits(new Vec3(9.5, 20, 32)), "" + next);
  }

  @Test
  void worldToGridInvertsGridToWorld() {
    VoxelGrid grid = VoxelGrid.ofFirstCentre(4, 5, 6, SPACING, MIRRORED);
    Vec3 point = new Vec3(1.25, 3.5, -2.75);
    Vec3 back = grid.worldToGrid(grid.gridToWorld(point, new Vec3()), new Vec3());
    assertTrue(back.sameBits(point), "" + back);
  }

  @Test
  void countsAndContainsItsVoxels() {
    VoxelGrid grid = VoxelGrid.ofUnitVoxels(100_000, 100_000, 3);
    assertEquals(30_000_000_000L, grid.voxelCount());
    assertTrue(grid.contains(0, 0, 2));
    assertFalse(grid.contains(0, 0, 3));
    assertFalse(grid.contains(-1, 0, 0));
  }

  @Test
  void refusesInvalidSizesAndSpacings() {
    assertThrows(IllegalArgumentException.class, () -> VoxelGrid.ofUnitVoxels(0, 1, 1));
    for (double spacing : new double[] {0, -1, 1e-13, 1e13, Double.NaN, Double.POSITIVE_INFINITY}) {
      Vec3 bad = new Vec3(1, spacing, 1);
      assertThrows(
          IllegalArgumentException.class, () -> VoxelGrid.ofFirstCentre(2, 2, 2, bad, MIRRORED));
    }
  }
}
