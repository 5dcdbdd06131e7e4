package org.palpate.proxy.smooth.field;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
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

  /** The first voxel along x where all grey values are the same. */
  private static final int EVEN_FROM = 30;

  private static final int[] ISOTROPIC = {4, 3};
  private static final GridMetric UNIT = new GridMetric(1, 1, 1);

  /** The weights of three voxels side by side. */
  private static final int[] WEIGHTS = {1, 2, 1};

  /** The error of a level from the ramps of voxels, which are kept as floats. */
  private static final double OF_SINGLE_PRECISION = 1e-3;

  /** The cells along x between blocks of cells that share a slot, see {@link CacheKeys}. */
  private static final int SAME_SLOT_X = 128;

  /** The cells along z between them. */
  private static final int SAME_SLOT_Z = 72;

  private final Random random = new Random(SEED);

  /** The voxels, and the cells after one and two cuts. */
  private final List<GreyOccupancyCache.Source> sources = new ArrayList<>();

  /** The occupancies of the voxels and cells of one grid that were checked. */
  private final Map<String, Double> thinCells = new HashMap<>();

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

  /**
   * Places that lie {@link #SAME_SLOT_X} and {@link #SAME_SLOT_Z} cells apart take blocks of the
   * cache from each other.
   */
  @ParameterizedTest
  @ValueSource(doubles = {1, 2})
  void answersDoNotDependOnEvaluationsOfCellsWithTheSameSlots(double z) {
    GridMetric metric = new GridMetric(1, 1, z);
    VoxelGrid wide = VoxelGrid.ofUnitVoxels(SAME_SLOT_X + 40, 30, SAME_SLOT_Z + 40);
    ScalarVolume volume = ScalarVolume.of(wide, Storage.INT16);
    BitCube solids = new BitCube(wide.sizeX(), wide.sizeY(), wide.sizeZ());
    for (int k = 0; k < wide.sizeZ(); k++) {
      for (int j = 0; j < wide.sizeY(); j++) {
        for (int i = 0; i < wide.sizeX(); i++) {
          double wave = Math.sin(0.4 * i) + Math.sin(0.3 * j + 1) + Math.sin(0.5 * k + 2);
          volume.set(i, j, k, Math.rint(100 + 40 * wave));
          if (volume.value(i, j, k) >= THRESHOLD) {
            solids.set(i, j, k);
          }
        }
      }
    }
    CollisionScene both = new CollisionScene(List.of(solids));
    OccupancyField used = field(volume, metric);
    used.use(both);
    for (int n = 0; n < RandomCases.of(50); n++) {
      double x = 4 + 30 * random.nextDouble();
      double y = 4 + 20 * random.nextDouble();
      double height = 4 + 30 * random.nextDouble();
      for (int side = 0; side < 2; side++) {
        Vec3 at = new Vec3(x + side * SAME_SLOT_X, y, height + side * SAME_SLOT_Z / z);
        OccupancyField fresh = field(volume, metric);
        fresh.use(both);
        String where = "seed=" + SEED + " at " + at;
        assertEquals(
            fresh.evaluate(cell(at), at).occupancy(),
            used.evaluate(cell(at), at).occupancy(),
            where);
        assertEquals(fresh.sample().gx(), used.sample().gx(), where);
      }
    }
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

  /** Compares cells with their definition, and the field with the sum of these cells. */
  private void compareThin(ScalarVolume volume, GridMetric metric) {
    Vec3 edges = OccupancyField.edges(metric);
    ThinGrid grid = ThinGrid.ofGrey(edges);
    sources.clear();
    sources.add(new GreyVoxels(source(volume)));
    for (AxisCut cut : grid.cuts()) {
      sources.add(new ThinOccupancies(cut, sources.get(sources.size() - 1)));
    }
    int[][] boxes = {ISOTROPIC, ISOTROPIC, ISOTROPIC};
    NaiveOccupancyField naive =
        new NaiveOccupancyField(
            NaiveThinSlices.of(scene::isSolid, grid, edges),
            boxes,
            (x, y, z, isSolid) -> thin(volume, grid, grid.cuts().size(), new int[] {x, y, z}));
    OccupancyField field = field(volume, metric);
    thinCells.clear();
    for (int n = 0; n < RandomCases.of(12); n++) {
      Vec3 at = new Vec3(coordinate(), coordinate(), coordinate());
      Vec3 inCells =
          new Vec3(grid.perVoxel(0) * at.x, grid.perVoxel(1) * at.y, grid.perVoxel(2) * at.z);
      assertEquals(
          naive.occupancy(inCells, NaiveThinSlices.seeds(at, grid)),
          field.evaluate(cell(at), at).occupancy(),
          1e-12,
          "seed=" + SEED + " " + grid + " at " + at);
    }
  }

  /**
   * Returns the occupancy of a cell after checking it against its definition: the parts of one or
   * two voxels, each solid as far as a plane leaves it, rounded to a level. With two cuts the
   * voxels of the second are the cells of the first.
   *
   * @param count the number of cuts that made the cell
   */
  private double thin(ScalarVolume volume, ThinGrid grid, int count, int[] cell) {
    String key = count + " " + cell[0] + " " + cell[1] + " " + cell[2];
    Double known = thinCells.get(key);
    if (known != null) {
      return known;
    }
    double level = level(count, cell);
    double expected =
        count == 0
            ? 255 * occupancy(volume, cell[0], cell[1], cell[2], isSolid(cell))
            : 255 * solid(volume, grid, count, cell) * grid.cuts().get(count - 1).perVoxel();
    double rounding = count == 0 ? 1e-9 : 0.5 + OF_SINGLE_PRECISION;
    assertEquals(expected, level, rounding, "seed=" + SEED + " " + grid + " cell " + key);
    thinCells.put(key, level / 255);
    return level / 255;
  }

  /** Returns the level of a cell after some cuts, from 0 to 255. */
  private double level(int count, int[] cell) {
    long word = sources.get(count).occupancies(scene, cell[0] >> 3, cell[1], cell[2]);
    return (word >>> (Byte.SIZE * (cell[0] & 7))) & 0xFF;
  }

  private boolean isSolid(int[] voxel) {
    return scene.isSolid(voxel[0], voxel[1], voxel[2]);
  }

  /** Returns the length of the solid in a cell, in voxels. */
  private double solid(ScalarVolume volume, ThinGrid grid, int count, int[] cell) {
    AxisCut cut = grid.cuts().get(count - 1);
    double low = cell[cut.axis()] / cut.perVoxel();
    double high = (cell[cut.axis()] + 1) / cut.perVoxel();
    double sum = 0;
    for (int k = (int) Math.floor(low); k < high; k++) {
      double[] part = {Math.max(low, k) - k, Math.min(high, k + 1) - k};
      sum += solidPart(volume, grid, count - 1, at(cell, cut, k), part);
    }
    return sum;
  }

  /** Returns the solid of a part of a voxel, from its lower end. */
  private double solidPart(
      ScalarVolume volume, ThinGrid grid, int count, int[] voxel, double[] part) {
    double whole = thin(volume, grid, count, voxel);
    if (whole == 0 || whole == 1) {
      return whole * Math.max(0, part[1] - part[0]);
    }
    int axis = grid.cuts().get(count).axis();
    double[] gradient = new double[3];
    for (int n = 0; n < 27; n++) {
      int[] d = {n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1};
      double value =
          thin(volume, grid, count, new int[] {voxel[0] + d[0], voxel[1] + d[1], voxel[2] + d[2]});
      for (int a = 0; a < 3; a++) {
        gradient[a] += d[a] * WEIGHTS[d[(a + 1) % 3] + 1] * WEIGHTS[d[(a + 2) % 3] + 1] * value;
      }
    }
    boolean solidBelow = gradient[axis] < -1e-9;
    double across = Math.hypot(gradient[(axis + 1) % 3], gradient[(axis + 2) % 3]);
    double slope = Math.abs(gradient[axis]);
    double width = slope < 1e-9 ? 64 : Math.max(1e-3, Math.min(64, across / slope));
    double middle = middleByBisection(whole, width);
    double ofRow = Math.max(0, Math.min(1, 1.5 - width));
    double inRow = middleInRow(volume, grid, count, voxel, axis, solidBelow ? 1 : -1);
    middle += Double.isNaN(inRow) ? 0 : ofRow * (inRow - middle);
    double from = solidBelow ? part[0] : 1 - part[1];
    double to = solidBelow ? part[1] : 1 - part[0];
    return solidOfRamp(from, to, middle, width);
  }

  /** Returns where a ramp ends whose voxels in a row hold as much solid together; NaN if none. */
  private double middleInRow(
      ScalarVolume volume, ThinGrid grid, int count, int[] voxel, int axis, int up) {
    double[] row = new double[9];
    for (int n = -4; n <= 4; n++) {
      int[] other = voxel.clone();
      other[axis] += n * up;
      row[n + 4] = thin(volume, grid, count, other);
    }
    int first = 4;
    int last = 4;
    while (first > 0 && row[first] < 1 && row[first - 1] >= row[first]) {
      first--;
    }
    while (last < 8 && row[last] > 0 && row[last + 1] <= row[last]) {
      last++;
    }
    double sum = first - 4;
    for (int n = first; n <= last; n++) {
      sum += row[n];
    }
    return row[first] == 1 && row[last] == 0 ? sum : Double.NaN;
  }

  private static double middleByBisection(double fraction, double width) {
    double low = -width;
    double high = 1 + width;
    for (int n = 0; n < 60; n++) {
      double middle = (low + high) / 2;
      if (solidOfRamp(0, 1, middle, width) < fraction) {
        low = middle;
      } else {
        high = middle;
      }
    }
    return low;
  }

  /** Returns the integral of the ramp's solid fraction, by its three pieces. */
  private static double solidOfRamp(double from, double to, double middle, double width) {
    double start = Math.max(from, Math.min(to, middle - width / 2));
    double end = Math.max(from, Math.min(to, middle + width / 2));
    double atStart = 0.5 + (middle - start) / width;
    double atEnd = 0.5 + (middle - end) / width;
    return start - from + (end - start) * (atStart + atEnd) / 2;
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

  /**
   * Makes waves of grey values, even behind them, with the bits of their threshold, a fraction of
   * them flipped.
   */
  private ScalarVolume volume(Storage storage, double flipped) {
    ScalarVolume volume = ScalarVolume.of(grid, storage);
    for (int k = 0; k < SIZES[2]; k++) {
      for (int j = 0; j < SIZES[1]; j++) {
        for (int i = 0; i < SIZES[0]; i++) {
          double wave = Math.sin(0.4 * i) + Math.sin(0.3 * j + 1) + Math.sin(0.5 * k + 2);
          boolean isEven = i >= EVEN_FROM;
          double value = isEven ? 100 : Math.rint(100 + 40 * wave + 10 * random.nextDouble());
          volume.set(i, j, k, value);
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
    OccupancyField field = OccupancyField.ofGrey(metric, source(volume));
    field.use(scene);
    return field;
  }

  private static GreyIsosurfaceSource source(ScalarVolume volume) {
    return new GreyIsosurfaceSource(new GreyIsosurface(volume, THRESHOLD, CONTRAST));
  }

  private double coordinate() {
    return random.nextDouble() * 50 - 6;
  }
}
