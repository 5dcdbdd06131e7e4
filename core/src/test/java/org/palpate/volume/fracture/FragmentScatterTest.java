package org.palpate.volume.fracture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.Pose;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/** The promises of scattered fragments, each against a comparison of all voxels. */
class FragmentScatterTest {
  private static final Vec3 SPACING = new Vec3(1, 1.4, 0.8);
  private static final int SIZE = 40;

  /** A grid that is turned in the world, so that a mix-up of both shows. */
  private static final VoxelGrid GRID =
      new VoxelGrid(
          SIZE,
          SIZE,
          SIZE,
          SPACING,
          new RigidTransform(
              new Vec3(0, 1, 0), new Vec3(-1, 0, 0), new Vec3(0, 0, 1), new Vec3(7, -3, 11)));

  private static BitCube block(int x, int y, int z, int edge) {
    BitCube bits = new BitCube(SIZE, SIZE, SIZE);
    for (int n = 0; n < edge * edge * edge; n++) {
      bits.set(x + n % edge, y + n / edge % edge, z + n / (edge * edge));
    }
    return bits;
  }

  /** Returns a large block with two small ones at its sides. */
  private static Fragments fragments() {
    return new Fragments(
        GRID, List.of(block(15, 15, 15, 9), block(29, 16, 17, 6), block(17, 17, 3, 6)), 0);
  }

  private static Vec3 middleMm(BitCube bits) {
    IntBox box = bits.bounds();
    Vec3 middle =
        new Vec3(
            0.5 * (box.lowX + box.highX + 1),
            0.5 * (box.lowY + box.highY + 1),
            0.5 * (box.lowZ + box.highZ + 1));
    return GRID.gridToWorld(middle, new Vec3());
  }

  private static List<Vec3> centresMm(BitCube bits, Pose pose) {
    List<Vec3> centres = new ArrayList<>();
    for (int n = 0; n < SIZE * SIZE * SIZE; n++) {
      int i = n % SIZE;
      int j = n / SIZE % SIZE;
      int k = n / (SIZE * SIZE);
      if (bits.get(i, j, k)) {
        Vec3 p = GRID.gridToWorld(new Vec3(i + 0.5, j + 0.5, k + 0.5), new Vec3());
        centres.add(pose.transform(p, p));
      }
    }
    return centres;
  }

  private static double leastDistance(List<Vec3> some, List<Vec3> others) {
    double least = Double.POSITIVE_INFINITY;
    for (Vec3 a : some) {
      for (Vec3 b : others) {
        least = Math.min(least, a.sub(b, new Vec3()).length());
      }
    }
    return least;
  }

  /** A voxel has the diagonal 1.9 mm; two of the longest edges more are 4.7 mm. */
  @Test
  void noTwoFragmentsComeNearerThanADiagonalAndTwoEdges() {
    double leastMm = SPACING.length() + 2 * 1.4;
    double nearest = Double.POSITIVE_INFINITY;
    for (long seed = 1; seed <= 40; seed++) {
      Fragments fragments = fragments();
      List<Pose> poses = FragmentScatter.scatter(fragments, seed, false);
      for (int a = 0; a < 3; a++) {
        for (int b = 0; b < a; b++) {
          double distance =
              leastDistance(
                  centresMm(fragments.bits().get(a), poses.get(a)),
                  centresMm(fragments.bits().get(b), poses.get(b)));
          assertTrue(distance > leastMm, "seed " + seed + ": " + distance);
          nearest = Math.min(nearest, distance);
        }
      }
    }
    assertTrue(nearest < leastMm + 1.5, "some come nearly as near as that: " + nearest);
  }

  @Test
  void theLargestStaysAndTheOthersMoveOutwardsAndTurn() {
    Fragments fragments = fragments();
    IntBox all = new IntBox();
    Vec3 bone = new Vec3();
    for (BitCube bits : fragments.bits()) {
      all.include(bits.bounds());
      bone.add(middleMm(bits), bone);
    }
    bone.mul(1.0 / 3, bone);
    double diagonalMm = GRID.diagonalMm(all);
    double farthest = 0;
    for (long seed = 1; seed <= 60; seed++) {
      List<Pose> poses = FragmentScatter.scatter(fragments, seed, false);
      assertTrue(poses.get(0).sameBits(new Pose()));
      for (int n = 1; n < 3; n++) {
        Vec3 middle = middleMm(fragments.bits().get(n));
        Vec3 moved = poses.get(n).transform(middle, new Vec3()).sub(middle, new Vec3());
        double part = moved.length() / diagonalMm;
        assertTrue(part > 0.07 - 1e-9 && part < 0.18 + 1e-9, "seed " + seed + ": " + part);
        assertTrue(moved.dot(middle.sub(bone, new Vec3())) > 0, "seed " + seed + ": outwards");
        double angle = Math.toDegrees(poses.get(n).rotation.rotationVector(new Vec3()).length());
        assertTrue(angle > 10 - 1e-9 && angle < 40 + 1e-9, "seed " + seed + ": " + angle);
        farthest = Math.max(farthest, part);
      }
    }
    assertTrue(farthest > 0.15, "farthest " + farthest);
  }

