package org.palpate.proxy.smooth.field;

import java.util.Arrays;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.IntBox;
import org.palpate.volume.LayerRamp;
import org.palpate.volume.LevelGradients;

/**
 * The occupancies of the thin slices into which voxels are cut, as the grey values give them. A
 * cell lies in one voxel or in two; what is solid of a voxel that is partly solid, {@link
 * PartialVoxels} knows. Cost: some twenty operations for each cell in or beside such a voxel.
 */
final class ThinOccupancies implements GreyOccupancyCache.Source {
  private static final int EDGE = GreyOccupancyCache.EDGE;
  private static final int WHOLE = GreyOccupancyCache.WHOLE;
  private static final long ONE_A_BYTE = 0x0101_0101_0101_0101L;

  /** A part of a voxel thinner than this comes from rounding. */
  private static final double SLIVER = 1e-9;

  private static final int PLACES = 64;
  private static final int NONE = Integer.MIN_VALUE;

  private final AxisCut cut;
  private final PartialVoxels voxels;

  /** The cell whose place in its voxels is kept at each index. */
  private final int[] cells = new int[PLACES];

  /** The voxel that holds the lower end of each cell. */
  private final int[] lowVoxel = new int[PLACES];

  /** The fraction of that voxel below the cell. */
  private final double[] below = new double[PLACES];

  /**
   * Creates the thin slices of one cut.
   *
   * @param voxels the voxels, or what an earlier cut along another axis made of them
   */
  ThinOccupancies(AxisCut cut, GreyOccupancyCache.Source voxels) {
    this.cut = cut;
    this.voxels = new PartialVoxels(cut.axis(), voxels);
    Arrays.fill(cells, NONE);
  }

  @Override
  public void forget() {
    voxels.forget();
  }

  @Override
  public void forget(IntBox changed) {
    voxels.forget(changed);
    int axis = cut.axis();
    int low = SeedCell.floor(changed.low(axis) * cut.perVoxel());
    int high = SeedCell.floor((changed.high(axis) + 1) * cut.perVoxel());
    changed.setRange(axis, low - 1, high + 1); // with a margin against rounding
  }

  @Override
  public long occupancies(CollisionScene scene, int word, int j, int k) {
    return cut.axis() == 0 ? alongX(scene, word, j, k) : acrossX(scene, word, j, k);
  }

  /** Returns cells that lie side by side along the long axis. */
  private long alongX(CollisionScene scene, int word, int j, int k) {
    long result = 0;
    for (int n = 0; n < EDGE; n++) {
      int place = placeOf(EDGE * word + n);
      int voxel = lowVoxel[place];
      double solid = solid(scene, voxel, j, k, below[place], lowEnd(place));
      if (isInTwo(place)) {
        solid += solid(scene, voxel + 1, j, k, 0, highEnd(place));
      }
      result |= occupancy(solid) << (Byte.SIZE * n);
    }
    return result;
  }

  /** Returns the length of the solid in a part of a voxel, given by its coordinates. */
  private double solid(CollisionScene scene, int i, int j, int k, double from, double to) {
    int slot = voxels.slot(scene, i >> 3, j, k);
    if (isPartial(voxels.word(slot))) {
      voxels.findRamps(scene, slot, i >> 3, j, k);
    }
    return voxels.solid(slot, i & (EDGE - 1), from, to);
  }

  /** Returns cells that lie side by side across the long axis. */
  private long acrossX(CollisionScene scene, int word, int j, int k) {
    boolean alongY = cut.axis() == 1;
    int place = placeOf(alongY ? j : k);
    int lowJ = alongY ? lowVoxel[place] : j;
    int lowK = alongY ? k : lowVoxel[place];
    int low = voxels.slot(scene, word, lowJ, lowK);
    long lower = voxels.word(low);
    boolean inTwo = isInTwo(place);
    int highJ = alongY && inTwo ? lowJ + 1 : lowJ;
    int highK = !alongY && inTwo ? lowK + 1 : lowK;
    int high = inTwo ? voxels.slot(scene, word, highJ, highK) : low;
    if (!isPartial(lower) && lower == voxels.word(high)) {
      return lower; // each voxel is empty or solid, and so is each cell
    }
    if (isPartial(lower)) {
      voxels.findRamps(scene, low, word, lowJ, lowK);
    }
    if (isPartial(voxels.word(high))) {
      voxels.findRamps(scene, high, word, highJ, highK);
    }
    long result = 0;
    for (int n = 0; n < EDGE; n++) {
      double solid = voxels.solid(low, n, below[place], lowEnd(place));
      if (inTwo) {
        solid += voxels.solid(high, n, 0, highEnd(place));
      }
      result |= occupancy(solid) << (Byte.SIZE * n);
    }
    return result;
  }

