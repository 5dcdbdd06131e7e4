package org.palpate.benchmarks.accuracy;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.volume.BitCube;
import org.palpate.volume.ScalarVolume;
import org.palpate.volume.phantom.AnalyticSurface;
import org.palpate.volume.phantom.Phantom;

/** The scenes on which all errors are measured: a wrong voxel there would be an error of each. */
class AccuracySceneTest {
  private static final long SEED = Long.getLong("palpate.seed", 20_261_129);
  private static final int EDGE = 64;
  private static final Vec3 SPACING = new Vec3(1, 2, 3.2);

  /** A ball of radius 20.3 around (31.7, 32.4, 33.1). */
  private static final AnalyticSurface BALL =
      new AnalyticSurface() {
        private final Vec3 centre = new Vec3(31.7, 32.4, 33.1);

        @Override
        public double signedDistance(Vec3 at) {
          return at.sub(centre, new Vec3()).length() - 20.3;
        }

        @Override
        public Vec3 normal(Vec3 at, Vec3 dest) {
          at.sub(centre, dest);
          return dest.mul(1 / dest.length(), dest);
        }
      };

  private final SplittableRandom random = new SplittableRandom(SEED);

  private static Vec3 centre(int i, int j, int k) {
    return new Vec3((i + 0.5) * SPACING.x, (j + 0.5) * SPACING.y, (k + 0.5) * SPACING.z);
  }

  @Test
  void aVoxelIsSolidExactlyIfItsCentreIsInside() {
    BitCube bits = SampledSolids.of(BALL, EDGE, SPACING);
    assertEquals(
        List.of(64, 32, 20), List.of(bits.sizeX(), bits.sizeY(), bits.sizeZ()), "whole voxels");
    int solid = 0;
    for (int n = 0; n < 64 * 32 * 20; n++) {
      int i = n % 64;
      int j = n / 64 % 32;
      int k = n / (64 * 32);
      Vec3 at = centre(i, j, k);
      double squared =
          square(at.x - 31.7) + square(at.y - 32.4) + square(at.z - 33.1) - square(20.3);
      assertEquals(squared < 0, bits.get(i, j, k), "voxel " + i + "," + j + "," + k);
      solid += squared < 0 ? 1 : 0;
    }
    double volumeMm3 = solid * SPACING.x * SPACING.y * SPACING.z;
    assertEquals(4.0 / 3 * Math.PI * Math.pow(20.3, 3), volumeMm3, 0.02 * volumeMm3);
  }

  private static double square(double x) {
    return x * x;
  }

  @Test
  void aGreyValueIsTheSolidFractionOfItsVoxel() {
    ScalarVolume volume = SampledSolids.greyOf(new HorizontalPlane(10), EDGE, SPACING);
    for (int k = 0; k < 20; k++) {
      double solid = Math.max(0, Math.min(1, (10 - SPACING.z * k) / SPACING.z));
      double grey = volume.value(random.nextInt(64), random.nextInt(32), k);
      assertEquals(Phantom.SOLID_GREY * solid, grey, Phantom.SOLID_GREY / 50.0, "slice " + k);
      assertEquals(solid == 0 || solid == 1, grey == 0 || grey == Phantom.SOLID_GREY);
    }
  }

  /** Each value against the fraction of points drawn at random in the voxel. */
  @Test
  void theGreyValuesOfABallAreThoseOfRandomPointsInEachVoxel() {
    ScalarVolume volume = SampledSolids.greyOf(BALL, EDGE, SPACING);
    int partial = 0;
    double sum = 0;
    for (int n = 0; n < 3_000; n++) {
      int i = random.nextInt(64);
      int j = random.nextInt(32);
      int k = random.nextInt(20);
      int inside = 0;
      for (int draw = 0; draw < 400; draw++) {
        Vec3 at =
            new Vec3(
                (i + random.nextDouble()) * SPACING.x,
                (j + random.nextDouble()) * SPACING.y,
                (k + random.nextDouble()) * SPACING.z);
        inside += BALL.signedDistance(at) < 0 ? 1 : 0;
      }
      double expected = Phantom.SOLID_GREY * inside / 400.0;
      double grey = volume.value(i, j, k);
      assertEquals(expected, grey, Phantom.SOLID_GREY * 0.13, "voxel " + i + "," + j + "," + k);
      if (inside > 0 && inside < 400) {
        partial++;
        sum += grey - expected;
      }
    }
    assertTrue(partial > 100, "partial: " + partial);
    assertEquals(0, sum / partial, Phantom.SOLID_GREY * 0.01, "no bias");
  }

