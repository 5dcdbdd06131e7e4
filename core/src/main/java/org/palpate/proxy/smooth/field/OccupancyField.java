package org.palpate.proxy.smooth.field;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.Vec3;

/**
 * The occupancy field of a scene: 0 in empty space, 1 deep inside a solid, about a half at its
 * surface.
 *
 * <p>The field is a sum of quadratic B-splines over box-filtered voxels, see {@link
 * SmoothingKernel}. Each evaluation uses a window of voxels around the grid corner nearest to the
 * point. The field is twice differentiable while the nearest corner stays the same. Each evaluation
 * also has a seed, a cell from which a flood fill by faces starts. Empty voxels of the window that
 * the fill does not reach count as solid. A wall one voxel thick thus looks like a half space from
 * either side.
 *
 * <p>For a given scene, seed cell and point the answer is the same to the last bit, whatever was
 * evaluated before. The caches only save time.
 *
 * <p>Belongs to the haptic thread; an evaluation allocates nothing. Cost: 27 splines, and a window
 * with its flood fill if the nearest corner is another one than before.
 */
public final class OccupancyField {
  /** The greatest coordinate at which the field can be evaluated. */
  private static final double FARTHEST = 1e8;

  private static final int COEFFICIENTS = 27;

  /**
   * The greatest offset of the isosurface, in standard deviations of the smoothing. Farther out,
   * the flat field would harm the force more than voxels that stand out of the isosurface.
   */
  private static final double MAX_DEVIATIONS_OF_BITS = 1.93;

  /** The same for grey values, whose smoothing is narrower. */
  private static final double MAX_DEVIATIONS_OF_GREY = 1.7;

  /** From bits no isosurface is far: nearer levels show more of the steps between long voxels. */
  private static final double FAR_DEVIATIONS_OF_BITS = Double.POSITIVE_INFINITY;

  /** The offset beyond which the isosurface of grey values is far, see {@link IsoLevel#isFar}. */
  private static final double FAR_DEVIATIONS_OF_GREY = 1.4;

  private final BrickSource cells;
  private final CoefficientSource source;
  private final BrickCopy.Ahead bricksAhead;
  private final IsoLevel level;
  private final FieldSample sample;
  private final double cellsX;
  private final double cellsY;
  private final double cellsZ;
  private final double inverseX;
  private final double inverseY;
  private final double inverseZ;

  /** The B-spline coefficients at the 27 corners around the nearest corner, x fastest. */
  private final double[] coefficients = new double[COEFFICIENTS];

  private CollisionScene scene;
  private int cornerX;
  private int cornerY;
  private int cornerZ;
  private boolean anySolid;
  private long windowReads;

  /** Whether the coefficients hold for the scene as it is. */
  private boolean loaded;

  private final SeedCell lastSeed = new SeedCell();
  private final Vec3 lastPoint = new Vec3();

  /** The changed voxels, then the cells that depend on them: scratch. */
  private final IntBox changed = new IntBox();

  /**
   * Creates a field over any coefficients.
   *
   * @param grid the cells to whose corners the coefficients belong
   * @param cells gives their bits
   * @param edges the edges of a voxel along x, y and z, in shortest edges: at least 1
   * @param maxDeviations the greatest offset of the isosurface, see {@link IsoLevel}
   * @param farDeviations the offset beyond which it is far, see {@link IsoLevel}
   */
  private OccupancyField(
      ThinGrid grid,
      BrickSource cells,
      CoefficientSource source,
      Vec3 edges,
      double maxDeviations,
      double farDeviations) {
    this.cells = cells;
    this.source = source;
    bricksAhead = new BrickCopy.Ahead(cells);
    cellsX = grid.perVoxel(0);
    cellsY = grid.perVoxel(1);
    cellsZ = grid.perVoxel(2);
    inverseX = cellsX / edges.x;
    inverseY = cellsY / edges.y;
    inverseZ = cellsZ / edges.z;
    level = new IsoLevel(source, edges, maxDeviations, farDeviations);
    sample = new FieldSample(level);
  }

  /** Creates a field over the same coefficients that remembers some of them. */
  private OccupancyField(OccupancyField field) {
    cells = field.cells;
    source = new KeptCoefficients(field.source);
    bricksAhead = field.bricksAhead;
    cellsX = field.cellsX;
    cellsY = field.cellsY;
    cellsZ = field.cellsZ;
    inverseX = field.inverseX;
    inverseY = field.inverseY;
    inverseZ = field.inverseZ;
    level = field.level;
    sample = field.sample;
  }

  /**
   * {@return this field with a memory for many places that are evaluated in turn} This one must not
   * be used any more.
   */
  public OccupancyField forManyPlaces() {
    return new OccupancyField(this);
  }

