package org.palpate.fracture;

import java.util.Optional;
import org.palpate.geometry.AffineMap;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;
import org.palpate.volume.fracture.PosedBits;

/**
 * The occupancy of a posed fragment, smoothed by a Gaussian, so that its surface, where half is
 * solid, lies between voxels. Bits that change meanwhile may count as they were. One thread an
 * instance.
 *
 * <p>Of two fragments that were cut from one bone without a kerf, both occupancies add up to that
 * of the bone while they stand as they rest. So their surfaces coincide inside the bone, however
 * rough the voxels are.
 */
public final class SmoothedBits {
  /** The voxels along an edge of the cube that the Gaussian covers. */
  private static final int WIDTH = 8;

  /** The edge of {@link BitCube#window}, and the number of its rows of four voxels. */
  private static final int QUARTET = 4;

  private static final int ROWS = QUARTET * QUARTET;
  private static final int ROW_MASK = 15;

  /** The position of the first voxel's centre relative to the middle of the cube. */
  private static final double MIDDLE = 0.5 - WIDTH / 2.0;

  private static final double WALK_EDGES = 0.5;
  private static final int REFINEMENTS = 4;

  private final BitCube bits;
  private final AffineMap worldToGrid;
  private final PosedBits fragment;
  private final Optional<PartialVoxels> partial;
  private final double stepMm;
  private final double sigma;

  /** The Gaussian at the centres of voxels, if the position is the middle of the cube. */
  private final double[] bell = new double[WIDTH];

  private final Vec3 grid = new Vec3();
  private final Vec3 at = new Vec3();
  private final Vec3 unused = new Vec3();
  private final double[][] weights = new double[3][WIDTH];
  private final double[][] slopes = new double[3][WIDTH];
  private final int[] first = new int[3];

  /** The sums of the weights along x of each row of four voxels, for both halves of the cube. */
  private final double[][] rowWeights = new double[2][1 << QUARTET];

  private final double[][] rowSlopes = new double[2][1 << QUARTET];

  private double sum;
  private final Vec3 slope = new Vec3();

  /**
   * Prepares the occupancy of a fragment where it stands; the pose must not change.
   *
   * @param fragment the fragment; its voxels may change, see above
   * @param sigma the standard deviation of the Gaussian, voxels, at most 1.5
   */
  public SmoothedBits(PosedBits fragment, double sigma) {
    this(fragment, Optional.empty(), sigma);
  }

  /**
   * Prepares the occupancy of a fragment where it stands, with voxels that are partly full. The
   * pose must not change. Where an edit adds or removes voxels, the bits count.
   *
   * @param fragment the fragment; its voxels may change, see above
   * @param partial how full the voxels at its surface are; if empty, only its bits count
   * @param sigma the standard deviation of the Gaussian, voxels, at most 1.5
   */
  public SmoothedBits(PosedBits fragment, Optional<PartialVoxels> partial, double sigma) {
    this.fragment = fragment;
    this.partial = partial;
    this.sigma = sigma;
    for (int n = 0; n < WIDTH; n++) {
      double m = MIDDLE + n;
      bell[n] = StrictMath.exp(-m * m / (2 * sigma * sigma));
    }
    bits = fragment.bits();
    worldToGrid = fragment.gridFrom(VoxelGrid.ofUnitVoxels(1, 1, 1), new Pose());
    Vec3 s = fragment.grid().spacingMm();
    stepMm = WALK_EDGES * Math.max(s.x, Math.max(s.y, s.z));
  }

  /**
   * {@return whether a world position lies in a voxel}
   *
   * @param world the position, world mm
   */
  public boolean isSolid(Vec3 world) {
    worldToGrid.transform(world, grid);
    return bits.get((int) Math.floor(grid.x), (int) Math.floor(grid.y), (int) Math.floor(grid.z));
  }

