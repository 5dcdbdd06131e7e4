package org.palpate.proxy.smooth.field;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;

class OccupancyFieldTest {
  private static final long SEED = Seeds.seed();
  private static final int[] ISOTROPIC = {6, 5};

  private final Random random = new Random(SEED);

  @Test
  void equalsItsDefinitionOnRandomBits() {
    for (double share : new double[] {0.02, 0.2, 0.5, 0.8, 0.97}) {
      compare(randomBits(share), new Vec3(1, 1, 1), new int[][] {ISOTROPIC, ISOTROPIC, ISOTROPIC});
    }
  }

  @Test
  void equalsItsDefinitionOnThinWalls() {
    BitCube walls = new BitCube(27, 29, 31);
    for (int j = 0; j < 29; j++) {
      for (int k = 0; k < 31; k++) {
        for (int i = 3; i < 27; i += 4) {
          if (random.nextInt(40) != 0) {
            walls.set(i, j, k);
          }
        }
      }
    }
    compare(walls, new Vec3(1, 1, 1), new int[][] {ISOTROPIC, ISOTROPIC, ISOTROPIC});
  }

  @Test
  void longerVoxelsGetNarrowerBoxes() {
    compare(randomBits(0.4), new Vec3(0.5, 0.5, 1), new int[][] {ISOTROPIC, ISOTROPIC, {3, 2}});
  }

  /**
   * A seed in a solid reaches nothing, and all counts as reached; the next one is another matter.
   */
  @Test
  void aSeedInASolidLeavesNothingBehind() {
    BitCube wall = new BitCube(24, 24, 24);
    for (int k = 0; k < 24; k++) {
      for (int j = 0; j < 24; j++) {
        wall.set(10, j, k);
      }
    }
    CollisionScene obstacles = new CollisionScene(List.of(wall));
    OccupancyField fresh = field(new Vec3(1, 1, 1));
    OccupancyField used = field(new Vec3(1, 1, 1));
    used.use(obstacles);
    used.seed(10, 12.5, 12.5);
    used.evaluate(10, 12.5, 12.5);
    for (OccupancyField field : List.of(fresh, used)) {
      field.use(obstacles);
      field.seed(9.7, 12.5, 12.5);
      field.evaluate(9.7, 12.5, 12.5);
    }
    assertEquals(fresh.value, used.value);
    used.seed(10, 12.5, 12.5);
    used.evaluate(9.7, 12.5, 12.5);
    OccupancyField other = field(new Vec3(1, 1, 1));
    other.use(obstacles);
    other.seed(10, 12.5, 12.5);
    other.evaluate(9.7, 12.5, 12.5);
    assertEquals(other.value, used.value);
  }

  @Test
  void answersAlikeWhateverWasAskedBefore() {
    CollisionScene obstacles = new CollisionScene(List.of(randomBits(0.3)));
    OccupancyField kept = field(new Vec3(1, 1, 1));
    for (int n = 0; n < 2000; n++) {
      Vec3 at = new Vec3(within(), within(), within());
      OccupancyField fresh = field(new Vec3(1, 1, 1));
      for (OccupancyField field : List.of(kept, fresh)) {
        field.use(obstacles);
        field.seed(at.x, at.y, at.z);
        field.evaluate(at.x, at.y, at.z);
      }
      assertEquals(fresh.value, kept.value, "seed=" + SEED + " at " + at);
      assertEquals(fresh.gz, kept.gz, "seed=" + SEED + " at " + at);
      assertEquals(fresh.hxy, kept.hxy, "seed=" + SEED + " at " + at);
    }
  }

