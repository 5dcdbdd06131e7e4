package org.palpate.benchmarks.stress;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;

/** Checks the judge of what a cut must spare, apart from the code of sessions that spares it. */
class ProtectedVoxelsTest {
  private static final long SEED = Long.getLong("palpate.seed", 20_261_129);

  private static ProtectedVoxels single(double marginMm) {
    BitCube nerve = new BitCube(8, 9, 10);
    nerve.set(3, 4, 5);
    return new ProtectedVoxels(
        nerve, List.of(new int[] {3, 4, 5}), new Vec3(1, 0.5, 2), marginMm, nerve);
  }

  @Test
  void aPointIsNearIfItsDistanceFromTheVoxelIsLessThanTheMargin() {
    ProtectedVoxels guarded = single(1.5);
    assertTrue(guarded.isNear(3.5, 4.5, 5.5), "inside");
    assertTrue(guarded.isNear(1.5 + 1e-9, 4.5, 5.5));
    assertFalse(guarded.isNear(1.5, 4.5, 5.5), "as far as the margin along x");
    assertTrue(guarded.isNear(5.5 - 1e-9, 4.5, 5.5));
    assertFalse(guarded.isNear(5.5, 4.5, 5.5));
    assertTrue(guarded.isNear(3.5, 8 - 1e-9, 5.5));
    assertFalse(guarded.isNear(3.5, 8, 5.5), "edges of half a millimetre along y");
    assertTrue(guarded.isNear(3.5, 4.5, 6.75 - 1e-9));
    assertFalse(guarded.isNear(3.5, 4.5, 6.75), "edges of two millimetres along z");
    assertTrue(guarded.isNear(4 + 1.2 - 1e-9, 5 + 1.8, 5.5), "a hypotenuse of 1.2 and 0.9 mm");
    assertFalse(guarded.isNear(4 + 1.2 + 1e-9, 5 + 1.8, 5.5));
  }

  @Test
  void withoutAMarginOnlyTheSegmentItselfStays() {
    ProtectedVoxels guarded = single(0);
    assertFalse(guarded.isNear(3.5, 4.5, 5.5), "no point is nearer than 0");
    assertEquals(1, guarded.near().solidCount());
    assertTrue(guarded.near().get(3, 4, 5));
  }

  @Test
  void aVoxelStaysIfItsNearestPointIsNearerThanTheMargin() {
    BitCube near = single(1.5).near();
    assertTrue(near.get(2, 4, 5) && near.get(4, 4, 5), "it touches the segment");
    assertTrue(near.get(1, 4, 5) && near.get(5, 4, 5), "a gap of 1 mm");
    assertFalse(near.get(0, 4, 5) || near.get(6, 4, 5), "a gap of 2 mm");
    assertTrue(near.get(3, 1, 5) && near.get(3, 7, 5), "a gap of 1 mm");
    assertFalse(near.get(3, 0, 5) || near.get(3, 8, 5), "a gap of the margin itself");
    assertFalse(near.get(3, 4, 3) || near.get(3, 4, 7), "a gap of 2 mm");
  }

  /** Decides in rationals what the judge decides in doubles, away from the margin itself. */
  @Test
  void randomScenesAgreeWithRationalsAndWithWhatASessionSpares() {
    SplittableRandom random = new SplittableRandom(SEED);
    int kept = 0;
    int withoutMargin = 0;
    for (int scene = 0; scene < 30; scene++) {
      ProtectedVoxels guarded = ProtectedVoxels.next(random, HostileScene.next(random));
      BitCube near = guarded.near();
      withoutMargin += guarded.marginMm() == 0 ? 1 : 0;
      for (int k = 0; k < near.sizeZ(); k++) {
        for (int j = 0; j < near.sizeY(); j++) {
          for (int i = 0; i < near.sizeX(); i++) {
            boolean stays = guarded.nerve().get(i, j, k) || isNearer(guarded, i, j, k);
            String what = "seed=" + SEED + " scene=" + scene + " " + i + "," + j + "," + k;
            assertEquals(stays, near.get(i, j, k), what);
            assertEquals(stays, guarded.kept().get(i, j, k), what);
            kept += stays ? 1 : 0;
          }
        }
      }
    }
    assertTrue(kept > 500 && withoutMargin > 3, kept + " kept, " + withoutMargin);
  }

  private static boolean isNearer(ProtectedVoxels guarded, int i, int j, int k) {
    BigDecimal margin = new BigDecimal(guarded.marginMm());
    for (int[] voxel : guarded.voxels()) {
      BigDecimal square =
          square(guarded.spacingMm().x, i - voxel[0])
              .add(square(guarded.spacingMm().y, j - voxel[1]))
              .add(square(guarded.spacingMm().z, k - voxel[2]));
      if (square.compareTo(margin.multiply(margin)) < 0) {
        return true;
      }
    }
    return false;
  }

  private static BigDecimal square(double edgeMm, int apart) {
    BigDecimal gap =
        new BigDecimal(edgeMm).multiply(BigDecimal.valueOf(Math.max(0, Math.abs(apart) - 1)));
    return gap.multiply(gap);
  }
}
