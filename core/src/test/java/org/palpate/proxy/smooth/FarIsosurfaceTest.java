package org.palpate.proxy.smooth;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import java.util.function.Predicate;
import org.junit.jupiter.api.Test;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.smooth.ClosestPointSearch.Outcome;
import org.palpate.proxy.smooth.field.GreyIsosurface;
import org.palpate.proxy.smooth.field.GreyIsosurfaceSource;
import org.palpate.proxy.smooth.field.OccupancyField;
import org.palpate.proxy.smooth.field.SeedCell;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;
import org.palpate.volume.ScalarVolume;
import org.palpate.volume.VoxelGrid;

/** Searches from grey values over slices of 5 mm, where the isosurface lies 2.6 mm outside. */
class FarIsosurfaceTest {
  private static final GridMetric METRIC = new GridMetric(1, 1, 5);
  private static final int PIXELS = 48;
  private static final int SLICES = 10;

  /** Samples along each axis of a pixel; along z five times as many. */
  private static final int SAMPLES = 3;

  private static final double FULL = 1000;
  private static final int SEARCHES = 500;

  private final SplittableRandom random = new SplittableRandom(Seeds.seed());
  private final EdgeUnits units = new EdgeUnits(METRIC);
  private final SeedCell seed = new SeedCell();
  private final Vec3 start = new Vec3();
  private final Vec3 device = new Vec3();
  private OccupancyField field;
  private WindowBudget budget;
  private ClosestPointSearch search;

  @Test
  void onlyTheIsosurfaceOfGreyValuesOverThickSlicesIsFar() {
    use(mm -> false);
    assertTrue(field.level().isFar());
    assertFalse(OccupancyField.ofBits(new GridMetric(1, 1, 10)).level().isFar());
    assertFalse(grey(new GridMetric(1, 1, 3), PIXELS, SLICES, mm -> false).level().isFar());
  }

  /** The isosurface itself has normals up to 1.2 degrees off the plane's. */
  @Test
  void belowThePointFoundTheDeviceLiesAlongTheNormalOfAPlane() {
    Vec3 normal = new Vec3(0.3, -0.2, 1);
    normal.mul(1 / normal.length(), normal);
    Vec3 middle = new Vec3(24, 24, 25);
    use(mm -> normal.dot(mm) < normal.dot(middle));
    double worst = 0;
    for (int n = 0; n < SEARCHES; n++) {
      Vec3 onPlane = beside(middle, normal, 5);
      double depth = random.nextDouble(1, 3);
      place(onPlane, -depth, normal, device);
      place(beside(onPlane, normal, 1), field.level().offsetEdges(normal), normal, start);
      assertEquals(Outcome.CONVERGED, find());
      assertEquals(0, heightOfFound(), 0.2);
      assertTrue(search.hasLeftStart());
      Vec3 up = new Vec3();
      units.vector(device, search.found(), up);
      double cosine = up.dot(normal) / up.length();
      worst = Math.max(worst, Math.toDegrees(Math.acos(Math.min(1, cosine))));
    }
    assertTrue(worst < 0.3, "worst angle " + worst);
  }

  /** The field of a rod of half a pixel does not reach the occupancy of the nearer level. */
  @Test
  void overAThinRodThePointFoundLiesOnTheIsosurfaceItself() {
    use(mm -> mm.x > 24 && mm.x < 24.7 && mm.z > 25 && mm.z < 29);
    Vec3 right = new Vec3(1, 0, 0);
    int converged = 0;
    for (int n = 0; n < SEARCHES; n++) {
      Vec3 inside = new Vec3(24.4, random.nextDouble(14, 34), random.nextDouble(26.5, 27.5));
      place(inside, 0, right, device);
      place(inside, random.nextDouble(1, 2.5), right, start);
      if (find() == Outcome.CONVERGED) {
        converged++;
        assertEquals(0, heightOfFound(), 0.05);
      }
    }
    assertTrue(converged > 0.9 * SEARCHES, "converged " + converged);
  }

