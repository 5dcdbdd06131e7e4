package org.palpate.proxy.smooth.field;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;

/** Derivatives and heights of the field over balls and floors of voxels that are no cubes. */
class FieldSampleTest {
  private static final int EDGE = 36;
  private static final double HALF = EDGE / 2.0;
  private static final double STEP = 1e-4;
  private static final GridMetric METRIC = new GridMetric(1, 1.1, 0.9);

  /** The edges of a voxel, in shortest edges. */
  private static final Vec3 EDGES = new Vec3(1 / 0.9, 1.1 / 0.9, 1);

  private final SeedCell seed = new SeedCell().set(new Vec3(1, 1, 1));
  private final Vec3 at = new Vec3();

  private static OccupancyField field(BitCube bits, GridMetric metric) {
    OccupancyField field = OccupancyField.ofBits(metric);
    field.use(new CollisionScene(List.of(bits)));
    return field;
  }

  private static BitCube ball(double radiusMm, GridMetric metric) {
    BitCube bits = new BitCube(EDGE, EDGE, EDGE);
    for (int n = 0; n < EDGE * EDGE * EDGE; n++) {
      double x = (n % EDGE + 0.5 - HALF) * metric.spacingX();
      double y = (n / EDGE % EDGE + 0.5 - HALF) * metric.spacingY();
      int k = n / (EDGE * EDGE);
      double z = (k + 0.5 - HALF) * metric.spacingZ();
      if (x * x + y * y + z * z < radiusMm * radiusMm) {
        bits.set(n % EDGE, n / EDGE % EDGE, n / (EDGE * EDGE));
      }
    }
    return bits;
  }

  /** Returns a position near the surface of a ball, away from where another corner is nearest. */
  private Vec3 nearSurface(SplittableRandom random, double mm) {
    Vec3 direction = new Vec3();
    do {
      direction.set(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1));
    } while (direction.length() < 0.1);
    direction.mul(mm / direction.length(), direction);
    at.set(
        HALF + direction.x / METRIC.spacingX(),
        HALF + direction.y / METRIC.spacingY(),
        HALF + direction.z / METRIC.spacingZ());
    for (int axis = 0; axis < 3; axis++) {
      double fromCorner = at.get(axis) - Math.rint(at.get(axis));
      at.set(axis, at.get(axis) - 0.02 * fromCorner);
    }
    return at;
  }

  @Test
  void gradientAndHessianAreTheDifferencesOfTheOccupancy() {
    OccupancyField field = field(ball(11, METRIC), METRIC);
    SplittableRandom random = new SplittableRandom(Seeds.seed());
    double largest = 0;
    for (int n = 0; n < 300; n++) {
      Vec3 p = new Vec3().set(nearSurface(random, random.nextDouble(11, 13)));
      double[] gradient = gradient(field, p);
      FieldSample sample = field.sample();
      double[][] hessian = {
        {sample.hxx(), sample.hxy(), sample.hxz()},
        {sample.hxy(), sample.hyy(), sample.hyz()},
        {sample.hxz(), sample.hyz(), sample.hzz()}
      };
      for (int axis = 0; axis < 3; axis++) {
        double step = 2 * STEP * EDGES.get(axis);
        at.set(p);
        at.set(axis, p.get(axis) + STEP);
        double high = field.evaluate(seed, at).occupancy();
        double[] highGradient = gradient(field, at);
        at.set(axis, p.get(axis) - STEP);
        double low = field.evaluate(seed, at).occupancy();
        double[] lowGradient = gradient(field, at);
        assertEquals((high - low) / step, gradient[axis], 1e-6, "n=" + n + " axis " + axis);
        for (int other = 0; other < 3; other++) {
          double expected = (highGradient[other] - lowGradient[other]) / step;
          assertEquals(expected, hessian[axis][other], 1e-6, "n=" + n + " " + axis + other);
          largest = Math.max(largest, Math.abs(expected));
        }
      }
    }
    assertTrue(largest > 0.03, "curved: " + largest);
  }

  private double[] gradient(OccupancyField field, Vec3 p) {
    FieldSample sample = field.evaluate(seed, p);
    return new double[] {sample.gx(), sample.gy(), sample.gz()};
  }

  /** Over a ball of radius r both principal curvatures are about 1/r of the isosurface. */
  @ParameterizedTest
  @ValueSource(doubles = {9, 12})
  void theSumOfTheCurvaturesOverABallIsTwoOverItsRadius(double radiusMm) {
    OccupancyField field = field(ball(radiusMm, METRIC), METRIC);
    SplittableRandom random = new SplittableRandom(Seeds.seed());
    double sum = 0;
    int count = 2_000;
    double above = field.level().mostOffsetEdges() * METRIC.shortestEdgeMm();
    for (int n = 0; n < count; n++) {
      field.evaluate(seed, nearSurface(random, radiusMm + above));
      assertTrue(field.sample().hasNormal());
      sum += field.sample().curvatureSum();
    }
    double expected = 2 * METRIC.shortestEdgeMm() / (radiusMm + above);
    assertEquals(expected, sum / count, 0.1 * expected);
  }

  /**
   * A floor across each axis; the kernel is no Gaussian, so that heights are true to some
   * hundredths.
   */
  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2})
  void aboveAFloorHeightAndOffsetAddUpToTheDistanceFromTheVoxels(int axis) {
    BitCube bits = new BitCube(EDGE, EDGE, EDGE);
    for (int n = 0; n < EDGE * EDGE * EDGE; n++) {
      int[] cell = {n % EDGE, n / EDGE % EDGE, n / (EDGE * EDGE)};
      if (cell[axis] < 12) {
        bits.set(cell[0], cell[1], cell[2]);
      }
    }
    OccupancyField field = field(bits, METRIC);
    double offset = field.level().mostOffsetEdges();
    seed.set(new Vec3(30, 30, 30));
    for (double edges : new double[] {0.5, 0.8, 1.1, 1.4}) {
      at.set(16.3, 17.6, 15.2);
      at.set(axis, 12 + edges / EDGES.get(axis));
      FieldSample sample = field.evaluate(seed, at);
      assertTrue(sample.hasNormal());
      assertEquals(1, sample.normal().get(axis), 1e-9);
      assertEquals(edges, offset + sample.boundedHeightEdges(), 0.06, "at " + edges);
      assertEquals(edges - offset, sample.heightEdges(), 0.15, "at " + edges);
    }
    at.set(axis, 12 + offset / EDGES.get(axis));
    assertEquals(field.level().occupancy(field.sample().normal()), occupancy(field), 0.01);
    at.set(axis, 20);
    assertTrue(field.evaluate(seed, at).isOpen());
    at.set(axis, 6);
    assertTrue(occupancy(field) > 0.99, "deep inside " + occupancy(field));
  }

  private double occupancy(OccupancyField field) {
    return field.evaluate(seed, at).occupancy();
  }
}
