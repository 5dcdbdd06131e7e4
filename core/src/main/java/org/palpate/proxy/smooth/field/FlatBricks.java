package org.palpate.proxy.smooth.field;

import org.palpate.collision.CollisionScene;

/**
 * Finds the bricks of a {@link BrickCopy} that hold a wide terrace: a layer of 4x4 empty cells
 * beside a layer of solid ones. It looks at each brick once, when it comes into the copy. Bricks
 * side by side are compared for the whole copy at once, a bit each.
 *
 * <p>What lies beside the copy is looked up only when a window reaches its rim there.
 */
final class FlatBricks {
  /** The cells of a layer. */
  private static final int OF_LAYER = 16;

  /** The four layers of a brick, a bit each. */
  private static final int ALL_LAYERS = 0xF;

  /** The cells of a brick's first layer across each axis. */
  private static final long[] FIRST_LAYER = {
    0x1111_1111_1111_1111L, 0x000F_000F_000F_000FL, 0xFFFFL
  };

  private final BrickCopy copy;
  private final Axis[] axes;

  /** The bricks of which an empty layer lies beside a solid one, a bit each. */
  private long within;

  /**
   * Creates a finder.
   *
   * @param copy the bricks
   * @param axes the axes across which terraces count
   */
  FlatBricks(BrickCopy copy, int[] axes) {
    this.copy = copy;
    this.axes = new Axis[axes.length];
    for (int n = 0; n < axes.length; n++) {
      this.axes[n] = new Axis(axes[n]);
    }
  }

  /** Returns the cells of the outermost layer of a brick on one side of an axis: 1 or -1. */
  static long outermost(int axis, int step) {
    return step < 0 ? FIRST_LAYER[axis] : FIRST_LAYER[axis] << (3 << (2 * axis));
  }

  /**
   * Takes over the bricks of a copy that was read anew.
   *
   * @param kept the bricks that were in the copy at the last call, a bit each
   * @param offset how much greater their number was there
   * @return the other bricks that hold a terrace, and the kept ones that turn out to hold one
   */
  long find(long kept, int offset) {
    within = moved(within, kept, offset);
    long unknown = ~kept;
    for (Axis axis : axes) {
      unknown |= axis.move(kept, offset);
    }
    addAll(~kept);
    long found = within;
    for (Axis axis : axes) {
      found |= axis.between();
    }
    for (Axis axis : axes) {
      axis.setOpen(unknown & ~found);
    }
    return unknown & found;
  }

  private static long moved(long bricks, long kept, int offset) {
    return kept & (offset >= 0 ? bricks >>> offset : bricks << -offset);
  }

  private void addAll(long bricks) {
    long empty = 0;
    long solid = 0;
    for (long left = bricks; left != 0; left &= left - 1) {
      long cells = copy.brick(Long.numberOfTrailingZeros(left));
      long bit = left & -left;
      if (cells == 0) {
        empty |= bit;
      } else if (cells == -1) {
        solid |= bit;
      } else {
        add(cells, bit);
      }
    }
    for (Axis axis : axes) {
      axis.addUniform(empty, solid);
    }
  }

  /** Adds a brick that is neither empty nor solid. */
  private void add(long cells, long bit) {
    int count = Long.bitCount(cells);
    boolean mayHaveEmptyLayer = count <= Long.SIZE - OF_LAYER;
    boolean mayHaveSolidLayer = count >= OF_LAYER;
    for (Axis axis : axes) {
      if (mayHaveEmptyLayer) {
        axis.addEmpty(cells, bit);
      }
      if (mayHaveSolidLayer) {
        axis.addSolid(cells, bit);
      }
      if (mayHaveEmptyLayer && mayHaveSolidLayer && axis.hasTerrace(cells)) {
        within |= bit;
      }
    }
  }

  /**
   * Returns the bricks whose terrace begins beside the copy, where a window reaches its rim, if
   * they were not returned before.
   *
   * @param x the window's first cell in the copy along x, as y and z
   */
  long findAtRim(CollisionScene scene, int x, int y, int z) {
    long found = 0;
    for (Axis axis : axes) {
      int low = axis.number == 0 ? x : axis.number == 1 ? y : z;
      if (low == 0) {
        found |= findBeside(scene, axis.number, -1, axis.takeOpen(-1));
      } else if (low == BrickCopy.ROOM) {
        found |= findBeside(scene, axis.number, 1, axis.takeOpen(1));
      }
    }
    return found;
  }

  /** Returns those of some bricks whose empty outermost layer lies beside a solid one. */
  private long findBeside(CollisionScene scene, int axis, int step, long bricks) {
    long found = 0;
    for (long left = bricks; left != 0; left &= left - 1) {
      int brick = Long.numberOfTrailingZeros(left);
      if (copy.areSolidBeside(scene, brick, axis, step, outermost(axis, -step))) {
        found |= left & -left;
      }
    }
    return found;
  }