  /**
   * {@return a field that is made from the voxels' bits alone}
   *
   * @param metric the edges of a voxel
   */
  public static OccupancyField ofBits(GridMetric metric) {
    return ofBits(metric, false);
  }

  /**
   * {@return a field that is made from the voxels' bits alone, with wide terraces interpolated, see
   * {@link Terraces}} It is made for a point that slides: an evaluation far from the last one looks
   * for terraces all around. Voxels that are cut along two axes keep their terraces, whose cells
   * would take too long to make.
   *
   * @param metric the edges of a voxel
   */
  public static OccupancyField ofBitsOverTerraces(GridMetric metric) {
    return ofBits(metric, true);
  }

  private static OccupancyField ofBits(GridMetric metric, boolean interpolatesTerraces) {
    Vec3 edges = edges(metric);
    ThinGrid grid = ThinGrid.ofBits(edges);
    SmoothingKernel kernel = SmoothingKernel.forBits(grid, edges);
    ThinSlices thin = thin(grid, edges, true);
    BrickSource cells = cells(thin);
    BinaryWindow window = new BinaryWindow(grid, cells);
    List<CellCorrections.Source> corrections = new ArrayList<>();
    if (thin != null) {
      corrections.add(thin);
    }
    if (interpolatesTerraces && grid.cuts().size() < 2) {
      corrections.add(
          thin == null
              ? Terraces.ofVoxels(window.copy(), edges)
              : new Terraces(grid, thin, window.copy(), edges));
    }
    return new OccupancyField(
        grid,
        cells,
        new BinaryCoefficientSource(kernel, window, corrections),
        edges,
        MAX_DEVIATIONS_OF_BITS,
        FAR_DEVIATIONS_OF_BITS);
  }

  /**
   * {@return a field that is made from grey values, and from the bits where they disagree}
   *
   * @param metric the edges of a voxel
   * @param grey the grey values; after they change, call {@link #forget}
   */
  public static OccupancyField ofGrey(GridMetric metric, GreyIsosurfaceSource grey) {
    Vec3 edges = edges(metric);
    ThinGrid grid = ThinGrid.ofGrey(edges);
    SmoothingKernel kernel = SmoothingKernel.forGrey(grid, edges);
    BrickSource cells = cells(thin(grid, edges, false));
    BinaryWindow window = new BinaryWindow(grid, cells);
    return new OccupancyField(
        grid,
        cells,
        new GreyCoefficientSource(kernel, grid, cells, window, grey),
        edges,
        MAX_DEVIATIONS_OF_GREY,
        FAR_DEVIATIONS_OF_GREY);
  }

  /** Returns the thin slices of a grid, or null if its cells are voxels. */
  private static ThinSlices thin(ThinGrid grid, Vec3 edges, boolean corrects) {
    return grid.isWhole() ? null : ThinSlices.of(grid, edges, corrects);
  }

  private static BrickSource cells(ThinSlices thin) {
    return thin == null ? BrickSource.VOXELS : thin;
  }

  /** Returns the edges of a voxel, in shortest edges. */
  static Vec3 edges(GridMetric metric) {
    double shortest = metric.shortestEdgeMm();
    return new Vec3(
        metric.spacingX() / shortest, metric.spacingY() / shortest, metric.spacingZ() / shortest);
  }

  /**
   * Sets the scene; forgets the cached voxels if it is another one than before.
   *
   * @param newScene the solids, on a grid with the metric of the field
   */
  public void use(CollisionScene newScene) {
    if (scene != newScene) {
      scene = newScene;
      forget();
    }
  }

  /** Forgets all cached voxels; to be called after voxels or grey values changed. */
  public void forget() {
    loaded = false;
    source.forget();
    bricksAhead.forget();
  }

  /**
   * Forgets what depends on some voxels; to be called after their solids changed, and no grey
   * value. The answers are the same as after {@link #forget()}, but what is out of reach stays.
   *
   * @param voxels a box around the changed voxels, not empty
   */
  public void forget(IntBox voxels) {
    loaded = false;
    source.forget(changed.set(voxels));
    bricksAhead.forget();
  }

  /** {@return the isosurface that samples refer to} */
  public IsoLevel level() {
    return level;
  }

  /** {@return the sample that evaluations write, as the last one left it} */
  public FieldSample sample() {
    return sample;
  }

  /**
   * {@return how many windows of voxels were read so far, or taken from the memory of a field
   * {@link #forManyPlaces}; reading is most of the cost}
   */
  public long windowReads() {
    return windowReads;
  }

  /**
   * {@return how many columns were interpolated so far between thick slices, or on wide terraces}
   * Each takes several times as long as an evaluation.
   */
  public long interpolatedColumns() {
    return source.columns();
  }

