package org.palpate.proxy.smooth.field;

import java.util.Arrays;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.IntBox;

/**
 * A cache of the solid voxels of slices as rows of bits, in coordinates (u,v,w) whose w is the long
 * axis.
 *
 * <pre>
 *   ring buffer of 32 slices of 64 rows of 64 bits, each in a word:
 *   pixel (u,v) of slice w is bit (u mod 64) of row (v mod 64) of slice (w mod 32)
 * </pre>
 *
 * <p>Four slices, a layer of bricks, hold a rectangle of bricks that grows and moves with what is
 * asked for. Call {@link #forget} after any change of the solids.
 */
final class SliceBits {
  /** The rows of a slice, and the bits of a row. */
  static final int EDGE = 64;

  /** All pixels of a tile, the 4x4 pixels of a brick. */
  static final int ALL_PIXELS = 0xFFFF;

  private static final int EDGE_MASK = EDGE - 1;
  private static final int LAYERS = 8;
  private static final int SLICE_MASK = 4 * LAYERS - 1;

  /** The most bricks of a rectangle along an axis. */
  private static final int MAX_BRICKS = EDGE / 4;

  private final BrickSource source;
  private final int axis;
  private final long[] rows = new long[4 * LAYERS * EDGE];

  /** The layer that each part of the ring buffer holds, if it {@link #holdsLayer}. */
  private final int[] layer = new int[LAYERS];

  /** Whether each part of the ring buffer holds bits that are valid. */
  private final boolean[] holdsLayer = new boolean[LAYERS];

  private final int[] lowU = new int[LAYERS];
  private final int[] endU = new int[LAYERS];
  private final int[] lowV = new int[LAYERS];
  private final int[] endV = new int[LAYERS];

  private CollisionScene scene;

  /** Creates a cache of the slices of a source across an axis. */
  SliceBits(BrickSource source, int axis) {
    this.source = source;
    this.axis = axis;
  }

  /** Forgets all bits. */
  void forget() {
    Arrays.fill(holdsLayer, false);
    source.forget();
  }

  /**
   * Forgets what changes reach, as its source does.
   *
   * @param changed the voxels; receives the cells of the source, see {@link
   *     BrickSource#forget(IntBox)}
   */
  void forget(IntBox changed) {
    source.forget(changed);
    forgetRows(changed);
  }

  /**
   * Forgets the rows that hold changed cells of the source.
   *
   * @param cells a box around these cells
   */
  void forgetRows(IntBox cells) {
    for (int at = 0; at < LAYERS; at++) {
      boolean meets =
          isWithin(layer[at], cells, axis)
              && lowU[at] <= cells.high(axisU()) >> 2
              && endU[at] > cells.low(axisU()) >> 2
              && lowV[at] <= cells.high(axisV()) >> 2
              && endV[at] > cells.low(axisV()) >> 2;
      holdsLayer[at] &= !meets;
    }
  }

  private static boolean isWithin(int brick, IntBox cells, int axis) {
    return brick >= cells.low(axis) >> 2 && brick <= cells.high(axis) >> 2;
  }

  /** Returns the axis along which u runs. */
  int axisU() {
    return axis == 0 ? 2 : 0;
  }

  /** Returns the axis along which v runs. */
  int axisV() {
    return axis == 1 ? 2 : 1;
  }

  /** Sets the scene, the same one since {@link #forget}. */
  void use(CollisionScene newScene) {
    scene = newScene;
  }

  /** Returns the pixels of a tile of slice w, a bit each; u fastest. */
  int pixels(int u, int v, int w) {
    return pixels(brick(u, v, w >> 2), w);
  }

  /** Returns the pixels of a slice, given the turned brick that holds it. */
  static int pixels(long brick, int slice) {
    return (int) (brick >>> (16 * (slice & 3))) & ALL_PIXELS;
  }

  /** Returns the place in the word of a brick of the source of a cell at (u,v,w) in it. */
  int bitOf(int u, int v, int w) {
    return switch (axis) {
      case 0 -> u << 4 | v << 2 | w;
      case 1 -> v << 4 | w << 2 | u;
      default -> w << 4 | v << 2 | u;
    };
  }

  /** Returns a brick of the source, turned so that its w is the long axis. */
  long brick(int u, int v, int w) {
    return switch (axis) {
      case 0 -> turned(source.brick(scene, w, v, u));
      case 1 -> turned(source.brick(scene, u, w, v));
      default -> source.brick(scene, u, v, w);
    };
  }

