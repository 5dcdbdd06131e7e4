package org.palpate.fracture.fit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.palpate.force.guide.FitTarget;
import org.palpate.fracture.Residual;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;
import org.palpate.volume.fracture.PosedBits;

/** Fits blocks whose facing surfaces are simple enough to know what they determine. */
class FaceFitTest {
  private static final int EDGE = 48;
  private static final VoxelGrid GRID = VoxelGrid.ofUnitVoxels(EDGE, EDGE, EDGE);

  /** The height of the surface between two blocks. */
  private interface Relief {
    double heightAt(double x, double y);
  }

  private static final Relief FLAT = (x, y) -> 24;
  private static final Relief HILLS =
      (x, y) -> 24 + 2.5 * StrictMath.sin(x / 3.5) + 2.5 * StrictMath.sin(y / 4.5);
  private static final Relief FURROWS = (x, y) -> 24 + 2.5 * StrictMath.sin(x / 3.5);

  private static List<BitCube> blocks(Relief relief) {
    BitCube below = new BitCube(EDGE, EDGE, EDGE);
    BitCube above = new BitCube(EDGE, EDGE, EDGE);
    for (int k = 8; k < 40; k++) {
      for (int j = 8; j < 40; j++) {
        for (int i = 8; i < 40; i++) {
          (k + 0.5 < relief.heightAt(i + 0.5, j + 0.5) ? below : above).set(i, j, k);
        }
      }
    }
    return List.of(below, above);
  }

  private static Pose moved(double x, double y, double z, Vec3 rotation) {
    Pose pose = new Pose();
    pose.rotation.setRotationVector(rotation);
    Vec3 centre = new Vec3(24, 24, 32);
    pose.rotation.rotate(centre, pose.translation);
    centre.sub(pose.translation, pose.translation);
    pose.translation.add(new Vec3(x, y, z), pose.translation);
    return pose;
  }

  private static FitTarget fit(Relief relief, OptionalDouble gap, Pose pose) {
    Optional<FitTarget> fit =
        new FaceFit(GRID, blocks(relief), gap).fit(1, other -> false, List.of(new Pose(), pose));
    return fit.orElseThrow();
  }

  /** Returns how much of a displacement the fit determines. */
  private static double determined(FitTarget fit, int direction) {
    return fit.pull(7 * direction);
  }

  /** Returns the mean of the voxel centres of the upper block. */
  private static Vec3 centroid(Relief relief) {
    PosedBits above = new PosedBits(blocks(relief).get(1), GRID, new Pose());
    return Residual.centroid(above);
  }

  @Test
  void findsThePlaceOfABlockOnHills() {
    Pose wrong = moved(0.7, -0.6, 0.9, new Vec3(0.03, -0.02, 0.04));
    FitTarget fit = fit(HILLS, OptionalDouble.of(0), wrong);
    Vec3 off = fit.pose().translation.sub(centroid(HILLS), new Vec3());
    assertEquals(0, off.length(), 0.1);
    assertEquals(0, fit.pose().rotation.angle(), Math.toRadians(0.3));
    for (int n = 0; n < 6; n++) {
      assertTrue(determined(fit, n) > 0.8, "direction " + n + ": " + determined(fit, n));
    }
  }

