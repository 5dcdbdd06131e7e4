package org.palpate.proxy.reference;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.LegPath;
import org.palpate.proxy.ProxySolver;
import org.palpate.raycast.SampledRayCaster;
import org.palpate.testing.LegJudge;
import org.palpate.testing.RandomCases;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;
import org.palpate.volume.phantom.AnalyticSurface;
import org.palpate.volume.phantom.Phantom;

class ReferenceSolversTest {
  private static final GridMetric UNIT = new GridMetric(1, 1, 1);
  private static final double MAX_PATH_MM = 8;

  /** The two published methods, with sampled steps of 1 and border voxels on the fly. */
  enum Baseline {
    DOT,
    PAPER;

    ProxySolver solver(GridMetric metric, double maxPathMm, BorderVoxels border) {
      SampledRayCaster caster = new SampledRayCaster(1);
      return this == DOT
          ? new DotSolver(caster, metric, maxPathMm, border)
          : new PaperSolver(caster, metric, maxPathMm, border);
    }

    ProxySolver solver() {
      return solver(UNIT, MAX_PATH_MM, BorderVoxels.onTheFly());
    }
  }

  private final InteractionPoint point = new InteractionPoint();

  @ParameterizedTest
  @EnumSource
  void goesStraightToAFreeDevice(Baseline baseline) {
    point.position.set(1.5, 1.5, 1.5);
    Vec3 device = new Vec3(3.25, 6.75, 2.5);
    baseline.solver().follow(scene(new BitCube(9, 9, 9)), device, point);
    assertTrue(point.position.sameBits(device));
    assertFalse(point.contact);
    assertEquals(1, point.legs.count());
    assertFalse(point.legs.slid(0));
  }

  @ParameterizedTest
  @EnumSource
  void goesNoFartherThanTheMaximum(Baseline baseline) {
    ProxySolver solver = baseline.solver(new GridMetric(1, 1, 2), 3, BorderVoxels.onTheFly());
    point.position.set(1.5, 1.5, 1.5);
    solver.follow(scene(new BitCube(9, 9, 9)), new Vec3(1.5, 1.5, 8.5), point);
    assertEquals(3, point.position.z, "3 mm are 1.5 voxels of 2 mm");
    assertEquals(3, point.legs.lengthMm());
  }

  @ParameterizedTest
  @EnumSource
  void stopsAtTheLastFreeSample(Baseline baseline) {
    BitCube bits = wall();
    point.position.set(1.9, 4.5, 4.5);
    baseline.solver().follow(scene(bits), new Vec3(6.9, 4.5, 4.5), point);
    assertTrue(point.contact);
    assertEquals(1.9, point.legs.start(0, 0));
    assertEquals(3.9, point.legs.end(0, 0), 1e-5, "a step before the sample at 4.9");
    assertFalse(point.legs.slid(0));
  }

  @ParameterizedTest
  @EnumSource
  void slidesAlongAWallOverBorderVoxels(Baseline baseline) {
    BitCube bits = wall();
    point.position.set(3.5, 1.5, 4.5);
    baseline.solver().follow(scene(bits), new Vec3(6.5, 6.5, 4.5), point);
    assertTrue(point.contact);
    assertTrue(point.position.x < 4 && point.position.y > 5, "" + point.position);
    assertTrue(point.legs.slid(point.legs.count() - 1));
  }

  @ParameterizedTest
  @EnumSource
  void staysWithinTheLimitsOfALegPath(Baseline baseline) {
    BitCube bits = Phantom.parse("sphere:64").segments().segments().get(0).bits();
    ProxySolver solver = baseline.solver(UNIT, 1e9, BorderVoxels.onTheFly());
    point.position.set(32, 32, 60);
    solver.follow(scene(bits), new Vec3(33, 31, 40), point);
    assertTrue(point.legs.count() <= LegPath.CAPACITY);
  }

  @ParameterizedTest
  @EnumSource
  void goesNoFartherThanTheMaximumWhileItSlides(Baseline baseline) {
    BitCube bits = Phantom.parse("torus:64").segments().segments().get(0).bits();
    SplittableRandom random = new SplittableRandom(Seeds.seed());
    ProxySolver solver = baseline.solver();
    point.position.set(32, 32, 60);
    for (int n = 0; n < RandomCases.of(2000); n++) {
      Vec3 device = randomPoint(random, 64);
      solver.follow(scene(bits), device, point);
      assertTrue(point.legs.lengthMm() <= MAX_PATH_MM + 1e-9, "seed " + Seeds.seed());
    }
  }

  @Test
  void paperDoesNotComeToRestOnASlope() {
    Phantom plane = Phantom.parse("plane:96");
    AnalyticSurface surface = plane.analyticSurface().orElseThrow();
    CollisionScene scene = scene(plane.segments().segments().get(0).bits());
    for (int n = 0; n < 20; n++) {
      Vec3 device = new Vec3(30 + 1.7 * n, 50 - 0.9 * n, 20);
      device.z -= (surface.signedDistance(device) + 2 + n % 8) / 0.894;
      assertMovesInEveryFrame(scene, device);
    }
  }

  private void assertMovesInEveryFrame(CollisionScene scene, Vec3 device) {
    ProxySolver solver = Baseline.PAPER.solver();
    point.position.set(device.x + 2, device.y + 4, device.z + 15);
    for (int frame = 0; frame < 250; frame++) {
      solver.follow(scene, device, point);
      assertTrue(point.legs.count() > 0, "device " + device + " rested in frame " + frame);
    }
  }