  /** The outermost layers of all bricks across one axis. Words hold bricks, a bit each. */
  private static final class Axis {
    private final int number;

    /** The distance of neighbours along the axis in a word of bricks. */
    private final int stride;

    /** The bricks that have a lower neighbour in the copy. */
    private final long withLower;

    /** The bricks that have an upper neighbour in the copy. */
    private final long withUpper;

    private final long lowest;
    private final long highest;

    /** The bricks whose lowest layer is empty, and so on. */
    private long emptyLow;

    private long emptyHigh;
    private long solidLow;
    private long solidHigh;

    /**
     * The bricks whose lowest layer is empty and at the rim of the copy, while it is unknown
     * whether the layer beside it is solid.
     */
    private long openLow;

    /** The same for the highest layer. */
    private long openHigh;

    Axis(int number) {
      this.number = number;
      stride = 1 << (2 * number);
      withLower = neighbours(-1);
      withUpper = neighbours(1);
      lowest = outermost(number, -1);
      highest = outermost(number, 1);
    }

    private long neighbours(int step) {
      return BrickCopy.overlap(
          number == 0 ? step : 0, number == 1 ? step : 0, number == 2 ? step : 0);
    }

    /** Follows the copy; returns the kept bricks of which it is not known what lies beside them. */
    long move(long kept, int offset) {
      emptyLow = moved(emptyLow, kept, offset);
      emptyHigh = moved(emptyHigh, kept, offset);
      solidLow = moved(solidLow, kept, offset);
      solidHigh = moved(solidHigh, kept, offset);
      return moved(openLow | openHigh, kept, offset);
    }

    void addUniform(long empty, long solid) {
      emptyLow |= empty;
      emptyHigh |= empty;
      solidLow |= solid;
      solidHigh |= solid;
    }

    void addEmpty(long cells, long bit) {
      if ((cells & lowest) == 0) {
        emptyLow |= bit;
      }
      if ((cells & highest) == 0) {
        emptyHigh |= bit;
      }
    }

    void addSolid(long cells, long bit) {
      if ((~cells & lowest) == 0) {
        solidLow |= bit;
      }
      if ((~cells & highest) == 0) {
        solidHigh |= bit;
      }
    }

    /** Whether an empty layer of a brick lies beside a solid one. */
    boolean hasTerrace(long cells) {
      int empty = emptyLayers(cells, number);
      int solid = emptyLayers(~cells, number);
      return (empty & (solid << 1 | solid >> 1)) != 0;
    }

    /** Returns the bricks whose empty outermost layer lies beside a solid one of the copy. */
    long between() {
      return (emptyLow & solidHigh << stride & withLower)
          | (emptyHigh & solidLow >>> stride & withUpper);
    }

    /** Notes the bricks at the rim that may hold a terrace, out of some. */
    void setOpen(long bricks) {
      openLow = emptyLow & ~withLower & bricks;
      openHigh = emptyHigh & ~withUpper & bricks;
    }

    /** Returns the open bricks on one side, which are closed from now on. */
    long takeOpen(int step) {
      long taken = step < 0 ? openLow : openHigh;
      if (step < 0) {
        openLow = 0;
      } else {
        openHigh = 0;
      }
      return taken;
    }
  }

  /** Returns the layers of a brick across an axis that hold no set bit, a bit each. */
  static int emptyLayers(long brick, int axis) {
    return ~layersOf(brick, axis) & ALL_LAYERS;
  }

  private static int layersOf(long brick, int axis) {
    return switch (axis) {
      case 0 -> acrossX(alongZ(brick));
      case 1 -> acrossY(alongZ(brick));
      default -> acrossZ(brick);
    };
  }

  /** Unites the four layers across z. */
  private static int alongZ(long brick) {
    long halves = brick | brick >>> 32;
    return (int) (halves | halves >>> 16) & 0xFFFF;
  }

  private static int acrossX(int layer) {
    int halves = layer | layer >>> 8;
    return (halves | halves >>> 4) & ALL_LAYERS;
  }

  private static int acrossY(int layer) {
    return ((layer & 0xF) != 0 ? 1 : 0)
        | ((layer & 0xF0) != 0 ? 2 : 0)
        | ((layer & 0xF00) != 0 ? 4 : 0)
        | ((layer & 0xF000) != 0 ? 8 : 0);
  }

  private static int acrossZ(long brick) {
    long layer = FIRST_LAYER[2];
    return ((brick & layer) != 0 ? 1 : 0)
        | ((brick & layer << 16) != 0 ? 2 : 0)
        | ((brick & layer << 32) != 0 ? 4 : 0)
        | ((brick & layer << 48) != 0 ? 8 : 0);
  }
}
