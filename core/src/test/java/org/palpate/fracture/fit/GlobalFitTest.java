package org.palpate.fracture.fit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.palpate.fracture.Residual;
import org.palpate.geometry.Pose;
import org.palpate.testing.HollowShaft;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;
import org.palpate.volume.fracture.FractureSpec;
import org.palpate.volume.fracture.FragmentCutter;
import org.palpate.volume.fracture.FragmentScatter;
import org.palpate.volume.fracture.Fragments;
import org.palpate.volume.fracture.PosedBits;

/** Fits the displaced fragments of a broken shaft, whose true places are known. */
class GlobalFitTest {
  private static final long SEED = 1;
  private static final Fragments FRAGMENTS =
      FragmentCutter.cut(HollowShaft.bits(), HollowShaft.GRID, new FractureSpec(3, SEED, 0));
  private static final List<Pose> SCATTERED = FragmentScatter.scatter(FRAGMENTS, SEED, false);

  private static GlobalFit fits() {
    return new GlobalFit(Collections.nCopies(3, FRAGMENTS.grid()), FRAGMENTS.bits(), 0);
  }

  private static Residual residual(int fragment, Pose pose, Pose reference) {
    PosedBits posed = new PosedBits(FRAGMENTS.bits().get(fragment), FRAGMENTS.grid(), pose);
    return Residual.fromRest(posed, reference);
  }

  @Test
  void displacedFragmentsAreProposedWhereTheyBelong() {
    Reassembly reassembly =
        new Reassembly(
            Collections.nCopies(3, FRAGMENTS.grid()), FRAGMENTS.bits(), 0, SCATTERED, n -> n == 0);
    List<String> progress = new ArrayList<>();
    reassembly.onProgress((done, total) -> progress.add(done + " of " + total));
    assertFalse(reassembly.add().orElseThrow().isUncertain());
    assertFalse(reassembly.add().orElseThrow().isUncertain());
    assertEquals(List.of("1 of 3", "2 of 3", "3 of 3"), progress);
    assertEquals(Optional.empty(), reassembly.add());
    List<Pose> poses = reassembly.poses();
    assertTrue(poses.get(0).sameBits(SCATTERED.get(0)), "what is fixed stays");
    for (int n = 1; n < 3; n++) {
      assertTrue(residual(n, SCATTERED.get(n), SCATTERED.get(0)).distanceMm() > 5, "at first");
      Residual left = residual(n, poses.get(n), poses.get(0));
      assertEquals(0, left.distanceMm(), 0.2, "fragment " + n);
      assertEquals(0, left.angleDegrees(), 0.5, "fragment " + n);
    }
  }

  @Test
  void aProposalIsUncertainIfAnotherPlaceIsNearlyAsGoodOrLittleSpeaksForIt() {
    assertFalse(new Reassembly.Joint(1, 0, 100, 50, 10_000).isUncertain());
    assertTrue(new Reassembly.Joint(1, 0, 100, 51, 10_000).isUncertain());
    assertTrue(new Reassembly.Joint(1, 0, 100, 50, 10_100).isUncertain());
  }

  @Test
  void theSameArgumentsGiveTheSameBits() {
    GlobalFit.Proposal one = fits().propose(1, 0, SCATTERED).orElseThrow();
    GlobalFit.Proposal again = fits().propose(1, 0, SCATTERED).orElseThrow();
    assertTrue(one.pose().sameBits(again.pose()));
    assertEquals(one.scoreMm2(), again.scoreMm2());
  }

  @Test
  void nothingFitsToAFragmentThatIsTooFarAway() {
    Pose far = new Pose().set(SCATTERED.get(1));
    far.translation.x += 200;
    List<Pose> poses = List.of(SCATTERED.get(0), far, SCATTERED.get(2));
    assertEquals(Optional.empty(), fits().propose(1, 0, poses));
  }

  @Test
  void aSingleVoxelFitsNowhere() {
    BitCube voxel = new BitCube(4, 4, 4);
    voxel.set(1, 1, 1);
    List<VoxelGrid> grids = List.of(FRAGMENTS.grid(), VoxelGrid.ofUnitVoxels(4, 4, 4));
    GlobalFit fits = new GlobalFit(grids, List.of(FRAGMENTS.bits().get(0), voxel), 0);
    assertEquals(Optional.empty(), fits.propose(1, 0, List.of(new Pose(), new Pose())));
  }
}
