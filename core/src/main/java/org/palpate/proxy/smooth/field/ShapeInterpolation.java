package org.palpate.proxy.smooth.field;

import java.util.Arrays;

/**
 * Shape-based interpolation between two slices: where a column that is solid in one slice and empty
 * in the next crosses the surface.
 *
 * <p>Let a be the distance of a column to the outline of the solid slice, and b that to the outline
 * of the next. The column crosses the surface at the fraction a / (a + b) of the way. The terraces
 * of an inclined plane thus become the plane, however long they are, if their ends are within
 * reach. On long terraces the outlines of the slices before and behind bend the surface.
 *
 * <p>A wall one slice thick is a strip in each slice, and its strip in the next slice lies beside
 * that one. Distance a then has to lead to the other edge of the strip. It therefore leads to the
 * nearest column that is empty in both slices. Without a wall, this is the nearest empty one
 * anyway.
 *
 * <p>If the next slice has no outline within reach, the shape ends between the two. The end is
 * modelled as a parabola. It passes through both edges of a chord in this slice and both edges in
 * the slice before. An end with upright walls stays flat, half way.
 *
 * <p>References: Raya and Udupa 1990; Herman, Zheng and Bucholtz 1992.
 */
final class ShapeInterpolation {
  /** The columns of a tile. */
  static final int COLUMNS = 16;

  /** The greatest bend, which moves the middle of a terrace by an eighth of the way. */
  private static final double MAX_BEND = 0.5;

  /** A distance that does not bend a surface. */
  private static final double UNKNOWN = 0;

  /** An outline that moves by less than this from slice to slice stands upright, pixels. */
  private static final double MIN_SHIFT = 0.25;

  /** The motion of an outline beyond the last slice if unknown, as a fraction of half the chord. */
  private static final double SHIFT_FRACTION = 0.55;

  /** The greatest height of an end with upright walls, as a fraction of the way. */
  private static final double FLAT_END = 0.5;

  /**
   * The height that is added against rounding. Two columns side by side that come from either slice
   * and end half way then leave no gap between them.
   */
  private static final double OVERLAP_CELLS = 1e-6;

  private final SliceBits slices;
  private final SliceOutline outline;
  private final double perVoxel;
  private final double reach;

  /**
   * For each column of a tile, the distance to the outline around what is solid in any of the two
   * slices, in shortest voxel edges.
   */
  private final double[] inside = new double[COLUMNS];

  /** The distance to the outline of the slice where the column is empty. */
  private final double[] outside = new double[COLUMNS];

  /**
   * The distance to the outline of the slice before the solid one, where the column is solid there
   * too.
   */
  private final double[] before = new double[COLUMNS];

  /** The same for the slice behind the empty one, where the column is empty there too. */
  private final double[] behind = new double[COLUMNS];

  /** The least length of a terrace whose bend counts, in shortest voxel edges. */
  private final double minBent;

  /** Half the longer edge of a pixel: an outline may be this far before the middle of its pixel. */
  private final double halfEdge;

  private int decidingPixels;

  /**
   * Creates the interpolation between the slices of some voxels.
   *
   * @param edges the edges of a pixel
   * @param reach of searches for the outline, in shortest voxel edges, see {@link SliceOutline}
   * @param perVoxel the height of a voxel, in cells
   * @param minBentPixels the least length of a terrace whose bend counts
   */
  ShapeInterpolation(
      SliceBits slices, PixelEdges edges, int reach, double perVoxel, double minBentPixels) {
    this.slices = slices;
    this.perVoxel = perVoxel;
    this.reach = reach;
    outline = new SliceOutline(slices, edges, reach);
    minBent = minBentPixels * outline.longestPixelEdge();
    halfEdge = 0.5 * outline.longestPixelEdge();
  }

  /**
   * Returns how many bricks beside a tile's own along u and v its heights depend on, at most.
   * Across the slices they depend on the two slices and on the next one on either side.
   */
  int reachBricks() {
    return outline.reachBricks();
  }

  /**
   * Writes how far columns of a tile are solid beyond the middle of a slice where they are solid,
   * in cells: more than 0, and no more than to the middle of the next slice, where they are empty.
   *
   * @param brickU the brick coordinate of the tile along u
   * @param step to the next slice: 1 or -1
   * @param columns the columns, a bit each
   * @param heights receives a height for each of them
   */
  void findHeights(
      int brickU, int brickV, int solidSlice, int step, int columns, double[] heights) {
    int next = solidSlice + step;
    outline.measure(brickU, brickV, solidSlice, next, false, columns, inside);
    outline.measure(brickU, brickV, next, next, true, columns, outside);
    measureBeyond(brickU, brickV, solidSlice, step, bentColumns(columns));
    double farthest = 0;
    for (int left = columns; left != 0; left &= left - 1) {
      int column = Integer.numberOfTrailingZeros(left);
      int u = 4 * brickU + (column & 3);
      int v = 4 * brickV + (column >> 2);
      double height = perVoxel * fraction(u, v, solidSlice, step, column);
      heights[column] = Math.min(perVoxel, height + OVERLAP_CELLS);
      farthest = Math.max(farthest, farthestOf(column));
    }
    // Half of a long edge may exceed the reach.
    int pixels = farthest < reach ? (int) Math.ceil(farthest + halfEdge) : reachPixels();
    decidingPixels = Math.min(pixels, reachPixels());
  }

