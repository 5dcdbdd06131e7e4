package org.palpate.volume.fracture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.testing.RandomGeometry;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;
import org.palpate.volume.ConnectedComponents.Neighbours;
import org.palpate.volume.VoxelGrid;

class SegmentSplitTest {
  private static final VoxelGrid GRID =
      new VoxelGrid(
          8,
          9,
          10,
          new Vec3(1, 2, 0.5),
          new RigidTransform(
              new Vec3(-1, 0, 0), new Vec3(0, -1, 0), new Vec3(0, 0, 1), new Vec3(5, 6, 7)));

  private final SplittableRandom random = new SplittableRandom(Seeds.seed());

  @Test
  void aPlaneGivesEachVoxelToTheSideOfItsCentre() {
    for (int round = 0; round < 50; round++) {
      BitCube bits = ball();
      Vec3 normal = RandomGeometry.vector(random, 1);
      Vec3 point = GRID.gridToWorld(new Vec3(4, 4.5, 5), new Vec3());
      Fragments parts = SegmentSplit.byPlane(bits, GRID, point, normal);
      int larger = 0;
      for (int n = 0; n < 720; n++) {
        int i = n % 8;
        int j = n / 8 % 9;
        int k = n / 72;
        Vec3 centre = GRID.gridToWorld(new Vec3(i + 0.5, j + 0.5, k + 0.5), new Vec3());
        double side =
            normal.x * (centre.x - point.x)
                + normal.y * (centre.y - point.y)
                + normal.z * (centre.z - point.z);
        if (bits.get(i, j, k)) {
          larger += (side > 0) == parts.bits().get(0).get(i, j, k) ? 1 : -1;
        }
        assertEquals(
            bits.get(i, j, k) ? 1 : 0,
            (parts.bits().get(0).get(i, j, k) ? 1 : 0)
                + (parts.bits().get(1).get(i, j, k) ? 1 : 0));
      }
      assertEquals(bits.solidCount(), Math.abs(larger), "one side only is the first part");
    }
  }

  @Test
  void aPlaneBesideTheSegmentIsRefused() {
    assertThrows(
        IllegalArgumentException.class,
        () -> SegmentSplit.byPlane(ball(), GRID, new Vec3(500, 0, 0), new Vec3(1, 0, 0)));
  }

  @Test
  void smallComponentsAreLeftOutAndCounted() {
    BitCube bits = ball();
    long whole = bits.solidCount();
    bits.set(0, 0, 0);
    bits.set(7, 8, 9);
    bits.set(7, 8, 8);
    Fragments parts = SegmentSplit.byComponents(bits, GRID, Neighbours.FACES_EDGES_CORNERS, 2);
    assertEquals(2, parts.bits().size());
    assertEquals(whole, parts.bits().get(0).solidCount());
    assertEquals(1, parts.lostVoxels());
    assertThrows(
        IllegalArgumentException.class,
        () -> SegmentSplit.byComponents(bits, GRID, Neighbours.FACES, 1000));
  }

  private static BitCube ball() {
    BitCube bits = new BitCube(8, 9, 10);
    for (int n = 0; n < 720; n++) {
      int j = n / 8 % 9;
      int k = n / 72;
      double x = n % 8 + 0.5 - 4;
      double y = j + 0.5 - 4.5;
      double z = k + 0.5 - 5;
      if (x * x + y * y + z * z < 9) {
        bits.set(n % 8, j, k);
      }
    }
    return bits;
  }
}