  @ParameterizedTest
  @EnumSource
  void cutsBetweenTwoSolidsThatShareAnEdge(Baseline baseline) {
    BitCube bits = new BitCube(8, 8, 3);
    bits.set(4, 3, 1);
    bits.set(3, 4, 1);
    point.position.set(3.5, 3.5, 1.5);
    LegJudge judge = new LegJudge(bits, point.position);
    baseline.solver().follow(scene(bits), new Vec3(4.5, 4.5, 1.5), point);
    assertNotNull(judge.faultOf(point), "a baseline passes here; the guarantee forbids it");
  }

  @Test
  void paperChoosesTheVoxelNearestInMillimetres() {
    BitCube bits = new BitCube(8, 8, 8);
    bits.set(4, 4, 4);
    ProxySolver solver =
        Baseline.PAPER.solver(new GridMetric(1, 1, 20), MAX_PATH_MM, BorderVoxels.onTheFly());
    point.position.set(3.5, 4.5, 4.5);
    solver.follow(scene(bits), new Vec3(4.5, 4.9, 4.9), point);
    for (int leg = 0; leg < point.legs.count(); leg++) {
      assertEquals(4.5, point.legs.end(leg, 2), 0.5, "a path along z costs 20 mm a voxel");
    }
  }

  @ParameterizedTest
  @EnumSource
  void precalculatedBorderGivesTheSameFramesAndStaysTrueUnderEdits(Baseline baseline) {
    SplittableRandom random = new SplittableRandom(Seeds.seed());
    BitCube bits = Phantom.parse("sphere:32").segments().segments().get(0).bits();
    CollisionScene scene = scene(bits);
    ProxySolver kept =
        baseline.solver(UNIT, MAX_PATH_MM, new PrecalculatedBorderVoxels(32, 32, 32));
    ProxySolver fly = baseline.solver();
    InteractionPoint other = new InteractionPoint();
    point.position.set(16, 16, 31.5);
    other.position.set(point.position);
    for (int n = 0; n < RandomCases.of(3000); n++) {
      if (n % 4 == 0) {
        edit(bits, random);
        kept.reset();
      }
      Vec3 device = randomPoint(random, 32);
      kept.follow(scene, device, point);
      fly.follow(scene, device, other);
      assertTrue(point.position.sameBits(other.position), "seed " + Seeds.seed() + " frame " + n);
    }
  }

  @ParameterizedTest
  @CsvSource({"1,1,1", "4,5,6", "7,8,9"})
  void precalculatedBorderIsTrueAtEveryVoxelInAndAroundTheGrid(int sizeX, int sizeY, int sizeZ) {
    SplittableRandom random = new SplittableRandom(Seeds.seed());
    BitCube bits = new BitCube(sizeX, sizeY, sizeZ);
    CollisionScene scene = scene(bits);
    BorderVoxels precalculated = new PrecalculatedBorderVoxels(sizeX, sizeY, sizeZ);
    BorderVoxels onTheFly = BorderVoxels.onTheFly();
    for (int solids = 0; solids < 10; solids++) {
      bits.set(random.nextInt(sizeX), random.nextInt(sizeY), random.nextInt(sizeZ));
      precalculated.forget();
      for (int k = -3; k < sizeZ + 3; k++) {
        for (int j = -3; j < sizeY + 3; j++) {
          for (int i = -3; i < sizeX + 3; i++) {
            boolean expected = onTheFly.isBorder(scene, i, j, k);
            assertEquals(expected, precalculated.isBorder(scene, i, j, k), "seed " + Seeds.seed());
          }
        }
      }
    }
  }

  private static void edit(BitCube bits, SplittableRandom random) {
    int i = random.nextInt(32);
    int j = random.nextInt(32);
    int k = random.nextInt(32);
    if (bits.get(i, j, k)) {
      bits.clear(i, j, k);
    } else {
      bits.set(i, j, k);
    }
  }

  @Test
  void collisionOnlyFollowsTheDeviceAndReportsWhetherItsMotionHit() {
    ProxySolver solver = new CollisionOnlySolver(new SampledRayCaster(1), UNIT);
    CollisionScene scene = scene(wall());
    point.position.set(1.5, 4.5, 4.5);
    Vec3 behind = new Vec3(6.5, 4.5, 4.5);
    solver.follow(scene, behind, point);
    assertTrue(point.contact && point.position.sameBits(behind));
    assertEquals(1, point.legs.count());
    solver.follow(scene, behind, point);
    assertFalse(point.contact);
    assertEquals(0, point.legs.count());
  }

  /** Solid where x is 4. */
  private static BitCube wall() {
    BitCube bits = new BitCube(9, 9, 9);
    for (int j = 0; j < 9; j++) {
      for (int k = 0; k < 9; k++) {
        bits.set(4, j, k);
      }
    }
    return bits;
  }

  private static CollisionScene scene(BitCube bits) {
    return new CollisionScene(List.of(bits));
  }

  private static Vec3 randomPoint(SplittableRandom random, double size) {
    return new Vec3(
        random.nextDouble() * size, random.nextDouble() * size, random.nextDouble() * size);
  }
}
