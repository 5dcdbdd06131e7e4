package org.palpate.proxy.smooth.field;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;
import org.palpate.volume.ScalarVolume;
import org.palpate.volume.ScalarVolume.Storage;
import org.palpate.volume.VoxelGrid;

/** The field of grey values, with edits against them, on grids that windows stick out of. */
class GreyOccupancyTest {
  private static final long SEED = Seeds.seed();
  private static final int[] SIZES = {37, 29, 41};
  private static final double THRESHOLD = 90.5;
  private static final double CONTRAST = 40;
  private static final int[] ISOTROPIC = {4, 3};

  private final Random random = new Random(SEED);
  private final VoxelGrid grid = VoxelGrid.ofUnitVoxels(SIZES[0], SIZES[1], SIZES[2]);
  private final BitCube bits = new BitCube(SIZES[0], SIZES[1], SIZES[2]);
  private final CollisionScene obstacles = new CollisionScene(List.of(bits));

  @ParameterizedTest
  @EnumSource
  void equalsItsDefinition(Storage storage) {
    OccupancyField field = field(volume(storage, 0.05), new Vec3(1, 1, 1));
    compare(field, new int[][] {ISOTROPIC, ISOTROPIC, ISOTROPIC});
  }

  @ParameterizedTest
  @EnumSource
  void longerVoxelsGetNarrowerBoxes(Storage storage) {
    OccupancyField field = field(volume(storage, 0.05), new Vec3(2, 1, 1));
    compare(field, new int[][] {{2, 1}, ISOTROPIC, ISOTROPIC});
  }

  @ParameterizedTest
  @EnumSource
  void answersAlikeWhateverWasAskedBefore(Storage storage) {
    ScalarVolume volume = volume(storage, 0.02);
    OccupancyField kept = field(volume, new Vec3(1, 1, 1));
    Vec3 at = new Vec3(within(), within(), within());
    for (int n = 0; n < 4000; n++) {
      do {
        move(at);
      } while (isSolid(at)); // the cell of a seed is empty
      OccupancyField fresh = field(volume, new Vec3(1, 1, 1));
      for (OccupancyField field : List.of(kept, fresh)) {
        field.seed(at.x, at.y, at.z);
        field.evaluate(at.x, at.y, at.z);
      }
      assertEquals(fresh.value, kept.value, "seed=" + SEED + " n=" + n + " at " + at);
      assertEquals(fresh.hxy, kept.hxy, "seed=" + SEED + " n=" + n + " at " + at);
      if (n % 50 == 0) {
        flip(volume);
        kept.forget();
      }
    }
  }

  /** A step or a few along some axes, now and then to somewhere else. */
  private void move(Vec3 at) {
    double step = random.nextInt(100) == 0 ? 30 : random.nextInt(10) == 0 ? 6 : 1.5;
    at.set(moved(at.x, step), moved(at.y, step), moved(at.z, step));
  }

  private double moved(double from, double step) {
    return Math.max(-8, Math.min(48, from + step * (2 * random.nextDouble() - 1)));
  }

  private boolean isSolid(Vec3 at) {
    return obstacles.isSolid(
        (int) Math.floor(at.x), (int) Math.floor(at.y), (int) Math.floor(at.z));
  }

  private void compare(OccupancyField field, int[][] boxes) {
    NaiveOccupancyField naive = new NaiveOccupancyField(obstacles, boxes, this::share);
    for (int n = 0; n < 60; n++) {
      Vec3 at = new Vec3(within(), within(), within());
      int[] seed = {(int) Math.floor(at.x), (int) Math.floor(at.y), (int) Math.floor(at.z)};
      field.seed(at.x, at.y, at.z);
      field.evaluate(at.x, at.y, at.z);
      assertEquals(
          naive.value(at.x, at.y, at.z, seed), field.value, 1e-12, "seed=" + SEED + " at " + at);
    }
  }

  private ScalarVolume kept;

  /**
   * By definition: to the level in 255 below, but half of one more, so that 0.5 is in the middle.
   */
  private double share(int i, int j, int k, boolean isSolid) {
    double value = grid.contains(i, j, k) ? kept.value(i, j, k) : Double.NaN;
    if (value >= THRESHOLD != isSolid) {
      return isSolid ? 1 : 0;
    }
    double levels = Math.floor(128 + 127.5 * (value - THRESHOLD) / CONTRAST + 1e-9);
    return Double.isNaN(value) ? 0 : Math.max(0, Math.min(255, levels)) / 255;
  }

  /** Waves of values with their threshold's bits, and some bits flipped. */
  private ScalarVolume volume(Storage storage, double flips) {
    ScalarVolume volume = ScalarVolume.of(grid, storage);
    for (int k = 0; k < SIZES[2]; k++) {
      for (int j = 0; j < SIZES[1]; j++) {
        for (int i = 0; i < SIZES[0]; i++) {
          double wave = Math.sin(0.4 * i) + Math.sin(0.3 * j + 1) + Math.sin(0.5 * k + 2);
          volume.set(i, j, k, Math.rint(100 + 40 * wave + 10 * random.nextDouble()));
          if (volume.value(i, j, k) >= THRESHOLD != random.nextDouble() < flips) {
            bits.set(i, j, k);
          }
        }
      }
    }
    kept = volume;
    return volume;
  }

  private void flip(ScalarVolume volume) {
    int i = random.nextInt(SIZES[0]);
    int j = random.nextInt(SIZES[1]);
    int k = random.nextInt(SIZES[2]);
    if (bits.get(i, j, k)) {
      bits.clear(i, j, k);
    } else {
      bits.set(i, j, k);
    }
    volume.set(random.nextInt(SIZES[0]), j, k, 255 * random.nextDouble());
  }

  private OccupancyField field(ScalarVolume volume, Vec3 spacing) {
    GreyIsosurfaceSource grey =
        new GreyIsosurfaceSource(new GreyIsosurface(volume, THRESHOLD, CONTRAST));
    Vec3 edges = spacing.mul(1 / Math.min(spacing.x, spacing.y), new Vec3());
    OccupancyField field =
        new OccupancyField(
            new GreyCoefficientSource(
                new SmoothingKernel(GridMetric.of(spacing), SmoothingKernel.FOR_GREY), grey),
            edges);
    field.use(obstacles);
    return field;
  }

  private double within() {
    return random.nextDouble() * 50 - 6;
  }
}