  @Test
  void derivativesAreThoseOfTheValue() {
    OccupancyField field = field(new Vec3(0.7, 1.4, 2.1));
    field.use(new CollisionScene(List.of(randomBits(0.3))));
    Vec3 edges = new Vec3(1, 2, 3);
    double h = 1e-5;
    for (int n = 0; n < 300; n++) {
      Vec3 at = awayFromHalves();
      field.seed(at.x, at.y, at.z);
      field.evaluate(at.x, at.y, at.z);
      double gx = field.gx;
      double gz = field.gz;
      double hzz = field.hzz;
      double hxy = field.hxy;
      field.evaluate(at.x + h, at.y, at.z);
      double right = field.value;
      field.evaluate(at.x - h, at.y, at.z);
      assertEquals((right - field.value) / (2 * h * edges.x), gx, 1e-6, "seed=" + SEED);
      field.evaluate(at.x, at.y, at.z + h);
      double up = field.gz;
      double upValue = field.value;
      field.evaluate(at.x, at.y, at.z - h);
      assertEquals((upValue - field.value) / (2 * h * edges.z), gz, 1e-6, "seed=" + SEED);
      assertEquals((up - field.gz) / (2 * h * edges.z), hzz, 1e-6, "seed=" + SEED);
      field.evaluate(at.x, at.y + h, at.z);
      double back = field.gx;
      field.evaluate(at.x, at.y - h, at.z);
      assertEquals((back - field.gx) / (2 * h * edges.y), hxy, 1e-6, "seed=" + SEED);
    }
  }

  @Test
  void aChangedVoxelIsSeenAfterForget() {
    BitCube bits = randomBits(0.1);
    CollisionScene obstacles = new CollisionScene(List.of(bits));
    OccupancyField field = field(new Vec3(1, 1, 1));
    field.use(obstacles);
    field.evaluate(15.2, 15.2, 15.2);
    double before = field.value;
    bits.set(15, 15, 16);
    bits.set(16, 15, 16);
    field.forget();
    field.evaluate(15.2, 15.2, 15.2);
    OccupancyField fresh = field(new Vec3(1, 1, 1));
    fresh.use(obstacles);
    fresh.evaluate(15.2, 15.2, 15.2);
    assertEquals(fresh.value, field.value);
    assertEquals(true, field.value > before);
  }

  private void compare(BitCube bits, Vec3 spacing, int[][] boxes) {
    CollisionScene obstacles = new CollisionScene(List.of(bits));
    OccupancyField field = field(spacing);
    field.use(obstacles);
    NaiveOccupancyField naive = new NaiveOccupancyField(obstacles, boxes);
    for (int n = 0; n < 60; n++) {
      Vec3 at = new Vec3(within(), within(), within());
      int[] seed = {
        (int) Math.floor(at.x + random.nextInt(7) - 3),
        (int) Math.floor(at.y + random.nextInt(7) - 3),
        (int) Math.floor(at.z + random.nextInt(7) - 3)
      };
      field.seed(seed[0] + 0.5, seed[1] + 0.5, seed[2] + 0.5);
      field.evaluate(at.x, at.y, at.z);
      assertEquals(
          naive.value(at.x, at.y, at.z, seed), field.value, 1e-12, "seed=" + SEED + " at " + at);
    }
  }

  private static OccupancyField field(Vec3 spacing) {
    double shortest = Math.min(spacing.x, Math.min(spacing.y, spacing.z));
    Vec3 edges = spacing.mul(1 / shortest, new Vec3());
    return new OccupancyField(
        new BinaryCoefficientSource(
            new SmoothingKernel(GridMetric.of(spacing), SmoothingKernel.FOR_BITS)),
        edges);
  }

  private BitCube randomBits(double share) {
    BitCube bits = new BitCube(27, 29, 31);
    for (int k = 0; k < 31; k++) {
      for (int j = 0; j < 29; j++) {
        for (int i = 0; i < 27; i++) {
          if (random.nextDouble() < share) {
            bits.set(i, j, k);
          }
        }
      }
    }
    return bits;
  }

  private double within() {
    return random.nextDouble() * 40 - 6;
  }

  /** A point whose neighbours at a small step lie in the same piece of the splines. */
  private Vec3 awayFromHalves() {
    return new Vec3(piece(), piece(), piece());
  }

  private double piece() {
    return random.nextInt(25) + 0.6 + 0.8 * random.nextDouble();
  }
}
