package org.palpate.proxy.reference;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.LegPath;
import org.palpate.proxy.reference.ReferenceSolversTest.Baseline;
import org.palpate.raycast.ExactRayCaster;
import org.palpate.raycast.SampledRayCaster;
import org.palpate.statistics.SkipCounters;
import org.palpate.statistics.SkipKind;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;

/** The legs of the published methods on voxels of 2 x 0.5 x 3 mm. */
class ReferenceLegsTest {
  private static final GridMetric METRIC = new GridMetric(2, 0.5, 3);
  private static final int EDGE = 16;

  private final BitCube bits = new BitCube(EDGE, EDGE, EDGE);
  private final CollisionScene scene = new CollisionScene(List.of(bits));
  private final InteractionPoint point = new InteractionPoint();
  private final BorderVoxels border = BorderVoxels.onTheFly();

  private static double mm(Vec3 from, Vec3 to) {
    return METRIC.distance(from.x, from.y, from.z, to.x, to.y, to.z);
  }

  private Vec3 start(int leg) {
    LegPath legs = point.legs;
    return new Vec3(legs.start(leg, 0), legs.start(leg, 1), legs.start(leg, 2));
  }

  private Vec3 end(int leg) {
    LegPath legs = point.legs;
    return new Vec3(legs.end(leg, 0), legs.end(leg, 1), legs.end(leg, 2));
  }

  private void assertSamePoint(Vec3 expected, Vec3 actual) {
    assertEquals(0, expected.sub(actual, new Vec3()).length(), 1e-12, expected + " " + actual);
  }

  @ParameterizedTest
  @EnumSource
  void aPathThatIsTooShortEndsOnTheSegmentToTheDevice(Baseline baseline) {
    Vec3 from = new Vec3(1.5, 2.5, 3.5);
    Vec3 device = new Vec3(9.5, 12.5, 7.5);
    point.position.set(from);
    baseline.solver(METRIC, 6, border).follow(scene, device, point);
    Vec3 way = device.sub(from, new Vec3());
    Vec3 expected = from.add(way.mul(6 / mm(from, device), new Vec3()), new Vec3());
    assertSamePoint(expected, point.position);
    assertEquals(6, point.legs.lengthMm());
  }

  /** The wall at z = 10 is met obliquely; the path ends before it, or the sample before it does. */
  @ParameterizedTest
  @EnumSource
  void theFirstLegBeforeACollisionLiesOnTheSegmentAndHasItsLengthInMillimetres(Baseline baseline) {
    for (int n = 0; n < EDGE * EDGE; n++) {
      bits.set(n % EDGE, n / EDGE, 10);
    }
    Vec3 from = new Vec3(1.5, 12.5, 1.5);
    Vec3 device = new Vec3(9.5, 2.5, 12.5);
    for (double maxMm : new double[] {4, 1_000}) {
      point.position.set(from);
      baseline.solver(METRIC, maxMm, border).follow(scene, device, point);
      Vec3 end = end(0);
      double fraction = (end.z - from.z) / (device.z - from.z);
      Vec3 way = device.sub(from, new Vec3());
      assertSamePoint(from.add(way.mul(fraction, new Vec3()), new Vec3()), end);
      assertEquals(mm(from, end), point.legs.lengthMm(0), 1e-12);
      assertEquals(maxMm == 4, Math.abs(point.legs.lengthMm() - 4) < 1e-12);
      assertTrue(end.z < 10 && (maxMm == 4 || end.z > 8), "" + end);
    }
  }

  /**
   * Dot takes the border voxel farthest along the direction, paper the one nearest to the device.
   */
  @ParameterizedTest
  @EnumSource
  void slidesToTheBorderVoxelThatTheMethodNames(Baseline baseline) {
    SplittableRandom random = new SplittableRandom(Seeds.seed());
    for (int n = 0; n < EDGE * EDGE * 6; n++) {
      bits.set(n % EDGE, n / EDGE % EDGE, n / (EDGE * EDGE));
    }
    int slid = 0;
    for (int n = 0; n < 500; n++) {
      point.position.set(
          random.nextInt(3, 13) + 0.5,
          random.nextInt(3, 13) + 0.5,
          6 + random.nextDouble(0.3, 0.7));
      Vec3 device =
          new Vec3(random.nextDouble(1, 15), random.nextDouble(1, 15), random.nextDouble(2, 5.9));
      baseline.solver(METRIC, 1_000, border).follow(scene, device, point);
      for (int leg = 0; leg < point.legs.count(); leg++) {
        if (point.legs.slid(leg)) {
          slid++;
          assertSamePoint(selected(baseline, start(leg), device), end(leg));
        }
      }
    }
    assertTrue(slid > 100, "slid " + slid);
  }

  private Vec3 selected(Baseline baseline, Vec3 p, Vec3 device) {
    Vec3 best = null;
    double most = baseline == Baseline.DOT ? 0 : Double.NEGATIVE_INFINITY;
    for (int k = -1; k <= 1; k++) {
      for (int j = -1; j <= 1; j++) {
        for (int i = -1; i <= 1; i++) {
          Vec3 cell = new Vec3(Math.floor(p.x) + i, Math.floor(p.y) + j, Math.floor(p.z) + k);
          boolean isBorder =
              (i != 0 || j != 0 || k != 0)
                  && border.isBorder(scene, (int) cell.x, (int) cell.y, (int) cell.z);
          Vec3 centre = cell.add(new Vec3(0.5, 0.5, 0.5), new Vec3());
          double value = baseline == Baseline.DOT ? dot(p, centre, device) : -mm(centre, device);
          if (isBorder && value > most) {
            most = value;
            best = centre;
          }
        }
      }
    }
    return best;
  }

  /** Returns the scalar product in mm^2 of the ways to a voxel and to the device. */
  private static double dot(Vec3 p, Vec3 centre, Vec3 device) {
    Vec3 a = centre.sub(p, new Vec3());
    Vec3 b = device.sub(p, new Vec3());
    return 4 * a.x * b.x + 0.25 * a.y * b.y + 9 * a.z * b.z;
  }

  @Test
  void aSolverWithoutResponseAddsTheSkipsOfAnExactCaster() {
    bits.set(15, 15, 15);
    bits.set(0, 0, 0);
    point.position.set(1.5, 14.5, 1.5);
    CollisionOnlySolver exact = new CollisionOnlySolver(new ExactRayCaster(), METRIC);
    exact.follow(scene, new Vec3(14.5, 1.5, 12.5), point);
    SkipCounters counts = new SkipCounters();
    exact.addSkips(counts);
    assertTrue(counts.of(SkipKind.EMPTY_BRICKS) > 0);
    assertEquals(1, counts.of(SkipKind.RESPONSE));
    CollisionOnlySolver sampled = new CollisionOnlySolver(new SampledRayCaster(1), METRIC);
    sampled.follow(scene, new Vec3(1.5, 14.5, 1.5), point);
    SkipCounters other = new SkipCounters();
    sampled.addSkips(other);
    assertEquals(0, other.of(SkipKind.EMPTY_BRICKS));
  }
}
