package org.palpate.proxy.smooth;

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
import org.palpate.proxy.smooth.field.OccupancyField;
import org.palpate.proxy.smooth.field.SeedCell;
import org.palpate.testing.Floor;

class IsosurfaceIntersectionTest {
  /** Fixed, because the number of evaluations belongs to it. */
  private static final long SEED = 25;

  private OccupancyField field;
  private EdgeUnits units;
  private WindowBudget budget;
  private IsosurfaceIntersection intersection;
  private final SeedCell seed = new SeedCell();
  private final Vec3 at = new Vec3();

  private void use(GridMetric metric, CollisionScene scene) {
    field = OccupancyField.ofBits(metric);
    field.use(scene);
    units = new EdgeUnits(metric);
    budget = new WindowBudget(field);
    intersection = new IsosurfaceIntersection(field, units, budget);
  }

  private double heightAt(Vec3 from, Vec3 to, double fraction) {
    VerifiedMotion.between(from, to, fraction, at);
    field.evaluate(seed.set(at), at);
    return field.sample().hasNormal() ? field.sample().heightEdges() : Double.POSITIVE_INFINITY;
  }

  /** Segments from above the surface of an ellipsoid into the field below its isosurface. */
  @ParameterizedTest
  @ValueSource(doubles = {0.9, 1, 1.2})
  void theResultLiesOnTheIsosurfaceOrALittleAboveIt(double spacingY) {
    GridMetric metric = new GridMetric(1, spacingY, 1);
    Quadrics quadric = new Quadrics(metric, new Vec3(15, 9, 8), false);
    use(metric, new CollisionScene(List.of(quadric.bits())));
    SplittableRandom random = new SplittableRandom(SEED);
    int found = 0;
    int onSurface = 0;
    long evaluations = 0;
    for (int n = 0; n < 1_000; n++) {
      Vec3 to = quadric.position(random, random.nextDouble(0.05, 0.9));
      Vec3 from = above(to, random);
      double last = random.nextBoolean() ? 1 : random.nextDouble(0.9, 1);
      boolean isInside = heightAt(from, to, last) < 0;
      long before = field.sample().evaluation();
      budget.beginFrame();
      double fraction = intersection.find(from, to, last);
      assertEquals(isInside, !Double.isNaN(fraction), "n=" + n);
      if (isInside) {
        found++;
        evaluations += field.sample().evaluation() - before;
        assertTrue(fraction >= 0 && fraction <= last, "n=" + n + " fraction " + fraction);
        double height = heightAt(from, to, fraction);
        assertTrue(height >= 0, "n=" + n + " height " + height);
        onSurface += height <= IsosurfaceIntersection.TOLERANCE_EDGES ? 1 : 0;
      }
    }
    assertTrue(found > 300, "found " + found);
    assertTrue(onSurface >= 0.99 * found, "on the surface " + onSurface + " of " + found);
    assertTrue(evaluations <= 1.4 * found, "evaluations " + evaluations + " for " + found);
  }

  /** Returns a position above the isosurface, 2 to 8 edges farther out and beside the first. */
  private Vec3 above(Vec3 to, SplittableRandom random) {
    Vec3 from = awayFrom(to, random);
    while (heightAt(from, from, 0) < IsosurfaceIntersection.TOLERANCE_EDGES) {
      from = awayFrom(to, random);
    }
    return from;
  }

  private Vec3 awayFrom(Vec3 to, SplittableRandom random) {
    seed.set(to);
    assertTrue(field.evaluate(seed, to).hasNormal());
    Vec3 from = new Vec3();
    units.offset(to, random.nextDouble(2, 8), field.sample().normal(), from);
    return from.add(
        new Vec3(random.nextDouble(-6, 6), random.nextDouble(-6, 6), random.nextDouble(-6, 6)),
        from);
  }

  @Test
  void aSegmentAboveAFloorMeetsTheIsosurfaceAtItsOffset() {
    use(Floor.METRIC, Floor.make().scene);
    Vec3 from = new Vec3(10, 11, 20);
    Vec3 to = new Vec3(22, 19, Floor.TOP + 0.25);
    double surface = Floor.TOP + field.level().mostOffsetEdges();
    budget.beginFrame();
    double fraction = intersection.find(from, to, 1);
    assertEquals((20 - surface) / (20 - to.z), fraction, 0.003);
    budget.beginFrame();
    assertTrue(Double.isNaN(intersection.find(from, to, 0.5)), "it ends high above");
    budget.beginFrame();
    double before = intersection.find(from, to, 0.99);
    assertEquals(fraction, before, 0.002);
  }

  @Test
  void aSearchWhoseBudgetIsOverdrawnReturnsAPartThatIsKnownToLieAbove() {
    use(Floor.METRIC, Floor.make().scene);
    Vec3 from = new Vec3(10, 11, 20);
    Vec3 to = new Vec3(22, 19, Floor.TOP + 0.25);
    double fraction = intersection.find(from, to, 1); // no frame has begun, so nothing is left
    assertTrue(fraction >= 0 && fraction < 1);
    assertTrue(heightAt(from, to, fraction) >= 0);
  }
}
