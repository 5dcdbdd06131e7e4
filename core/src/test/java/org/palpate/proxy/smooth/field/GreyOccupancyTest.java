package org.palpate.proxy.smooth.field;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.testing.RandomCases;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;
import org.palpate.volume.ScalarVolume;
import org.palpate.volume.ScalarVolume.Storage;
import org.palpate.volume.VoxelGrid;

/**
 * The field of grey values, with bits that contradict them, on grids that windows extend beyond.
 */
class GreyOccupancyTest {
  private static final long SEED = Seeds.seed();
  private static final int[] SIZES = {37, 29, 41};
  private static final double THRESHOLD = 90.5;
  private static final double CONTRAST = 40;
  private static final int[] ISOTROPIC = {4, 3};
  private static final GridMetric UNIT = new GridMetric(1, 1, 1);

  private final Random random = new Random(SEED);
  private final VoxelGrid grid = VoxelGrid.ofUnitVoxels(SIZES[0], SIZES[1], SIZES[2]);
  private final BitCube bits = new BitCube(SIZES[0], SIZES[1], SIZES[2]);
  private final CollisionScene scene = new CollisionScene(List.of(bits));

  @ParameterizedTest
  @EnumSource
  void equalsItsDefinition(Storage storage) {
    ScalarVolume volume = volume(storage, 0.05);
    compare(volume, UNIT, new int[][] {ISOTROPIC, ISOTROPIC, ISOTROPIC});
  }

  @ParameterizedTest
  @EnumSource
  void longerVoxelsGetNarrowerBoxes(Storage storage) {
    ScalarVolume volume = volume(storage, 0.05);
    compare(volume, new GridMetric(1.1, 1, 1.1), new int[][] {{4, 3}, ISOTROPIC, {4, 3}});
  }