  /** {@return whether the field interpolates cells between slices, so that reading ahead helps} */
  public boolean interpolatesSlices() {
    return cells != BrickSource.VOXELS;
  }

  /**
   * Reads a little of the voxels around a point that may be evaluated later. No answer changes.
   * Cost: at most a few bricks, or some columns between slices.
   *
   * @param point grid coordinates; beyond {@link #FARTHEST} nothing is read
   */
  public void readAhead(Vec3 point) {
    double farthest = Math.max(Math.abs(point.x), Math.max(Math.abs(point.y), Math.abs(point.z)));
    if (farthest <= FARTHEST) {
      bricksAhead.make(
          scene,
          (int) Math.floor(cellsX * point.x + 0.5),
          (int) Math.floor(cellsY * point.y + 0.5),
          (int) Math.floor(cellsZ * point.z + 0.5));
    }
  }

  /**
   * {@return whether a point lies in a solid cell} Cells are voxels, or thin slices of long voxels,
   * which may be solid within an empty voxel.
   *
   * @param point the point, grid coordinates
   */
  public boolean isSolid(Vec3 point) {
    return cells.isSolid(
        scene,
        (int) Math.floor(cellsX * point.x),
        (int) Math.floor(cellsY * point.y),
        (int) Math.floor(cellsZ * point.z));
  }

  /**
   * Evaluates the field.
   *
   * @param seed the cell from which empty space is reached; if it is solid or outside the window,
   *     all empty voxels count as reached
   * @param point where to evaluate, grid coordinates, at most {@link #FARTHEST}
   * @return the sample that this field owns; the next evaluation overwrites it
   */
  public FieldSample evaluate(SeedCell seed, Vec3 point) {
    if (!(loaded && lastSeed.isSame(seed) && isLastPoint(point))) {
      evaluateAnew(seed, point);
    }
    return sample;
  }

  private boolean isLastPoint(Vec3 point) {
    return point.x == lastPoint.x && point.y == lastPoint.y && point.z == lastPoint.z;
  }

  /**
   * Evaluates the field at another point or from another seed.
   *
   * <p>The steps are written out on purpose. They make this method just too large to be inlined, so
   * the JIT compiles it once and whole. If it is inlined at each evaluation, the inlining of a
   * frame ends halfway, and {@code ResponseBenchmark} takes 7 % longer on slow slides.
   */
  private void evaluateAnew(SeedCell seed, Vec3 point) {
    lastSeed.set(seed);
    double inCellsX = cellsX * point.x;
    double inCellsY = cellsY * point.y;
    double inCellsZ = cellsZ * point.z;
    double nearX = inCellsX + 0.5;
    double nearY = inCellsY + 0.5;
    double nearZ = inCellsZ + 0.5;
    int x = (int) nearX;
    int y = (int) nearY;
    int z = (int) nearZ;
    x = nearX < x ? x - 1 : x;
    y = nearY < y ? y - 1 : y;
    z = nearZ < z ? z - 1 : z;
    boolean kept =
        loaded && x == cornerX && y == cornerY && z == cornerZ && source.holdsFor(lastSeed);
    if (!kept) {
      windowReads++;
      anySolid = source.load(scene, x, y, z, lastSeed, coefficients);
      cornerX = x;
      cornerY = y;
      cornerZ = z;
      loaded = true;
    }
    boolean samePoint = point.x == lastPoint.x && point.y == lastPoint.y && point.z == lastPoint.z;
    if (!(kept && samePoint)) {
      lastPoint.set(point.x, point.y, point.z);
      sample.clear();
      if (anySolid) {
        sum(inCellsX - x, inCellsY - y, inCellsZ - z);
      }
    }
  }