  /** Whether any of eight occupancies is neither none nor whole. */
  private static boolean isPartial(long occupancies) {
    return occupancies != (occupancies & ONE_A_BYTE) * WHOLE;
  }

  private long occupancy(double solid) {
    return (long) (solid * cut.perVoxel() * WHOLE + 0.5);
  }

  /** Whether a cell lies in two voxels. */
  private boolean isInTwo(int place) {
    return highEnd(place) > SLIVER;
  }

  /** Returns the upper end of a cell's part in the lower one of its voxels. */
  private double lowEnd(int place) {
    return Math.min(1, below[place] + 1 / cut.perVoxel());
  }

  /** Returns the upper end of its part in the next voxel; 0 or less if it has none. */
  private double highEnd(int place) {
    return below[place] + 1 / cut.perVoxel() - 1;
  }

  /** Returns the index at which the place of a cell in its voxels is kept from now on. */
  private int placeOf(int cell) {
    int place = cell & (PLACES - 1);
    if (cells[place] != cell) {
      double at = cell / cut.perVoxel();
      cells[place] = cell;
      lowVoxel[place] = SeedCell.floor(at);
      below[place] = at - lowVoxel[place];
    }
    return place;
  }

  /**
   * Caches voxels, and where the surface crosses those that are partly solid, along the axis along
   * which they are cut.
   *
   * <p>The surface is taken for a plane. Its tilt follows from the voxels around. Along the axis
   * the solid fraction of the layers of a voxel then falls as a {@link LayerRamp}. The ramp lies
   * where the voxel's own occupancy puts it. If the surface is nearly parallel to the slices, it
   * lies where all partly solid voxels of its row put it together, which undoes a blur along the
   * row.
   *
   * <p>Lengths are in voxels, along the axis of the cut. Cost: some 150 operations for each word of
   * eight voxels of which any is partly solid, and 50 for each of these. It depends on the voxels
   * {@link #REACH} steps either way along the axis, and one across.
   *
   * <p>References: interfaces from volume fractions, Youngs 1982; height functions, Hirt and
   * Nichols 1981.
   */
  private static final class PartialVoxels {
    /** The farthest voxel of a row that is looked at. */
    private static final int REACH = 4;

    /** At most this wide, a ramp lies where its row puts it. */
    private static final double ROW_WIDTH = 0.5;

    /**
     * At least this wide, a ramp lies where its own voxel puts it. There a blur along the row does
     * little, and the voxel's own occupancy makes up for an error of the tilt.
     */
    private static final double OWN_WIDTH = 1.5;

    private static final int BYTE = 0xFF;

    /** The words of cached voxels along each axis. */
    private static final int CACHE_EDGE = 16;

    private final int axis;
    private final int stepX;
    private final int stepY;
    private final int stepZ;
    private final GreyOccupancyCache.Source voxels;
    private final CacheKeys keys = new CacheKeys(CACHE_EDGE);
    private final long[] words = new long[keys.slots()];

    /** Whether the ramps of each word are known. */
    private final boolean[] known = new boolean[keys.slots()];

    /** The middle of each voxel's ramp, from the lower end of the voxel. */
    private final float[] middle = new float[EDGE * keys.slots()];

    /** The width of each voxel's ramp, negative if the solid lies on the upper side. */
    private final float[] width = new float[EDGE * keys.slots()];

    private final LevelGradients gradients = new LevelGradients();

    /**
     * Creates a cache.
     *
     * @param axis the axis of the cut
     * @param voxels gives the voxels
     */
    PartialVoxels(int axis, GreyOccupancyCache.Source voxels) {
      this.axis = axis;
      stepX = axis == 0 ? 1 : 0;
      stepY = axis == 1 ? 1 : 0;
      stepZ = axis == 2 ? 1 : 0;
      this.voxels = voxels;
    }

    /** Forgets everything. */
    void forget() {
      voxels.forget();
      keys.forget();
    }

    /**
     * Forgets everything, and what lies behind it only as far as voxels changed.
     *
     * @param changed a box around these voxels; receives a box around those whose occupancy or ramp
     *     they may change
     */
    void forget(IntBox changed) {
      voxels.forget(changed);
      keys.forget();
      changed.grow(1);
      changed.setRange(axis, changed.low(axis) - REACH + 1, changed.high(axis) + REACH - 1);
    }

    /**
     * Returns the slot that holds the voxels from (8 word, j, k) on along x, until a word is asked
     * for that shares it.
     */
    int slot(CollisionScene scene, int word, int j, int k) {
      int slot = keys.slot(word, j, k);
      if (!keys.holdsElseSet(slot, word, j, k)) {
        words[slot] = voxels.occupancies(scene, word, j, k);
        known[slot] = false;
      }
      return slot;
    }

