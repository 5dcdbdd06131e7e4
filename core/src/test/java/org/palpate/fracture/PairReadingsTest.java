package org.palpate.fracture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.testing.HollowShaft;
import org.palpate.testing.RandomGeometry;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;
import org.palpate.volume.fracture.FractureSpec;
import org.palpate.volume.fracture.FragmentCutter;
import org.palpate.volume.fracture.Fragments;
import org.palpate.volume.fracture.PosedBits;

/** Readings of a broken tube, whose offsets are known, and of blocks that can be counted. */
class PairReadingsTest {
  private static final double TOLERANCE_MM = 0.15;
  private static final double[] OFFSETS_MM = {0, 0.5, 1, 2};
  private static final VoxelGrid GRID = HollowShaft.GRID;

  private static final int LATTICE_STEPS = 20;

  /** No point of a voxel is farther from the lattice in it. */
  private static final double HALF_LATTICE_DIAGONAL = Math.sqrt(3) / 2 / LATTICE_STEPS;

  private final SplittableRandom random = new SplittableRandom(Seeds.seed());

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3, 4, 5, 6})
  void aFragmentThatIsPulledAwayWidensTheGap(int seed) {
    Fragments fragments =
        FragmentCutter.cut(HollowShaft.bits(), GRID, new FractureSpec(2, seed, 0));
    for (double offset : OFFSETS_MM) {
      PairReadings readings = read(fragments, 0, 0, away(fragments) * offset);
      assertEquals(offset, readings.gapMeanMm(), TOLERANCE_MM);
      assertEquals(offset, readings.gapLargestMm(), TOLERANCE_MM);
      assertEquals(0, readings.stepOffMm(), TOLERANCE_MM);
      double touching = readings.contactMm2() / readings.facingMm2();
      assertTrue(offset < 0.6 ? touching > 0.95 : touching < 0.05, offset + " mm: " + touching);
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3, 4, 5, 6})
  void aFragmentThatIsShiftedSidewaysHasThatStepOff(int seed) {
    Fragments fragments =
        FragmentCutter.cut(HollowShaft.bits(), GRID, new FractureSpec(2, seed, 0));
    for (double offset : OFFSETS_MM) {
      double apart = away(fragments) * 0.5;
      assertEquals(
          offset, read(fragments, 0.8 * offset, 0.6 * offset, apart).stepOffMm(), TOLERANCE_MM);
      assertEquals(
          offset, read(fragments, -0.6 * offset, 0.8 * offset, apart).stepOffMm(), TOLERANCE_MM);
    }
  }

  @Test
  void fragmentsThatAreFarApartDoNotFaceEachOther() {
    Fragments fragments = FragmentCutter.cut(HollowShaft.bits(), GRID, new FractureSpec(2, 1, 0));
    assertFalse(read(fragments, 0, 0, away(fragments) * 20).isFacing());
  }

  /** Returns the direction along z in which the second fragment leaves the first, 1 or -1. */
  private static double away(Fragments fragments) {
    return fragments.bits().get(0).bounds().lowZ < fragments.bits().get(1).bounds().lowZ ? 1 : -1;
  }

  private static PairReadings read(Fragments fragments, double x, double y, double z) {
    Pose pose = new Pose();
    pose.translation.set(x, y, z);
    return PairReadings.read(
        new PosedBits(fragments.bits().get(1), GRID, pose),
        new PosedBits(fragments.bits().get(0), GRID, new Pose()));
  }

  @Test
  void countsThePairsOfShiftedVoxelsThatOverlap() {
    for (int round = 0; round < 100; round++) {
      VoxelGrid grid = new VoxelGrid(4, 5, 3, new Vec3(1, 0.5, 2), GRID.gridMmToWorld());
      BitCube one = scattered();
      BitCube other = scattered();
      Pose pose = new Pose();
      pose.translation.set(
          random.nextInt(-8, 9) / 4.0, random.nextInt(-8, 9) / 4.0, random.nextInt(-8, 9) / 4.0);
      assertEquals(
          overlapsOfShifted(one, other, pose.translation),
          new VoxelOverlap(new PosedBits(one, grid, pose), new PosedBits(other, grid, new Pose()))
              .count());
    }
  }

  private static long overlapsOfShifted(BitCube one, BitCube other, Vec3 shift) {
    long pairs = 0;
    for (int[] v : voxels(one)) {
      for (int[] w : voxels(other)) {
        boolean meets =
            Math.abs(v[0] + shift.x - w[0]) < 1
                && Math.abs(0.5 * v[1] + shift.y - 0.5 * w[1]) < 0.5
                && Math.abs(2 * v[2] + shift.z - 2 * w[2]) < 2;
        pairs += meets ? 1 : 0;
      }
    }
    return pairs;
  }

  @Test
  void turnedVoxelsOverlapIfTheyShareAPointAndNotIfTheyAreApart() {
    VoxelGrid grid = VoxelGrid.ofUnitVoxels(1, 1, 1);
    BitCube voxel = new BitCube(1, 1, 1);
    voxel.set(0, 0, 0);
    int seen = 0;
    int apart = 0;
    for (int round = 0; round < 500; round++) {
      Pose pose = RandomGeometry.pose(random, 1.2);
      PosedBits turned = new PosedBits(voxel, grid, pose);
      PosedBits still = new PosedBits(voxel, grid, new Pose());
      long count = new VoxelOverlap(turned, still).count();
      assertEquals(count, new VoxelOverlap(still, turned).count());
      if (sharesAPoint(pose, 0)) {
        assertEquals(1, count, pose.toString());
        seen++;
      } else if (!sharesAPoint(pose, HALF_LATTICE_DIAGONAL)) {
        assertEquals(0, count, pose.toString());
        apart++;
      }
    }
    assertTrue(seen > 100 && apart > 100, "overlap in " + seen + " rounds, none in " + apart);
  }

  @Test
  void voxelsThatTouchDoNotOverlapButTheSmallestDepthDoes() {
    assertEquals(0, overlapsOfDot(Pose.at(1, 0, 0)));
    assertEquals(1, overlapsOfDot(Pose.at(1 - 1e-6, 0, 0)));
    double edgeBeside = 0.5 + 0.5 + Math.sqrt(0.5);
    Pose turned = new Pose();
    turned.rotation.setRotationVector(new Vec3(0, 0, Math.PI / 4));
    turned.rotation.rotate(new Vec3(-0.5, -0.5, -0.5), turned.translation);
    turned.translation.add(new Vec3(edgeBeside + 1e-6, 0.5, 0.5), turned.translation);
    assertEquals(0, overlapsOfDot(turned));
    turned.translation.x -= 1e-5;
    assertEquals(1, overlapsOfDot(turned));
  }

  /** Counts for a voxel at rest and one at a pose, whichever is the first. */
  private static long overlapsOfDot(Pose pose) {
    VoxelGrid grid = VoxelGrid.ofUnitVoxels(1, 1, 1);
    BitCube voxel = new BitCube(1, 1, 1);
    voxel.set(0, 0, 0);
    PosedBits still = new PosedBits(voxel, grid, new Pose());
    PosedBits posed = new PosedBits(voxel, grid, pose);
    long count = new VoxelOverlap(still, posed).count();
    assertEquals(count, new VoxelOverlap(posed, still).count());
    return count;
  }

  /**
   * Whether a point of a fine lattice in the turned voxel lies in the voxel at rest, or nearer to
   * it than a margin along each axis.
   */
  private static boolean sharesAPoint(Pose pose, double margin) {
    int steps = LATTICE_STEPS;
    double low = -margin;
    double high = 1 + margin;
    Vec3 p = new Vec3();
    for (int n = 0; n < steps * steps * steps; n++) {
      int j = n / steps % steps;
      int k = n / steps / steps;
      p.set(n % steps + 0.5, j + 0.5, k + 0.5);
      pose.transform(p.mul(1.0 / steps, p), p);
      if (p.x > low && p.x < high && p.y > low && p.y < high && p.z > low && p.z < high) {
        return true;
      }
    }
    return false;
  }

  @Test
  void theResidualIsThatOfTheMotionSinceRest() {
    Fragments fragments = FragmentCutter.cut(HollowShaft.bits(), GRID, new FractureSpec(2, 3, 1));
    Pose together = RandomGeometry.pose(random, 50);
    Pose moved = new Pose();
    moved.rotation.setRotationVector(new Vec3(0.02, 0, 0));
    Pose second = together.multiply(moved, new Pose());
    FractureReadings readings =
        FractureReadings.read(
            List.of(
                new PosedBits(fragments.bits().get(0), GRID, together),
                new PosedBits(fragments.bits().get(1), GRID, second)));
    assertEquals(Math.toDegrees(0.02), readings.residualDegrees(), 1e-9);
    Vec3 centroid = new Vec3();
    List<int[]> voxels = voxels(fragments.bits().get(1));
    for (int[] v : voxels) {
      centroid.add(new Vec3(v[0] + 0.5, v[1] + 0.5, v[2] + 0.5), centroid);
    }
    centroid.mul(1.0 / voxels.size(), centroid);
    Vec3 image = moved.transform(centroid, new Vec3());
    assertEquals(image.sub(centroid, image).length(), readings.residualMm(), 1e-9);
  }

  private BitCube scattered() {
    BitCube bits = new BitCube(4, 5, 3);
    for (int n = 0; n < 60; n++) {
      if (random.nextInt(3) == 0) {
        bits.set(n % 4, n / 4 % 5, n / 20);
      }
    }
    bits.set(1, 1, 1);
    return bits;
  }

  private static List<int[]> voxels(BitCube bits) {
    List<int[]> found = new ArrayList<>();
    for (int n = 0; n < bits.sizeX() * bits.sizeY() * bits.sizeZ(); n++) {
      int i = n % bits.sizeX();
      int j = n / bits.sizeX() % bits.sizeY();
      int k = n / bits.sizeX() / bits.sizeY();
      if (bits.get(i, j, k)) {
        found.add(new int[] {i, j, k});
      }
    }
    return found;
  }
}
