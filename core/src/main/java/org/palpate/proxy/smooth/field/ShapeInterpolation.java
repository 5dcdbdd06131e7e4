package org.palpate.proxy.smooth.field;

/**
 * Shape-based interpolation between two slices: where a column that is solid in one slice and empty
 * in the next crosses the surface.
 *
 * <p>Let a be the distance of a column to the outline of the solid slice, and b that to the outline
 * of the next. The column crosses the surface at the fraction a / (a + b) of the way. The terraces
 * of an inclined plane thus become the plane, however long they are, if their ends are within
 * reach.
 *
 * <p>If the next slice has no outline within reach, the shape ends between the two. The end is
 * modelled as a parabola. It passes through both edges of a chord in this slice and both edges in
 * the slice before. An end with upright walls stays flat, half way.
 *
 * <p>References: Raya and Udupa 1990; Herman, Zheng and Bucholtz 1992.
 */
final class ShapeInterpolation {
  /** A terrace up to this length of cells is shorter than the smoothing and needs no scatter. */
  private static final double SCATTER_FROM_CELLS = 4;

  /** The further length over which the scatter grows to a whole cell. */
  private static final double SCATTER_RAMP_CELLS = 3;

  /** The two irrational steps of the lattice R2, times 2^32; Roberts 2018. */
  private static final int SCATTER_U = 0xC13F_A9A9;

  private static final int SCATTER_V = 0x91E1_0DA5;

  /** An outline that moves by less than this from slice to slice stands upright, pixels. */
  private static final double MIN_SHIFT = 0.25;

  /** The motion of an outline beyond the last slice if unknown, as a fraction of half the chord. */
  private static final double SHIFT_FRACTION = 0.55;

  /** The greatest height of an end with upright walls, as a fraction of the way. */
  private static final double FLAT_END = 0.5;

  /** The least height: the middle of a slice keeps its bits. */
  private static final double MIN_HEIGHT_CELLS = 1e-6;

  private final SliceOutline outline;
  private final double perVoxel;
  private final double reach;

  /** A terrace shorter than this needs no scatter, whatever rounding does; pixels. */
  private final double noScatterBelow;

  /**
   * Creates the interpolation.
   *
   * @param perVoxel the height of a voxel, in cells
   */
  ShapeInterpolation(SliceOutline outline, double perVoxel) {
    this.outline = outline;
    this.perVoxel = perVoxel;
    reach = outline.reach();
    noScatterBelow = 0.99 * SCATTER_FROM_CELLS * perVoxel;
  }

  /**
   * Returns how far column (u,v) is solid beyond the middle of a slice where it is solid, in cells:
   * more than 0, and no more than to the middle of the next slice, where it is empty.
   *
   * @param step to the next slice: 1 or -1
   * @param inside the distance to the outline of the solid slice, pixels
   * @param outside the distance to that of the next one
   */
  double heightCells(int u, int v, int slice, int step, double inside, double outside) {
    double cells = crossing(u, v, slice, step, inside, outside) * perVoxel;
    double scattered = cells + scatter(inside + outside, u, v);
    return Math.max(MIN_HEIGHT_CELLS, Math.min(perVoxel, scattered));
  }

  /** Returns the crossing as a fraction of the way from the solid slice to the next. */
  private double crossing(int u, int v, int slice, int step, double inside, double outside) {
    boolean known = inside < reach && outside < reach;
    if (known) {
      return inside / (inside + outside);
    }
    if (inside < reach) {
      return endBeyond(u, v, slice, slice - step, false, inside);
    }
    if (outside < reach) {
      return 1 - endBeyond(u, v, slice + step, slice + 2 * step, true, outside);
    }
    return FLAT_END;
  }

  /**
   * Returns how far a shape reaches beyond the last slice in which it has pixels, as a fraction of
   * the way to the next.
   *
   * @param before the slice on the other side of the last one
   * @param solid the kind of pixels outside of the shape
   * @param near the distance to the nearest edge of the chord
   */
  private double endBeyond(int u, int v, int last, int before, boolean solid, double near) {
    outline.coverAll(u >> 2, v >> 2, last);
    outline.coverAll(u >> 2, v >> 2, before);
    double far = outline.distanceOpposite(u, v, last, solid, near);
    double whole = outline.distance(u, v, before, solid);
    if (whole >= reach && far > reach - 1) {
      return near / (near + reach);
    }
    double half = 0.5 * (near + far);
    double least = whole < reach ? MIN_SHIFT : SHIFT_FRACTION * half;
    double shift = Math.max(least, whole - near);
    double sag = shift * (2 * half + shift);
    double top = half * half / sag;
    double height = Math.min(1, near * far / sag);
    return top <= 1 ? height : height * Math.max(FLAT_END, 1 / top);
  }

  /**
   * Returns what is added to the height of a column before it is rounded to cells. On terraces that
   * are longer than the smoothing is wide, heights are scattered evenly over a cell, so that
   * columns round to the right height on average.
   *
   * @param terrace the length of the terrace, pixels
   */
  private double scatter(double terrace, int u, int v) {
    if (terrace < noScatterBelow) {
      return 0;
    }
    double weight = (terrace / perVoxel - SCATTER_FROM_CELLS) / SCATTER_RAMP_CELLS;
    if (weight <= 0) {
      return 0;
    }
    int fraction = u * SCATTER_U + v * SCATTER_V; // of 2^32; overflow is meant
    return Math.min(1, weight) * fraction * 0x1p-32;
  }
}