  /** Returns the distance to the farthest outline that a height depends on. */
  private double farthestOf(int column) {
    return Math.max(
        Math.max(inside[column], outside[column]), Math.max(before[column], behind[column]));
  }

  /**
   * Returns how many pixels around the tile, along u and v, decided about the heights that were
   * found last. Pixels farther away may change without changing a height.
   */
  int decidingPixels() {
    return decidingPixels;
  }

  /** Returns the most that {@link #decidingPixels} may be. */
  private int reachPixels() {
    return 4 * outline.reachBricks();
  }

  /** Returns the columns whose height depends on the outlines before and behind as well. */
  private int bentColumns(int columns) {
    int bent = 0;
    for (int left = columns; left != 0; left &= left - 1) {
      int column = Integer.numberOfTrailingZeros(left);
      double a = inside[column];
      double b = outside[column];
      bent |= a < reach && b < reach && a + b >= minBent ? 1 << column : 0;
    }
    return bent;
  }

  /** Measures the outlines before the solid slice and behind the empty one, for some columns. */
  private void measureBeyond(int brickU, int brickV, int solidSlice, int step, int columns) {
    Arrays.fill(before, UNKNOWN);
    Arrays.fill(behind, UNKNOWN);
    if (columns == 0) {
      return;
    }
    int slice = solidSlice - step;
    int solidBefore = columns & slices.pixels(brickU, brickV, slice);
    if (solidBefore != 0) {
      outline.measure(brickU, brickV, slice, slice, false, solidBefore, before);
    }
    slice = solidSlice + 2 * step;
    int emptyBehind = columns & ~slices.pixels(brickU, brickV, slice);
    if (emptyBehind != 0) {
      outline.measure(brickU, brickV, slice, slice, true, emptyBehind, behind);
    }
  }

  /** Returns the crossing of column (u,v) as a fraction of the way to the next slice. */
  private double fraction(int u, int v, int slice, int step, int column) {
    double a = inside[column];
    double b = outside[column];
    if (a < reach && b < reach) {
      return bent(a, b, before[column], behind[column]);
    }
    if (a < reach) {
      return endBeyond(u, v, slice, slice - step, false, a);
    }
    if (b < reach) {
      return 1 - endBeyond(u, v, slice + step, slice + 2 * step, true, b);
    }
    return FLAT_END;
  }

  /**
   * Returns the crossing as a fraction of the way from the solid slice to the next. A surface that
   * bends along the long axis is a parabola through the outlines of both slices and that of the
   * slice on either side, or the mean of two such parabolas.
   */
  private double bent(double inside, double outside, double before, double behind) {
    double terrace = inside + outside;
    double straight = inside / terrace;
    double most = MAX_BEND / (terrace * terrace);
    double bend = 0;
    int known = 0;
    if (before > inside && before < reach) {
      double excess = (before - inside) / terrace - 1;
      bend += clamp(excess / ((before - inside) * (before + outside)), most);
      known++;
    }
    if (behind > outside && behind < reach) {
      double excess = 1 - (behind - outside) / terrace;
      bend += clamp(excess / ((behind + inside) * (behind - outside)), most);
      known++;
    }
    return known == 0 ? straight : straight - bend / known * inside * outside;
  }

  private static double clamp(double value, double limit) {
    return Math.max(-limit, Math.min(limit, value));
  }

  /**
   * Returns how far a shape reaches beyond the last slice in which it has pixels, as a fraction of
   * the way to the next.
   *
   * @param before the slice on the other side of the last one; where it is hollow below the last
   *     one, it counts as filled
   * @param solid the kind of pixels outside of the shape
   * @param near the distance to the nearest edge of the chord
   */
  private double endBeyond(int u, int v, int last, int before, boolean solid, double near) {
    outline.coverAll(u >> 2, v >> 2, last);
    outline.coverAll(u >> 2, v >> 2, before);
    double far = outline.distanceOpposite(u, v, last, solid);
    double whole = outline.distance(u, v, before, last, solid);
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
}