  /**
   * {@return whether a world position lies in the box of the voxels or near it}
   *
   * @param world the position, world mm
   * @param mm the largest distance from the box along an axis of the grid, mm
   */
  public boolean isNear(Vec3 world, double mm) {
    worldToGrid.transform(world, grid);
    Vec3 s = fragment.grid().spacingMm();
    IntBox box = bits.bounds();
    return grid.x >= box.lowX - mm / s.x
        && grid.x <= box.highX + 1 + mm / s.x
        && grid.y >= box.lowY - mm / s.y
        && grid.y <= box.highY + 1 + mm / s.y
        && grid.z >= box.lowZ - mm / s.z
        && grid.z <= box.highZ + 1 + mm / s.z;
  }

  /**
   * {@return the smoothed occupancy at a world position, 0 to 1}
   *
   * @param world the position, world mm
   * @param outward receives the direction of steepest descent, a unit vector in the world
   */
  public double occupancy(Vec3 world, Vec3 outward) {
    double occupancy = descent(world, outward);
    double length = outward.length();
    outward.mul(length > 0 ? 1 / length : 0, outward);
    return occupancy;
  }

  /**
   * {@return the smoothed occupancy at a world position, 0 to 1}
   *
   * @param world the position, world mm
   * @param descent receives the negative gradient, world axes, 1/mm
   */
  public double descent(Vec3 world, Vec3 descent) {
    worldToGrid.transform(world, grid);
    for (int axis = 0; axis < 3; axis++) {
      setWeights(axis, grid.get(axis));
    }
    sumRows(0);
    sumRows(1);
    sum = 0;
    slope.set(0, 0, 0);
    for (int part = 0; part < 8; part++) {
      int x = part & 1;
      int y = (part >> 1) & 1;
      int z = part >> 2;
      long voxels =
          bits.window(first[0] + QUARTET * x, first[1] + QUARTET * y, first[2] + QUARTET * z);
      if (voxels != 0) {
        add(voxels, x, QUARTET * y, QUARTET * z);
      }
    }
    if (partial.isPresent()) {
      addPartial(partial.get());
    }
    Vec3 s = fragment.grid().spacingMm();
    descent.set(-slope.x / s.x, -slope.y / s.y, -slope.z / s.z);
    fragment.grid().gridMmToWorld().rotate(descent, descent);
    fragment.pose().rotation.rotate(descent, descent);
    return sum;
  }

  /** Adds 4x4x4 voxels. */
  private void add(long voxels, int half, int y, int z) {
    for (int row = 0; row < ROWS; row++) {
      int four = (int) (voxels >>> (QUARTET * row)) & ROW_MASK;
      if (four != 0) {
        int b = y + row % QUARTET;
        int c = z + row / QUARTET;
        double along = rowWeights[half][four];
        sum += along * weights[1][b] * weights[2][c];
        slope.x += rowSlopes[half][four] * weights[1][b] * weights[2][c];
        slope.y += along * slopes[1][b] * weights[2][c];
        slope.z += along * weights[1][b] * slopes[2][c];
      }
    }
  }

  /** Adds what grey values add to the bits. */
  private void addPartial(PartialVoxels voxels) {
    int shift = BitCube.BRICK_SHIFT;
    for (int z = first[2] >> shift; z <= (first[2] + WIDTH - 1) >> shift; z++) {
      for (int y = first[1] >> shift; y <= (first[1] + WIDTH - 1) >> shift; y++) {
        for (int x = first[0] >> shift; x <= (first[0] + WIDTH - 1) >> shift; x++) {
          float[] excess = voxels.excess(x, y, z);
          if (excess != null) {
            addBrick(excess, x << shift, y << shift, z << shift);
          }
        }
      }
    }
  }

  private void addBrick(float[] excess, int lowX, int lowY, int lowZ) {
    int edge = PartialVoxels.EDGE;
    for (int n = 0; n < excess.length; n++) {
      int i = lowX + n % edge;
      int j = lowY + n / edge % edge;
      int k = lowZ + n / edge / edge;
      if (excess[n] != 0 && isCovered(i, j, k) && excess[n] < 0 == bits.get(i, j, k)) {
        addExcess(excess[n], i - first[0], j - first[1], k - first[2]);
      }
    }
  }