  @Test
  void aSeedGivesTheSamePosesAndAnotherSeedOthers() {
    List<Pose> one = FragmentScatter.scatter(fragments(), 3, true);
    List<Pose> same = FragmentScatter.scatter(fragments(), 3, true);
    List<Pose> other = FragmentScatter.scatter(fragments(), 4, true);
    for (int n = 1; n < 3; n++) {
      assertTrue(one.get(n).sameBits(same.get(n)));
      assertTrue(!one.get(n).sameBits(other.get(n)));
    }
  }

  /** The small blocks lie near a face of this grid, so that many displacements leave it. */
  @Test
  void fragmentsStayInsideTheGridIfTheyMust() {
    Fragments atTheRim =
        new Fragments(
            GRID, List.of(block(14, 14, 14, 12), block(33, 20, 20, 5), block(20, 20, 1, 5)), 0);
    int left = 0;
    for (long seed = 1; seed <= 25; seed++) {
      List<Pose> inside = FragmentScatter.scatter(atTheRim, seed, true);
      List<Pose> anywhere = FragmentScatter.scatter(atTheRim, seed, false);
      for (int n = 1; n < 3; n++) {
        assertTrue(isInside(atTheRim.bits().get(n), inside.get(n)), "seed " + seed);
        left += isInside(atTheRim.bits().get(n), anywhere.get(n)) ? 0 : 1;
      }
    }
    assertTrue(left > 20, "without the wish they leave the grid: " + left);
  }

  /** Whether all corners of all voxels lie in the grid. */
  private static boolean isInside(BitCube bits, Pose pose) {
    for (int n = 0; n < SIZE * SIZE * SIZE; n++) {
      int i = n % SIZE;
      int j = n / SIZE % SIZE;
      int k = n / (SIZE * SIZE);
      for (int corner = 0; bits.get(i, j, k) && corner < 8; corner++) {
        Vec3 p = new Vec3(i + (corner & 1), j + (corner >> 1 & 1), k + (corner >> 2));
        GRID.gridToWorld(p, p);
        pose.transform(p, p);
        GRID.worldToGrid(p, p);
        for (int axis = 0; axis < 3; axis++) {
          if (p.get(axis) < -1e-9 || p.get(axis) > SIZE + 1e-9) {
            return false;
          }
        }
      }
    }
    return true;
  }

  @Test
  void fragmentsThatFillTheGridFindNoPlaceInsideIt() {
    Fragments full = new Fragments(GRID, List.of(block(0, 0, 0, 38), block(20, 39, 20, 1)), 0);
    IllegalArgumentException refused =
        assertThrows(IllegalArgumentException.class, () -> FragmentScatter.scatter(full, 1, true));
    assertEquals(
        "no free place for fragment 2 of 2: choose fewer fragments or another seed",
        refused.getMessage());
  }

  /** Without the bound of the grid a fragment that finds no place is moved farther and farther. */
  @Test
  void aCrowdedFragmentIsMovedFartherAway() {
    Fragments inside = new Fragments(GRID, List.of(shell(), block(18, 18, 18, 4)), 0);
    Pose pose = FragmentScatter.scatter(inside, 1, false).get(1);
    Vec3 middle = middleMm(inside.bits().get(1));
    double moved = pose.transform(middle, new Vec3()).sub(middle, new Vec3()).length();
    assertTrue(moved > 0.25 * GRID.diagonalMm(inside.bits().get(0).bounds()), "moved " + moved);
  }

  /** Returns a hollow cube whose inside leaves no room for a displaced block. */
  private static BitCube shell() {
    BitCube bits = new BitCube(SIZE, SIZE, SIZE);
    for (int n = 0; n < 24 * 24 * 24; n++) {
      int i = n % 24;
      int j = n / 24 % 24;
      int k = n / 576;
      boolean isInside = i > 7 && i < 16 && j > 7 && j < 16 && k > 7 && k < 16;
      if (!isInside) {
        bits.set(8 + i, 8 + j, 8 + k);
      }
    }
    return bits;
  }
}
