package org.palpate.fracture.fit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;
import org.palpate.volume.fracture.PosedBits;

/** Reads pieces of a round bar along x against the whole bar. */
class GhostDistanceTest {
  private static final int LENGTH = 64;
  private static final int WIDTH = 32;
  private static final double RADIUS = 9;
  private static final VoxelGrid GRID = VoxelGrid.ofUnitVoxels(LENGTH, WIDTH, WIDTH);

  private final PosedBits ghost = new PosedBits(bar(4, 60, RADIUS), GRID, new Pose());

  private static BitCube bar(int from, int to, double radius) {
    BitCube bits = new BitCube(LENGTH, WIDTH, WIDTH);
    for (int k = 0; k < WIDTH; k++) {
      for (int j = 0; j < WIDTH; j++) {
        for (int i = from; i < to; i++) {
          if (Math.hypot(j + 0.5 - WIDTH / 2.0, k + 0.5 - WIDTH / 2.0) <= radius) {
            bits.set(i, j, k);
          }
        }
      }
    }
    return bits;
  }

  private static GhostDistance read(PosedBits ghost, double radius, double x, double z) {
    Pose pose = new Pose();
    pose.translation.set(x, 0, z);
    return GhostDistance.read(new PosedBits(bar(20, 44, radius), GRID, pose), ghost);
  }

  @Test
  void aPieceInItsPlaceIsAtNoDistanceAndItsCutFacesDoNotCount() {
    GhostDistance read = read(ghost, RADIUS, 0, 0);
    assertTrue(read.isNear());
    assertEquals(0, read.meanMm(), 0.05);
    assertEquals(0, read.mostlyMm(), 0.05);
    double side = 2 * Math.PI * RADIUS * 24;
    double ends = 2 * Math.PI * RADIUS * RADIUS;
    assertEquals(side / (side + ends), read.share(), 0.06);
  }

  @Test
  void aPieceThatIsTooThickOrTooThinIsReadByTheDifference() {
    for (double more : new double[] {-3, -2, -1, 1, 2, 3}) {
      GhostDistance read = read(ghost, RADIUS + more, 0, 0);
      assertEquals(Math.abs(more), read.meanMm(), 0.15, "more=" + more);
      assertTrue(read.largestMm() >= read.mostlyMm(), "more=" + more);
      assertEquals(Math.abs(more), read.mostlyMm(), 0.6, "more=" + more);
    }
  }

  @Test
  void aPieceThatIsDisplacedAcrossIsReadByItsMeanAndLargestDistance() {
    GhostDistance read = read(ghost, RADIUS, 0, 1.5);
    assertEquals(1.5 * 2 / Math.PI, read.meanMm(), 0.1, "mean of 1.5 |sin|");
    assertEquals(1.5, read.largestMm(), 0.35);
    assertEquals(0, read(ghost, RADIUS, 9.5, 0).meanMm(), 0.08, "along itself");
  }

  @Test
  void aTurnedGhostIsReadAsAnUprightOne() {
    Pose turned = new Pose();
    turned.rotation.setRotationVector(new Vec3(Math.toRadians(30), 0, 0));
    Vec3 middle = new Vec3(0, WIDTH / 2.0, WIDTH / 2.0);
    middle.sub(turned.rotation.rotate(middle, new Vec3()), turned.translation);
    GhostDistance read = read(new PosedBits(ghost.bits(), GRID, turned), RADIUS, 0, 0);
    assertEquals(0, read.meanMm(), 0.15);
  }

  @Test
  void aPieceFarAwayIsNotRead() {
    GhostDistance read = read(ghost, RADIUS, 0, 60);
    assertFalse(read.isNear());
    assertEquals(0, read.share());
    assertTrue(Double.isNaN(read.meanMm()) && Double.isNaN(read.largestMm()));
  }
}