  private boolean isCovered(int i, int j, int k) {
    return i >= first[0]
        && j >= first[1]
        && k >= first[2]
        && i < first[0] + WIDTH
        && j < first[1] + WIDTH
        && k < first[2] + WIDTH;
  }

  private void addExcess(double excess, int a, int b, int c) {
    double across = excess * weights[1][b] * weights[2][c];
    sum += across * weights[0][a];
    slope.x += across * slopes[0][a];
    slope.y += excess * weights[0][a] * slopes[1][b] * weights[2][c];
    slope.z += excess * weights[0][a] * weights[1][b] * slopes[2][c];
  }

  /**
   * Computes the weights along an axis. Let d be the distance of the cube's middle, and m that of a
   * voxel from the middle. The Gaussian of d + m is a power times a constant times a factor that
   * all voxels share. Scaling to the sum 1 removes that factor.
   */
  private void setWeights(int axis, double coordinate) {
    first[axis] = (int) Math.floor(coordinate + 0.5) - WIDTH / 2;
    double d = first[axis] + WIDTH / 2 - coordinate;
    double ratio = StrictMath.exp(-d / (sigma * sigma));
    double power = 1;
    double total = 0;
    for (int n = 0; n < WIDTH; n++) {
      weights[axis][n] = power * bell[n];
      total += weights[axis][n];
      power *= ratio;
    }
    for (int n = 0; n < WIDTH; n++) {
      weights[axis][n] /= total;
      slopes[axis][n] = weights[axis][n] * (d + MIDDLE + n) / (sigma * sigma);
    }
  }

  private void sumRows(int half) {
    for (int four = 1; four < 1 << QUARTET; four++) {
      int rest = four & (four - 1);
      int last = QUARTET * half + Integer.numberOfTrailingZeros(four);
      rowWeights[half][four] = rowWeights[half][rest] + weights[0][last];
      rowSlopes[half][four] = rowSlopes[half][rest] + slopes[0][last];
    }
  }

  /**
   * Finds the surface on a line: of the places where the line enters the fragment against a
   * direction, the one nearest to the start.
   *
   * @param start a position on the line, world mm
   * @param outward the direction, a unit vector in the world
   * @param mostMm the largest distance from the start, on either side
   * @param dest receives the place
   * @return whether there is one
   */
  public boolean surface(Vec3 start, Vec3 outward, double mostMm, Vec3 dest) {
    double best = Double.NaN;
    double bestAbove = 0;
    double bestBelow = 0;
    double before = Double.NaN;
    for (double h = mostMm; h >= -mostMm; h -= stepMm) {
      double now = occupancy(shifted(start, outward, h, at), unused);
      if (before < 0.5 && now >= 0.5 && !(Math.abs(h) > Math.abs(best))) {
        best = h;
        bestAbove = before;
        bestBelow = now;
      }
      before = now;
    }
    if (Double.isNaN(best)) {
      return false;
    }
    double h = refined(start, outward, best, bestBelow, bestAbove);
    shifted(start, outward, h, dest);
    return true;
  }

  /** Returns where the occupancy is one half between two heights, by false position. */
  private double refined(Vec3 start, Vec3 outward, double below, double inside, double outside) {
    double low = below;
    double high = below + stepMm;
    double atLow = inside;
    double atHigh = outside;
    double h = low;
    for (int n = 0; n < REFINEMENTS; n++) {
      h = low + (high - low) * (atLow - 0.5) / (atLow - atHigh);
      double now = occupancy(shifted(start, outward, h, at), unused);
      if (now >= 0.5) {
        low = h;
        atLow = now;
      } else {
        high = h;
        atHigh = now;
      }
    }
    return h;
  }

  private static Vec3 shifted(Vec3 start, Vec3 direction, double h, Vec3 dest) {
    return dest.set(
        start.x + h * direction.x, start.y + h * direction.y, start.z + h * direction.z);
  }
}
