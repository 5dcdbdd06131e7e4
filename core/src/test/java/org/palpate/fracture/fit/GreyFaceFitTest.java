package org.palpate.fracture.fit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.SplittableRandom;
import java.util.function.ToDoubleFunction;
import org.junit.jupiter.api.Test;
import org.palpate.force.guide.FitTarget;
import org.palpate.fracture.PartialVoxels;
import org.palpate.fracture.Residual;
import org.palpate.geometry.Pose;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.testing.HollowShaft;
import org.palpate.testing.RandomGeometry;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;
import org.palpate.volume.fracture.FractureSpec;
import org.palpate.volume.fracture.FragmentCutter;
import org.palpate.volume.fracture.Fragments;
import org.palpate.volume.fracture.PosedBits;
import org.palpate.volume.phantom.FracturePhantom;

/**
 * Fits the fragments of scans from a start that is off by 1 mm and 3 degrees, by their voxels and
 * by their grey values. {@code -Dpalpate.fractures=N} tries N fractures of each bone.
 */
class GreyFaceFitTest {
  private static final int FRACTURES = Integer.getInteger("palpate.fractures", 1);
  private static final double WRONG_MM = 1;
  private static final double WRONG_DEGREES = 3;

  /** Fits one after the other, as a guide makes them. */
  private static final int FITS = 2;

  private final List<Residual> fromBits = new ArrayList<>();
  private final List<Residual> fromGrey = new ArrayList<>();

  @Test
  void greyValuesHalveTheErrorOfTheFitOfAShaft() {
    VoxelGrid grid = fine(HollowShaft.GRID, 3);
    for (int seed = 1; seed <= FRACTURES; seed++) {
      fit(FragmentCutter.cut(HollowShaft.bits(3), grid, new FractureSpec(3, seed, 0)), seed);
    }
    check("shaft in 3 parts, scanned apart", 3, 0.15, 0.4);
    assertTrue(
        median(fromGrey, Residual::angleDegrees) < 0.6 * median(fromBits, Residual::angleDegrees));
  }

  @Test
  void greyValuesHalveTheErrorOfTheFitOfAnArch() {
    int edge = 2 * FracturePhantom.DEFAULT_EDGE;
    VoxelGrid grid = fine(new FracturePhantom(160, new FractureSpec(4, 1, 0)).grid(), 2);
    for (int seed = 1; seed <= FRACTURES; seed++) {
      FractureSpec fracture = new FractureSpec(4, seed, 0);
      BitCube bone = new FracturePhantom(edge, fracture).bone();
      fit(FragmentCutter.cut(bone, grid, fracture), seed);
    }
    check("arch in 4 parts, scanned apart", 4, 0.3, 0.7);
    assertTrue(
        median(fromGrey, Residual::angleDegrees) < 0.6 * median(fromBits, Residual::angleDegrees));
  }

  @Test
  void greyValuesOfTheSkinDoNotHarmTheFitOfACutThatTheyDoNotShow() {
    PosedBits bone = new PosedBits(HollowShaft.bits(3), fine(HollowShaft.GRID, 3), new Pose());
    for (int seed = 1; seed <= FRACTURES; seed++) {
      FractureSpec fracture = new FractureSpec(3, seed, 0);
      fit(ScannedFragments.ofCut(bone, HollowShaft.GRID, fracture), new SplittableRandom(seed));
    }
    check("shaft cut in 3 parts in its scan", 3, 0.05, 0.2);
  }

  /** Returns a grid of the same place with finer voxels. */
  private static VoxelGrid fine(VoxelGrid grid, int times) {
    return new VoxelGrid(
        times * grid.sizeX(),
        times * grid.sizeY(),
        times * grid.sizeZ(),
        grid.spacingMm().mul(1.0 / times, new Vec3()),
        RigidTransform.identity());
  }

  private void fit(Fragments fine, long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    fit(ScannedFragments.of(fine, random), random);
  }

  private void fit(ScannedFragments scan, SplittableRandom random) {
    List<Optional<PartialVoxels>> none = Collections.nCopies(scan.bits.size(), Optional.empty());
    FaceFit bits = new FaceFit(scan.grids, scan.bits, none, OptionalDouble.of(0));
    FaceFit grey = new FaceFit(scan.grids, scan.bits, scan.partial, OptionalDouble.of(0));
    for (int n = 0; n < scan.bits.size(); n++) {
      Pose wrong = new Pose();
      Vec3 turn = RandomGeometry.direction(random).mul(Math.toRadians(WRONG_DEGREES), new Vec3());
      wrong.rotation.setRotationVector(turn);
      Vec3 way = RandomGeometry.direction(random).mul(WRONG_MM, new Vec3());
      fromBits.add(fitted(scan, n, bits, wrong, way));
      fromGrey.add(fitted(scan, n, grey, wrong, way));
    }
  }

  /** Returns how far from its true place a fragment is after it was fitted from a wrong one. */
  private static Residual fitted(ScannedFragments scan, int n, FaceFit fit, Pose wrong, Vec3 way) {
    PosedBits atRest = new PosedBits(scan.bits.get(n), scan.grids.get(n), new Pose());
    Vec3 centroid = Residual.centroid(atRest);
    Pose truth = scan.truth.get(n);
    Pose at = new Pose();
    wrong.rotation.multiply(truth.rotation, at.rotation);
    truth.transform(centroid, at.translation).add(way, at.translation);
    List<Pose> poses = new ArrayList<>(scan.truth);
    for (int k = 0; k < FITS; k++) {
      poses.set(n, ofCentroid(at, centroid));
      FitTarget found = fit.fit(n, other -> false, poses).orElseThrow();
      at.set(found.pose());
    }
    return Residual.since(
        truth, new PosedBits(scan.bits.get(n), scan.grids.get(n), ofCentroid(at, centroid)));
  }

  /** Returns the pose from rest at which the centroid has a pose. */
  private static Pose ofCentroid(Pose at, Vec3 centroid) {
    Pose pose = new Pose();
    pose.rotation.set(at.rotation);
    at.translation.sub(at.rotation.rotate(centroid, new Vec3()), pose.translation);
    return pose;
  }

  private void check(String bone, int parts, double mostMm, double mostDegrees) {
    String text = bone + ", fit by bits: " + text(fromBits) + "; by grey values: " + text(fromGrey);
    System.out.println(text);
    assertEquals(parts * FRACTURES, fromGrey.size());
    assertTrue(median(fromGrey, Residual::distanceMm) <= mostMm, text);
    assertTrue(median(fromGrey, Residual::angleDegrees) <= mostDegrees, text);
  }

  private static String text(List<Residual> residuals) {
    return String.format(
        Locale.ROOT,
        "%d fragments, median %.3f mm %.2f deg, largest %.3f mm %.2f deg",
        residuals.size(),
        median(residuals, Residual::distanceMm),
        median(residuals, Residual::angleDegrees),
        residuals.stream().mapToDouble(Residual::distanceMm).max().orElse(0),
        residuals.stream().mapToDouble(Residual::angleDegrees).max().orElse(0));
  }

  private static double median(List<Residual> residuals, ToDoubleFunction<Residual> value) {
    double[] sorted = residuals.stream().mapToDouble(value).sorted().toArray();
    return sorted[sorted.length / 2];
  }
}