  @Test
  void findsThePlaceOfABlockOnAGridOfItsOwn() {
    Quaternion turn = new Quaternion().setRotationVector(new Vec3(0.1, -0.2, 0.6));
    RigidTransform turned =
        new RigidTransform(
            turn.rotate(new Vec3(1, 0, 0), new Vec3()),
            turn.rotate(new Vec3(0, 1, 0), new Vec3()),
            turn.rotate(new Vec3(0, 0, 1), new Vec3()),
            new Vec3(9, -14, 14));
    VoxelGrid fine = new VoxelGrid(96, 80, 64, new Vec3(0.5, 0.6, 0.8), turned);
    BitCube above = new BitCube(96, 80, 64);
    Vec3 at = new Vec3();
    for (int k = 0; k < 64; k++) {
      for (int j = 0; j < 80; j++) {
        for (int i = 0; i < 96; i++) {
          fine.gridToWorld(at.set(i + 0.5, j + 0.5, k + 0.5), at);
          boolean isInBlock =
              at.x >= 8 && at.x < 40 && at.y >= 8 && at.y < 40 && at.z >= 8 && at.z < 40;
          if (isInBlock && at.z >= HILLS.heightAt(at.x, at.y)) {
            above.set(i, j, k);
          }
        }
      }
    }
    FaceFit fit =
        new FaceFit(
            List.of(GRID, fine), List.of(blocks(HILLS).get(0), above), OptionalDouble.of(0));
    Pose wrong = moved(0.7, -0.6, 0.9, new Vec3(0.03, -0.02, 0.04));
    FitTarget found = fit.fit(1, other -> false, List.of(new Pose(), wrong)).orElseThrow();
    Vec3 centroid = Residual.centroid(new PosedBits(above, fine, new Pose()));
    assertEquals(0, found.pose().translation.sub(centroid, centroid).length(), 0.1);
    // Two voxelizations of one surface do not fit each other as well as two halves of one.
    assertEquals(0, found.pose().rotation.angle(), Math.toRadians(0.5));
  }

  @Test
  void leavesABlockThatFitsWhereItIs() {
    FitTarget fit = fit(HILLS, OptionalDouble.of(0), new Pose());
    assertEquals(0, fit.pose().rotation.angle(), Math.toRadians(0.05));
    Vec3 off = fit.pose().translation.sub(centroid(HILLS), new Vec3());
    assertEquals(0, off.length(), 0.05);
  }

  @Test
  void flatFacesDetermineNothingAlongThemselves() {
    FitTarget fit = fit(FLAT, OptionalDouble.of(0), moved(0.5, 0.5, 1, new Vec3(0.02, 0, 0)));
    assertTrue(determined(fit, 0) < 0.1, "x: " + determined(fit, 0));
    assertTrue(determined(fit, 1) < 0.1, "y: " + determined(fit, 1));
    assertTrue(determined(fit, 2) > 0.9, "z: " + determined(fit, 2));
    assertTrue(determined(fit, 3) > 0.8, "about x: " + determined(fit, 3));
    assertTrue(determined(fit, 4) > 0.8, "about y: " + determined(fit, 4));
    assertTrue(determined(fit, 5) < 0.1, "about z: " + determined(fit, 5));
  }

  @Test
  void furrowsDetermineOnlyWhatLiesAcrossThem() {
    FitTarget fit = fit(FURROWS, OptionalDouble.of(0), moved(0.5, 0, 0.5, new Vec3()));
    assertTrue(determined(fit, 0) > 0.8, "across: " + determined(fit, 0));
    assertTrue(determined(fit, 1) < 0.1, "along: " + determined(fit, 1));
  }

  @Test
  void aFreeGapLeavesTheDistanceOfFlatFacesAlone() {
    Pose apart = moved(0, 0, 1.5, new Vec3(0.02, 0, 0));
    FitTarget fit = fit(FLAT, OptionalDouble.empty(), apart);
    assertTrue(determined(fit, 2) < 0.1, "z: " + determined(fit, 2));
    assertTrue(determined(fit, 3) > 0.8, "about x: " + determined(fit, 3));
    FitTarget known = fit(FLAT, OptionalDouble.of(1), apart);
    double z = known.pose().translation.z;
    double closed = fit(FLAT, OptionalDouble.of(0), apart).pose().translation.z;
    assertEquals(1, z - closed, 0.05);
  }

  @Test
  void blocksThatAreFarApartDoNotFit() {
    assertTrue(
        new FaceFit(GRID, blocks(HILLS), OptionalDouble.of(0))
            .fit(1, other -> false, List.of(new Pose(), moved(0, 0, 9, new Vec3())))
            .isEmpty());
  }
}