    /** Returns the occupancies of the voxels that a slot holds, a byte each. */
    long word(int slot) {
      return words[slot];
    }

    private int voxel(CollisionScene scene, int i, int j, int k) {
      return byteOf(words[slot(scene, i >> 3, j, k)], i & (EDGE - 1));
    }

    private static int byteOf(long word, int n) {
      return (int) (word >>> (Byte.SIZE * n)) & BYTE;
    }

    /** Finds the ramps of the voxels from (8 word, j, k) on, which a slot holds. */
    void findRamps(CollisionScene scene, int slot, int word, int j, int k) {
      if (known[slot]) {
        return;
      }
      known[slot] = true;
      gather(scene, slot, word, j, k);
      for (int n = 0; n < EDGE; n++) {
        int occupancy = byteOf(words[slot], n);
        if (occupancy != 0 && occupancy != WHOLE) {
          findRamp(scene, EDGE * slot + n, occupancy, EDGE * word + n, j, k);
        }
      }
    }

    /** Gathers what the gradients of a word need. */
    private void gather(CollisionScene scene, int slot, int word, int j, int k) {
      int first = byteOf(words[slot], 0);
      int last = byteOf(words[slot], EDGE - 1);
      boolean needsBefore = first != 0 && first != WHOLE;
      boolean needsBehind = last != 0 && last != WHOLE;
      for (int n = 0; n < LevelGradients.ROWS; n++) {
        int rowJ = j + n % 3 - 1;
        int rowK = k + n / 3 - 1;
        gradients.set(
            n,
            needsBefore ? words[slot(scene, word - 1, rowJ, rowK)] : 0,
            words[slot(scene, word, rowJ, rowK)],
            needsBehind ? words[slot(scene, word + 1, rowJ, rowK)] : 0);
      }
      gradients.find();
    }

    /**
     * Returns the length of the solid in a part of a voxel; its ramp must be known if it has one.
     *
     * @param slot holds its word
     * @param n its number within the word
     * @param from the lower end of the part, from that of the voxel
     * @param to its upper end
     */
    double solid(int slot, int n, double from, double to) {
      int occupancy = byteOf(words[slot], n);
      if (occupancy == 0 || occupancy == WHOLE) {
        return occupancy == 0 ? 0 : to - from;
      }
      float signedWidth = width[EDGE * slot + n];
      double below = LayerRamp.solid(from, to, middle[EDGE * slot + n], Math.abs(signedWidth));
      return signedWidth > 0 ? below : to - from - below;
    }

    /** Finds the ramp of a partly solid voxel, to be kept at an index. */
    private void findRamp(CollisionScene scene, int at, int occupancy, int i, int j, int k) {
      int n = i & (EDGE - 1);
      double x = gradients.x(n);
      double y = gradients.y(n);
      double z = gradients.z(n);
      double along = stepX * x + stepY * y + stepZ * z;
      double ramp = LayerRamp.width(along, x * x + y * y + z * z);
      double solidUpTo = LayerRamp.middle(occupancy / (double) WHOLE, ramp);
      double ofRow = Math.min(1, (OWN_WIDTH - ramp) / (OWN_WIDTH - ROW_WIDTH));
      if (ofRow > 0) {
        double inRow = solidUpToInRow(scene, occupancy, i, j, k, along < 0 ? 1 : -1);
        solidUpTo += Double.isNaN(inRow) ? 0 : ofRow * (inRow - solidUpTo);
      }
      middle[at] = (float) (along < 0 ? solidUpTo : 1 - solidUpTo);
      width[at] = (float) (along < 0 ? ramp : -ramp);
    }

    /**
     * Returns how far the voxels of a row are solid together, from the solid end of one of them;
     * NaN if no whole and no empty voxel ends the row in reach, or if the occupancies turn before.
     *
     * @param up the direction in which they fall, along the axis of the cut: 1 or -1
     */
    private double solidUpToInRow(
        CollisionScene scene, int occupancy, int i, int j, int k, int up) {
      int solid = occupancy;
      int last = occupancy;
      for (int n = 1; last != 0; n++) {
        int next = inRow(scene, i, j, k, n * up);
        if (n > REACH || next > last) {
          return Double.NaN;
        }
        solid += next;
        last = next;
      }
      last = occupancy;
      for (int n = 1; last != WHOLE; n++) {
        int next = inRow(scene, i, j, k, -n * up);
        if (n > REACH || next < last) {
          return Double.NaN;
        }
        solid += next - WHOLE;
        last = next;
      }
      return solid / (double) WHOLE;
    }

    /** Returns the occupancy of a voxel some steps along the axis of the cut from another one. */
    private int inRow(CollisionScene scene, int i, int j, int k, int steps) {
      return voxel(scene, i + steps * stepX, j + steps * stepY, k + steps * stepZ);
    }
  }
}