  @ParameterizedTest
  @EnumSource
  void answersDoNotDependOnEarlierEvaluations(Storage storage) {
    compareWithFresh(volume(storage, 0.02), UNIT, 4000);
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2})
  void answersOnThinSlicesDoNotDependOnEarlierEvaluations(int axis) {
    Vec3 spacing = new Vec3(1, 1, 1);
    spacing.set(axis, 2.7);
    compareWithFresh(volume(Storage.INT16, 0.02), GridMetric.of(spacing), 600);
  }

  private void compareWithFresh(ScalarVolume volume, GridMetric metric, int evaluations) {
    OccupancyField used = field(volume, metric);
    Vec3 at = new Vec3(coordinate(), coordinate(), coordinate());
    for (int n = 0; n < RandomCases.of(evaluations); n++) {
      do {
        move(at);
      } while (isSolid(at)); // the cell of a seed is empty
      FieldSample fresh = field(volume, metric).evaluate(cell(at), at);
      FieldSample sample = used.evaluate(cell(at), at);
      String where = "seed=" + SEED + " n=" + n + " at " + at;
      assertEquals(fresh.occupancy(), sample.occupancy(), where);
      assertEquals(fresh.hxy(), sample.hxy(), where);
      if (n % 50 == 0) {
        edit(volume);
        used.forget();
      }
    }
  }

  @Test
  void evaluationsOnThinSlicesAllocateNothingEvenAfterEdits() {
    var threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    OccupancyField field = field(volume(Storage.INT16, 0.02), new GridMetric(1, 1, 3));
    Vec3 at = new Vec3(20, 20, 20);
    SeedCell seed = new SeedCell();
    evaluateAlongAWalk(field, at, seed, RandomCases.of(2000));
    long thread = Thread.currentThread().getId();
    long before = threads.getThreadAllocatedBytes(thread);
    evaluateAlongAWalk(field, at, seed, RandomCases.of(20_000));
    long allocated = threads.getThreadAllocatedBytes(thread) - before;
    assertTrue(allocated <= 200, "allocated=" + allocated);
  }

  private void evaluateAlongAWalk(OccupancyField field, Vec3 at, SeedCell seed, int evaluations) {
    for (int n = 0; n < evaluations; n++) {
      move(at);
      field.evaluate(seed.set(at), at);
      if (n % 50 == 0) {
        field.forget();
      }
    }
  }

  @Test
  void voxelsThatAreLongAlongOneAxisAreCutIntoThinSlices() {
    ScalarVolume volume = volume(Storage.INT16, 0.02);
    for (double ratio : new double[] {1.2, 1.5, 2, 3, 3.7, 5, 10}) {
      for (int axis = 0; axis < 3; axis++) {
        Vec3 spacing = new Vec3(1, 1, 1);
        spacing.set(axis, ratio);
        compareThin(volume, GridMetric.of(spacing));
      }
    }
  }

  @Test
  void voxelsThatAreLongAlongTwoAxesAreCutAlongBoth() {
    ScalarVolume volume = volume(Storage.INT16, 0.02);
    for (int axis = 0; axis < 3; axis++) {
      Vec3 spacing = new Vec3(2, 2, 2);
      spacing.set(axis, 1);
      compareThin(volume, GridMetric.of(spacing));
      spacing.set((axis + 1) % 3, 1.3);
      compareThin(volume, GridMetric.of(spacing));
    }
  }

  private void compareThin(ScalarVolume volume, GridMetric metric) {
    Vec3 edges = OccupancyField.edges(metric);
    ThinGrid grid = ThinGrid.ofGrey(edges);
    int[][] boxes = {ISOTROPIC, ISOTROPIC, ISOTROPIC};
    NaiveOccupancyField naive =
        new NaiveOccupancyField(
            NaiveThinSlices.of(scene::isSolid, grid, edges),
            boxes,
            (x, y, z, isSolid) -> thin(volume, grid, grid.cuts().size(), new int[] {x, y, z}));
    OccupancyField field = field(volume, metric);
    for (int n = 0; n < RandomCases.of(12); n++) {
      Vec3 at = new Vec3(coordinate(), coordinate(), coordinate());
      Vec3 inCells =
          new Vec3(grid.perVoxel(0) * at.x, grid.perVoxel(1) * at.y, grid.perVoxel(2) * at.z);
      assertEquals(
          naive.occupancy(inCells, NaiveThinSlices.seeds(at, grid)),
          field.evaluate(cell(at), at).occupancy(),
          2e-3, // cells are rounded to 1/255 by each cut
          "seed=" + SEED + " " + grid + " at " + at);
    }
  }

  /**
   * Returns the occupancy of a cell by definition: of the parts of one or two voxels, each solid
   * from the side of its more solid neighbour, as far as the neighbours differ, and else evenly.
   * With two cuts the voxels of the second are the cells of the first.
   *
   * @param count the number of cuts that made the cell
   */
  private double thin(ScalarVolume volume, ThinGrid grid, int count, int[] cell) {
    if (count == 0) {
      boolean isSolid = scene.isSolid(cell[0], cell[1], cell[2]);
      return occupancy(volume, cell[0], cell[1], cell[2], isSolid);
    }
    AxisCut cut = grid.cuts().get(count - 1);
    double low = cell[cut.axis()] / cut.perVoxel();
    double high = (cell[cut.axis()] + 1) / cut.perVoxel();
    double sum = 0;
    for (int k = (int) Math.floor(low); k < high; k++) {
      double before = thin(volume, grid, count - 1, at(cell, cut, k - 1));
      double whole = thin(volume, grid, count - 1, at(cell, cut, k));
      double behind = thin(volume, grid, count - 1, at(cell, cut, k + 1));
      double from = Math.max(low, k);
      double to = Math.min(high, k + 1);
      double solidFrom = before > behind ? k : k + 1 - whole;
      double solidTo = before > behind ? k + whole : k + 1;
      double solid = Math.max(0, Math.min(to, solidTo) - Math.max(from, solidFrom));
      double directed = Math.abs(before - behind);
      sum += directed * solid + (1 - directed) * whole * Math.max(0, to - from);
    }
    return sum * cut.perVoxel();
  }

  private static int[] at(int[] cell, AxisCut cut, int k) {
    int[] voxel = cell.clone();
    voxel[cut.axis()] = k;
    return voxel;
  }

  /** Moves by one or a few voxels along some axes, and now and then far away. */
  private void move(Vec3 at) {
    double step = random.nextInt(100) == 0 ? 30 : random.nextInt(10) == 0 ? 6 : 1.5;
    at.set(moved(at.x, step), moved(at.y, step), moved(at.z, step));
  }

  private double moved(double from, double step) {
    return Math.max(-8, Math.min(48, from + step * (2 * random.nextDouble() - 1)));
  }

  private boolean isSolid(Vec3 at) {
    return scene.isSolid((int) Math.floor(at.x), (int) Math.floor(at.y), (int) Math.floor(at.z));
  }

  private void compare(ScalarVolume volume, GridMetric metric, int[][] boxes) {
    OccupancyField field = field(volume, metric);
    NaiveOccupancyField naive =
        new NaiveOccupancyField(
            scene::isSolid, boxes, (i, j, k, isSolid) -> occupancy(volume, i, j, k, isSolid));
    for (int n = 0; n < RandomCases.of(60); n++) {
      Vec3 at = new Vec3(coordinate(), coordinate(), coordinate());
      int[] seed = {(int) Math.floor(at.x), (int) Math.floor(at.y), (int) Math.floor(at.z)};
      assertEquals(
          naive.occupancy(at, seed),
          field.evaluate(cell(at), at).occupancy(),
          1e-12,
          "seed=" + SEED + " at " + at);
    }
  }

  /**
   * Returns the occupancy of a voxel by definition, in steps of 1/255 rounded down; the half step
   * more makes the threshold itself solid.
   */
  private double occupancy(ScalarVolume volume, int i, int j, int k, boolean isSolid) {
    double value = grid.contains(i, j, k) ? volume.value(i, j, k) : Double.NaN;
    if (value >= THRESHOLD != isSolid) {
      return isSolid ? 1 : 0;
    }
    double levels = Math.floor(128 + 127.5 * (value - THRESHOLD) / CONTRAST + 1e-9);
    return Double.isNaN(value) ? 0 : Math.max(0, Math.min(255, levels)) / 255;
  }

  /** Makes waves of grey values with the bits of their threshold, a fraction of them flipped. */
  private ScalarVolume volume(Storage storage, double flipped) {
    ScalarVolume volume = ScalarVolume.of(grid, storage);
    for (int k = 0; k < SIZES[2]; k++) {
      for (int j = 0; j < SIZES[1]; j++) {
        for (int i = 0; i < SIZES[0]; i++) {
          double wave = Math.sin(0.4 * i) + Math.sin(0.3 * j + 1) + Math.sin(0.5 * k + 2);
          volume.set(i, j, k, Math.rint(100 + 40 * wave + 10 * random.nextDouble()));
          if (volume.value(i, j, k) >= THRESHOLD != random.nextDouble() < flipped) {
            bits.set(i, j, k);
          }
        }
      }
    }
    return volume;
  }

  /** Flips one bit and changes one grey value. */
  private void edit(ScalarVolume volume) {
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

  private static SeedCell cell(Vec3 position) {
    return new SeedCell().set(position);
  }

  private OccupancyField field(ScalarVolume volume, GridMetric metric) {
    GreyIsosurface grey = new GreyIsosurface(volume, THRESHOLD, CONTRAST);
    OccupancyField field = OccupancyField.ofGrey(metric, new GreyIsosurfaceSource(grey));
    field.use(scene);
    return field;
  }

  private double coordinate() {
    return random.nextDouble() * 50 - 6;
  }
}