  /** Swaps the long axis of a brick with z; doing it twice gives the brick back. */
  long turned(long brick) {
    return switch (axis) {
      case 0 -> swap(swap(brick, 15, 0x0000_AAAA_0000_AAAAL), 30, 0x0000_0000_CCCC_CCCCL);
      case 1 -> swap(swap(brick, 12, 0x0000_F0F0_0000_F0F0L), 24, 0x0000_0000_FF00_FF00L);
      default -> brick;
    };
  }

  /** Swaps the bits of a mask with those that lie {@code shift} above them. */
  private static long swap(long bits, int shift, long mask) {
    long differing = (bits ^ bits >>> shift) & mask;
    return bits ^ differing ^ differing << shift;
  }

  /** Returns row v of slice w; pixel u is bit (u mod 64). Only covered pixels are valid. */
  long row(int v, int w) {
    return rows[(w & SLICE_MASK) * EDGE + (v & EDGE_MASK)];
  }

  /**
   * Returns the pixels of row v that are of a kind in both of two slices, a bit each.
   *
   * @param solid whether solid or empty pixels are returned
   */
  long rowOfBoth(int v, int w, int other, boolean solid) {
    long flip = solid ? 0 : -1;
    return (row(v, w) ^ flip) & (row(v, other) ^ flip);
  }

  /** Makes slice w hold the bricks that lie up to {@code reach} bricks around brick (u,v). */
  void cover(int u, int v, int w, int reach) {
    int at = w >> 2 & LAYERS - 1;
    int fromU = u - reach;
    int toU = u + reach + 1;
    int fromV = v - reach;
    int toV = v + reach + 1;
    boolean holds = holdsLayer[at] && layer[at] == w >> 2;
    if (holds && lowU[at] <= fromU && endU[at] >= toU && lowV[at] <= fromV && endV[at] >= toV) {
      return;
    }
    boolean overlaps =
        holds && lowU[at] <= toU && endU[at] >= fromU && lowV[at] <= toV && endV[at] >= fromV;
    if (!overlaps) {
      holdsLayer[at] = true;
      layer[at] = w >> 2;
      lowU[at] = endU[at] = fromU;
      lowV[at] = fromV;
      endV[at] = toV;
    }
    if (fromU < lowU[at] || toU > endU[at]) {
      growAlongU(at, Math.min(fromU, lowU[at]), Math.max(toU, endU[at]), toU > endU[at]);
    }
    if (fromV < lowV[at] || toV > endV[at]) {
      growAlongV(at, Math.min(fromV, lowV[at]), Math.max(toV, endV[at]), toV > endV[at]);
    }
  }

  /** Grows a layer along u; what the ring buffer then overwrites drops out at the other end. */
  private void growAlongU(int at, int from, int to, boolean upwards) {
    int low = upwards ? Math.max(from, to - MAX_BRICKS) : from;
    int end = upwards ? to : Math.min(to, from + MAX_BRICKS);
    readBricks(at, low, Math.min(end, lowU[at]), lowV[at], endV[at]);
    readBricks(at, Math.max(low, endU[at]), end, lowV[at], endV[at]);
    lowU[at] = low;
    endU[at] = end;
  }

  private void growAlongV(int at, int from, int to, boolean upwards) {
    int low = upwards ? Math.max(from, to - MAX_BRICKS) : from;
    int end = upwards ? to : Math.min(to, from + MAX_BRICKS);
    readBricks(at, lowU[at], endU[at], low, Math.min(end, lowV[at]));
    readBricks(at, lowU[at], endU[at], Math.max(low, endV[at]), end);
    lowV[at] = low;
    endV[at] = end;
  }

  private void readBricks(int at, int fromU, int toU, int fromV, int toV) {
    for (int v = fromV; v < toV; v++) {
      for (int u = fromU; u < toU; u++) {
        write(brick(u, v, layer[at]), at, u, v);
      }
    }
  }

  private void write(long brick, int at, int u, int v) {
    int shift = 4 * u & EDGE_MASK;
    long others = ~(0xFL << shift);
    int row = 4 * at * EDGE + (4 * v & EDGE_MASK);
    long left = brick;
    for (int slice = 0; slice < 4; slice++) {
      rows[row] = (rows[row] & others) | (left & 0xF) << shift;
      rows[row + 1] = (rows[row + 1] & others) | (left >>> 4 & 0xF) << shift;
      rows[row + 2] = (rows[row + 2] & others) | (left >>> 8 & 0xF) << shift;
      rows[row + 3] = (rows[row + 3] & others) | (left >>> 12 & 0xF) << shift;
      row += EDGE;
      left >>>= 16;
    }
  }
}
