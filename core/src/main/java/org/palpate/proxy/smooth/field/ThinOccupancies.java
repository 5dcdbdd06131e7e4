package org.palpate.proxy.smooth.field;

import java.util.Arrays;
import org.palpate.collision.CollisionScene;

/**
 * The occupancies of the thin slices into which voxels are cut, as the grey values give them. A
 * voxel that is partly solid is filled from the side of its solid neighbour along the long axis, as
 * far as its occupancy goes. If the neighbours on both sides are alike, it is filled evenly.
 *
 * <p>A cell lies in one voxel or in two. It depends on these and on the next voxel on either side,
 * so four words of voxels give a word of cells, whichever window asks. Voxels are cached, because
 * the cells of a voxel and of its neighbours all need it. Cost: some ten operations for each cell
 * in or beside a voxel that is partly solid.
 */
final class ThinOccupancies extends GreyOccupancyCache {
  private static final int BYTE = 0xFF;
  private static final long ONE_A_BYTE = 0x0101_0101_0101_0101L;

  /** The words of cached voxels along each axis. */
  private static final int CACHE_EDGE = 32;

  private static final int SLOTS = 64;
  private static final int NONE = Integer.MIN_VALUE;

  private final AxisCut cut;
  private final GreyOccupancyCache voxels;
  private final CacheKeys voxelKeys = new CacheKeys(CACHE_EDGE);
  private final long[] voxelWords = new long[voxelKeys.slots()];

  /** The cell whose place in its voxels each slot holds. */
  private final int[] cells = new int[SLOTS];

  /** The voxel that holds the lower end of each cell. */
  private final int[] lowVoxel = new int[SLOTS];

  /** The fraction of that voxel below the cell. */
  private final double[] below = new double[SLOTS];

  /**
   * Creates the thin slices of one cut.
   *
   * @param voxels the voxels, or what an earlier cut along another axis made of them
   */
  ThinOccupancies(AxisCut cut, GreyOccupancyCache voxels) {
    this.cut = cut;
    this.voxels = voxels;
    Arrays.fill(cells, NONE);
  }

  @Override
  void forget() {
    super.forget();
    voxels.forget();
    voxelKeys.forget();
  }

  @Override
  long occupancies(CollisionScene scene, int word, int j, int k) {
    return cut.axis() == 0 ? alongX(scene, word, j, k) : acrossX(scene, word, j, k);
  }

  /** Returns cells that lie side by side along the long axis. */
  private long alongX(CollisionScene scene, int word, int j, int k) {
    long result = 0;
    for (int n = 0; n < EDGE; n++) {
      int slot = slotOf(EDGE * word + n);
      int voxel = lowVoxel[slot];
      int cell =
          cell(
              slot,
              voxelAlongX(scene, voxel - 1, j, k),
              voxelAlongX(scene, voxel, j, k),
              voxelAlongX(scene, voxel + 1, j, k),
              voxelAlongX(scene, voxel + 2, j, k));
      result |= (long) cell << (8 * n);
    }
    return result;
  }

  private int voxelAlongX(CollisionScene scene, int i, int j, int k) {
    return byteOf(voxels(scene, i >> 3, j, k), i & (EDGE - 1));
  }

  /** Returns cells that lie side by side across the long axis. */
  private long acrossX(CollisionScene scene, int word, int j, int k) {
    int slot = slotOf(cut.axis() == 1 ? j : k);
    int voxel = lowVoxel[slot];
    long lower = voxelsAt(scene, word, j, k, voxel);
    long upper = voxelsAt(scene, word, j, k, voxel + 1);
    if (lower == upper && lower == (lower & ONE_A_BYTE) * BYTE) {
      return lower; // each voxel is empty or solid, and the next one alike
    }
    long before = voxelsAt(scene, word, j, k, voxel - 1);
    long behind = voxelsAt(scene, word, j, k, voxel + 2);
    long result = 0;
    for (int n = 0; n < EDGE; n++) {
      int cell =
          cell(slot, byteOf(before, n), byteOf(lower, n), byteOf(upper, n), byteOf(behind, n));
      result |= (long) cell << (8 * n);
    }
    return result;
  }

  /** Returns a word of voxels, given its coordinate along the long axis. */
  private long voxelsAt(CollisionScene scene, int word, int j, int k, int voxel) {
    return cut.axis() == 1 ? voxels(scene, word, voxel, k) : voxels(scene, word, j, voxel);
  }

  private long voxels(CollisionScene scene, int word, int j, int k) {
    int slot = voxelKeys.slot(word, j, k);
    if (!voxelKeys.holdsElseSet(slot, word, j, k)) {
      voxelWords[slot] = voxels.occupancies(scene, word, j, k);
    }
    return voxelWords[slot];
  }

  private static int byteOf(long word, int n) {
    return (int) (word >>> (8 * n)) & BYTE;
  }

  /** Returns the slot that holds the place of a cell in its voxels from now on. */
  private int slotOf(int cell) {
    int slot = cell & (SLOTS - 1);
    if (cells[slot] != cell) {
      double at = cell / cut.perVoxel();
      cells[slot] = cell;
      lowVoxel[slot] = SeedCell.floor(at);
      below[slot] = at - lowVoxel[slot];
    }
    return slot;
  }

  /**
   * Returns the occupancy of a cell.
   *
   * @param slot holds its place
   * @param lower the occupancy of the voxel that holds its lower end, which may hold all of it
   * @param before that of the voxel before
   * @param upper that of the next voxel
   * @param behind that of the one behind
   */
  private int cell(int slot, int before, int lower, int upper, int behind) {
    double from = below[slot];
    double height = 1 / cut.perVoxel();
    double inLower = Math.min(height, 1 - from);
    double solid = inLower * part(before, lower, upper, from, inLower);
    if (inLower < height) {
      solid += (height - inLower) * part(lower, upper, behind, 0, height - inLower);
    }
    return (int) (solid * cut.perVoxel() + 0.5);
  }

  /**
   * Returns the occupancy of a part of a voxel.
   *
   * @param whole the occupancy of the voxel
   * @param lower that of its lower neighbour
   * @param upper that of its upper neighbour
   * @param from the lower end of the part, as a fraction of the voxel
   * @param height its height, as a fraction of the voxel
   */
  private static double part(int lower, int whole, int upper, double from, double height) {
    if (whole == 0 || whole == WHOLE) {
      return whole;
    }
    double start = lower > upper ? from : 1 - from - height;
    double filled = Math.max(0, Math.min(WHOLE, (whole - WHOLE * start) / height));
    double directed = Math.abs(lower - upper) / (double) WHOLE;
    return whole + directed * (filled - whole);
  }
}