  @Test
  void theSumOfTheGreyValuesIsTheVolumeOfTheBall() {
    ScalarVolume volume = SampledSolids.greyOf(BALL, EDGE, SPACING);
    double sum = 0;
    for (int n = 0; n < 64 * 32 * 20; n++) {
      sum += volume.value(n % 64, n / 64 % 32, n / (64 * 32)) / Phantom.SOLID_GREY;
    }
    double volumeMm3 = sum * SPACING.x * SPACING.y * SPACING.z;
    assertEquals(4.0 / 3 * Math.PI * Math.pow(20.3, 3), volumeMm3, 0.001 * volumeMm3);
  }

  @Test
  void theThresholdTakesVoxelsThatAreAtLeastHalfSolid() {
    ScalarVolume volume = SampledSolids.greyOf(BALL, EDGE, SPACING);
    volume.set(1, 1, 1, Phantom.HALF_GREY);
    volume.set(2, 1, 1, Phantom.HALF_GREY - 1);
    BitCube bits = SampledSolids.threshold(volume);
    for (int n = 0; n < 64 * 32 * 20; n++) {
      int i = n % 64;
      int j = n / 64 % 32;
      int k = n / (64 * 32);
      assertEquals(2 * volume.value(i, j, k) >= Phantom.SOLID_GREY, bits.get(i, j, k));
    }
    assertTrue(bits.get(1, 1, 1) && !bits.get(2, 1, 1));
  }

  @Test
  void aSceneConvertsBetweenMillimetresAndItsGrid() {
    AccuracyScene scene = AccuracyStudy.scene("sphere", "1:2:4");
    Vec3 grid = scene.toGrid(new Vec3(6, 8, 20), new Vec3());
    assertEquals(List.of(6.0, 4.0, 5.0), List.of(grid.x, grid.y, grid.z));
    Vec3 mm = scene.toMm(new Vec3(6, 4, 5), new Vec3());
    assertEquals(List.of(6.0, 8.0, 20.0), List.of(mm.x, mm.y, mm.z));
    assertEquals(2, scene.metric.spacingY());
    assertEquals(192, scene.bits.sizeX());
    assertEquals(96, scene.bits.sizeY());
    assertEquals(48, scene.bits.sizeZ());
  }

  @Test
  void theBitsAndTheThresholdOfASceneAreTheSameBallButForItsRim() {
    AccuracyScene scene = AccuracyStudy.scene("sphere", "1:1:3");
    int differing = 0;
    int solid = 0;
    for (int n = 0; n < 192 * 192 * 64; n++) {
      int i = n % 192;
      int j = n / 192 % 192;
      int k = n / (192 * 192);
      boolean inBits = scene.bits.get(i, j, k);
      solid += inBits ? 1 : 0;
      if (inBits != scene.greyCollisionScene.isSolid(i, j, k)) {
        differing++;
        double height =
            scene.truth.signedDistance(scene.toMm(new Vec3(i + 0.5, j + 0.5, k + 0.5), new Vec3()));
        assertTrue(Math.abs(height) < 0.3, "half solid, and its centre " + height + " mm away");
      }
    }
    assertTrue(solid > 100_000 && differing < solid / 100, differing + " of " + solid);
    assertEquals(Phantom.HALF_GREY, scene.grey.threshold());
  }

  @Test
  void everySolverHasANameOfItsOwnAndStopsAtASphere() {
    AccuracyScene scene = AccuracyStudy.scene("sphere", AccuracyStudy.CUBES);
    List<ComparedSolver> all = ComparedSolver.all(scene);
    assertEquals(all.size(), all.stream().map(ComparedSolver::name).distinct().count());
    assertEquals(ComparedSolver.BASELINE, all.get(0).name());
    Vec3 device = new Vec3();
    double radius = -scene.truth.signedDistance(new Vec3(96, 96, 96));
    for (ComparedSolver one : all) {
      InteractionPoint point = new InteractionPoint();
      point.position.set(96.3, 96.2, 96 + radius + 8);
      device.set(96.3, 96.2, 96 + radius + 8);
      for (int frame = 0; frame < 60; frame++) {
        device.z -= 0.2;
        one.solver().follow(one.scene(), device, point);
      }
      assertTrue(point.contact, one.name());
      double height = scene.truth.signedDistance(point.position);
      assertTrue(Math.abs(height) < 1.5, one.name() + " is " + height + " mm above the surface");
    }
  }

  @Test
  void theSolversOfThisProjectAreAmongAllOfThem() {
    AccuracyScene scene = AccuracyStudy.scene("plane", AccuracyStudy.CUBES);
    List<String> ours = ComparedSolver.ours(scene).stream().map(ComparedSolver::name).toList();
    assertEquals(List.of("twin", "guarded", "smooth", "smooth grey"), ours);
    List<String> all = ComparedSolver.all(scene).stream().map(ComparedSolver::name).toList();
    assertTrue(all.containsAll(ours));
    assertEquals(10, all.size());
  }
}