  /**
   * Sums the tensor-product splines, along x first; (u,v,w) is the point less the nearest corner,
   * from -0.5 to 0.5. Of each row, r is the value, s its first and q its second derivative along x.
   */
  private void sum(double u, double v, double w) {
    double x0 = 0.5 * (0.5 - u) * (0.5 - u);
    double x1 = 0.75 - u * u;
    double x2 = 0.5 * (0.5 + u) * (0.5 + u);
    double dx0 = u - 0.5;
    double dx1 = -2 * u;
    double dx2 = u + 0.5;
    double y0 = 0.5 * (0.5 - v) * (0.5 - v);
    double y1 = 0.75 - v * v;
    double y2 = 0.5 * (0.5 + v) * (0.5 + v);
    double dy0 = v - 0.5;
    double dy1 = -2 * v;
    double dy2 = v + 0.5;
    double[] c = coefficients;
    for (int layer = 0; layer < 3; layer++) {
      int n = 9 * layer;
      double r0 = c[n] * x0 + c[n + 1] * x1 + c[n + 2] * x2;
      double r1 = c[n + 3] * x0 + c[n + 4] * x1 + c[n + 5] * x2;
      double r2 = c[n + 6] * x0 + c[n + 7] * x1 + c[n + 8] * x2;
      double s0 = c[n] * dx0 + c[n + 1] * dx1 + c[n + 2] * dx2;
      double s1 = c[n + 3] * dx0 + c[n + 4] * dx1 + c[n + 5] * dx2;
      double s2 = c[n + 6] * dx0 + c[n + 7] * dx1 + c[n + 8] * dx2;
      double q0 = c[n] - 2 * c[n + 1] + c[n + 2];
      double q1 = c[n + 3] - 2 * c[n + 4] + c[n + 5];
      double q2 = c[n + 6] - 2 * c[n + 7] + c[n + 8];
      double f = r0 * y0 + r1 * y1 + r2 * y2;
      double fx = s0 * y0 + s1 * y1 + s2 * y2;
      double fy = r0 * dy0 + r1 * dy1 + r2 * dy2;
      double fxx = q0 * y0 + q1 * y1 + q2 * y2;
      double fxy = s0 * dy0 + s1 * dy1 + s2 * dy2;
      double fyy = r0 - 2 * r1 + r2;
      sample.addLayer(layer, w, f, fx, fy, fxx, fxy, fyy);
    }
    sample.scale(inverseX, inverseY, inverseZ);
  }

  /**
   * A source that remembers the coefficients around some corners. It is made for the contacts of a
   * tool: they are evaluated in turn, each near where it was in the frame before. The answers are
   * those of the source behind it, to the last bit.
   *
   * <p>Each corner has one place, which it shares with others; the one that was loaded last keeps
   * it. Haptic thread only; allocates nothing after construction.
   */
  private static final class KeptCoefficients implements CoefficientSource {

    /** The binary logarithm of the number of places. */
    private static final int PLACES_SHIFT = 8;

    private static final int PLACES = 1 << PLACES_SHIFT;
    private static final int UNUSED_HASH_BITS = Integer.SIZE - PLACES_SHIFT;

    /** 2^32 divided by the golden ratio: multiples of it are spread evenly. */
    private static final int SPREAD = 0x9E37_79B9;

    private final CoefficientSource source;
    private final int[] cornerX = new int[PLACES];
    private final int[] cornerY = new int[PLACES];
    private final int[] cornerZ = new int[PLACES];
    private final SeedCell[] seeds = new SeedCell[PLACES];
    private final boolean[] forEverySeed = new boolean[PLACES];
    private final boolean[] isTaken = new boolean[PLACES];
    private final boolean[] anySolid = new boolean[PLACES];
    private final double[] values = new double[COEFFICIENTS * PLACES];

    /** The place of the coefficients that were loaded last. */
    private int last;

    KeptCoefficients(CoefficientSource source) {
      this.source = source;
      Arrays.setAll(seeds, place -> new SeedCell());
    }

    @Override
    public boolean load(
        CollisionScene scene, int x, int y, int z, SeedCell seed, double[] coefficients) {
      int hash = (x + SPREAD * (y + SPREAD * z)) * SPREAD;
      last = hash >>> UNUSED_HASH_BITS;
      boolean isThere = cornerX[last] == x && cornerY[last] == y && cornerZ[last] == z;
      if (!(isThere && holdsFor(seed))) {
        cornerX[last] = x;
        cornerY[last] = y;
        cornerZ[last] = z;
        seeds[last].set(seed);
        anySolid[last] = source.load(scene, x, y, z, seed, coefficients);
        forEverySeed[last] = source.holdsForEverySeed();
        isTaken[last] = true;
        System.arraycopy(coefficients, 0, values, COEFFICIENTS * last, COEFFICIENTS);
      } else if (anySolid[last]) {
        System.arraycopy(values, COEFFICIENTS * last, coefficients, 0, COEFFICIENTS);
      }
      return anySolid[last];
    }

    @Override
    public boolean holdsFor(SeedCell seed) {
      return isTaken[last] && (forEverySeed[last] || seeds[last].isSame(seed));
    }

    @Override
    public boolean holdsForEverySeed() {
      return isTaken[last] && forEverySeed[last];
    }

    @Override
    public long columns() {
      return source.columns();
    }

    @Override
    public void forget() {
      Arrays.fill(isTaken, false);
      source.forget();
    }

    @Override
    public void forget(IntBox changed) {
      Arrays.fill(isTaken, false);
      source.forget(changed);
    }

    @Override
    public double sigmaEdges(int axis) {
      return source.sigmaEdges(axis);
    }
  }
}