  @Test
  void aDeviceAboveTheIsosurfaceIsOutsideAndTheSearchStaysAtItsStart() {
    use(mm -> mm.z < 25);
    Vec3 up = new Vec3(0, 0, 1);
    place(new Vec3(24, 24, 25), field.level().offsetEdges(up), up, start);
    place(new Vec3(24.5, 24, 25), field.level().offsetEdges(up) + 1, up, device);
    assertEquals(Outcome.OUTSIDE, find());
    assertFalse(search.hasLeftStart());
  }

  @Test
  void anOverdrawnBudgetLeavesASearchAtMostTwoWindows() {
    use(mm -> mm.z < 25);
    Vec3 up = new Vec3(0, 0, 1);
    place(new Vec3(24, 24, 25), field.level().offsetEdges(up), up, start);
    budget.beginFrame();
    for (int n = 0; !budget.isOverdrawn(); n++) {
      field.evaluate(seed.set(start), new Vec3(14 + n, 24, start.z));
    }
    place(new Vec3(26, 24, 25), -2, up, device);
    long before = field.windowReads();
    search.search(seed.set(start), start, device);
    assertTrue(field.windowReads() - before <= 2);
  }

  private Outcome find() {
    budget.beginFrame();
    return search.search(seed.set(start), start, device);
  }

  private double heightOfFound() {
    Vec3 found = new Vec3().set(search.found());
    field.evaluate(seed.set(found), found);
    assertTrue(field.sample().hasNormal());
    return field.sample().heightEdges();
  }

  /** Returns a random position in a plane, at most so far from another one. */
  private Vec3 beside(Vec3 position, Vec3 normal, double mm) {
    Vec3 result =
        new Vec3(
            random.nextDouble(-0.5, 0.5), random.nextDouble(-0.5, 0.5), random.nextDouble(-1, 1));
    result.sub(normal.mul(result.dot(normal), new Vec3()), result);
    return result.mul(mm / Math.max(1, result.length()), result).add(position, result);
  }

  /** Writes the grid coordinates of a position above another one, both in mm. */
  private static void place(Vec3 mm, double height, Vec3 normal, Vec3 dest) {
    dest.set(mm.x + height * normal.x, mm.y + height * normal.y, (mm.z + height * normal.z) / 5);
  }

  private void use(Predicate<Vec3> solid) {
    field = grey(METRIC, PIXELS, SLICES, solid);
    budget = new WindowBudget(field);
    search = new ClosestPointSearch(field, units, budget);
  }

  /** Returns the field of a solid; the value of a voxel is the solid fraction of its volume. */
  private static OccupancyField grey(
      GridMetric metric, int pixels, int slices, Predicate<Vec3> solid) {
    ScalarVolume volume =
        ScalarVolume.of(VoxelGrid.ofUnitVoxels(pixels, pixels, slices), ScalarVolume.Storage.INT16);
    BitCube bits = new BitCube(pixels, pixels, slices);
    for (int k = 0; k < slices; k++) {
      for (int j = 0; j < pixels; j++) {
        for (int i = 0; i < pixels; i++) {
          double value = Math.rint(FULL * fraction(solid, i, j, k, metric.spacingZ()));
          volume.set(i, j, k, value);
          if (value >= FULL / 2) {
            bits.set(i, j, k);
          }
        }
      }
    }
    GreyIsosurface grey = new GreyIsosurface(volume, FULL / 2, FULL / 2);
    OccupancyField field = OccupancyField.ofGrey(metric, new GreyIsosurfaceSource(grey));
    field.use(new CollisionScene(List.of(bits)));
    return field;
  }

  private static double fraction(Predicate<Vec3> solid, int i, int j, int k, double sliceMm) {
    Vec3 mm = new Vec3();
    int inside = 0;
    for (int n = 0; n < SAMPLES * SAMPLES * 5 * SAMPLES; n++) {
      int layer = n / (SAMPLES * SAMPLES);
      mm.set(
          i + (n % SAMPLES + 0.5) / SAMPLES,
          j + (n / SAMPLES % SAMPLES + 0.5) / SAMPLES,
          sliceMm * (k + (layer + 0.5) / (5 * SAMPLES)));
      inside += solid.test(mm) ? 1 : 0;
    }
    return inside / (double) (SAMPLES * SAMPLES * 5 * SAMPLES);
  }
}
