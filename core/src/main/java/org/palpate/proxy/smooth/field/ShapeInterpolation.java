package org.palpate.proxy.smooth.field;

/**
 * Shape-based interpolation between two slices: where a column that is solid in one slice and empty
 * in the next crosses the surface.
 *
 * <p>Let a be the distance of a column to the outline of the solid slice, and b that to the outline
 * of the next. The column crosses the surface at the fraction a / (a + b) of the way. The terraces
 * of an inclined plane thus become the plane, however long they are, if their ends are within
 * reach. On long terraces the outlines of the slices before and behind bend the surface.
 *
 * <p>If the next slice has no outline within reach, the shape ends between the two. The end is
 * modelled as a parabola. It passes through both edges of a chord in this slice and both edges in
 * the slice before. An end with upright walls stays flat, half way.
 *
 * <p>References: Raya and Udupa 1990; Herman, Zheng and Bucholtz 1992.
 */
final class ShapeInterpolation {
  /**
   * The least length of a terrace whose bend counts, in pixels. On shorter ones outlines are too
   * rough to show a bend, and a search for two more of them is not worth its time.
   */
  private static final double MIN_BENT_PIXELS = 4;

  /** The greatest bend, which moves the middle of a terrace by an eighth of the way. */
  private static final double MAX_BEND = 0.5;

  /** A distance that does not bend a surface. */
  static final double UNKNOWN = 0;

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

  /** The least length of a terrace whose bend counts, in shortest voxel edges. */
  private final double minBent;

  /**
   * Creates the interpolation.
   *
   * @param perVoxel the height of a voxel, in cells
   */
  ShapeInterpolation(SliceOutline outline, double perVoxel) {
    this.outline = outline;
    this.perVoxel = perVoxel;
    reach = outline.reach();
    minBent = MIN_BENT_PIXELS * outline.longestPixelEdge();
  }

  /**
   * Returns the columns whose height depends on the outlines before and behind as well.
   *
   * @param inside the distances to the outline of the solid slice, shortest voxel edges
   * @param outside the distances to that of the next one
   */
  int bentColumns(int columns, double[] inside, double[] outside) {
    int bent = 0;
    for (int left = columns; left != 0; left &= left - 1) {
      int column = Integer.numberOfTrailingZeros(left);
      double a = inside[column];
      double b = outside[column];
      bent |= a < reach && b < reach && a + b >= minBent ? 1 << column : 0;
    }
    return bent;
  }

  /**
   * Returns how far column (u,v) is solid beyond the middle of a slice where it is solid, in cells:
   * more than 0, and no more than to the middle of the next slice, where it is empty. Distances are
   * in shortest voxel edges.
   *
   * @param step to the next slice: 1 or -1
   * @param inside the distance to the outline of the solid slice
   * @param outside the distance to that of the next one
   * @param before the distance to that of the slice before the solid one, or {@link #UNKNOWN}
   * @param behind the distance to that of the slice behind the next one, or {@link #UNKNOWN}
   */
  double heightCells(
      int u,
      int v,
      int slice,
      int step,
      double inside,
      double outside,
      double before,
      double behind) {
    double fraction;
    if (inside < reach && outside < reach) {
      fraction = bent(inside, outside, before, behind);
    } else if (inside < reach) {
      fraction = endBeyond(u, v, slice, slice - step, false, inside);
    } else if (outside < reach) {
      fraction = 1 - endBeyond(u, v, slice + step, slice + 2 * step, true, outside);
    } else {
      fraction = FLAT_END;
    }
    return Math.max(MIN_HEIGHT_CELLS, Math.min(perVoxel, fraction * perVoxel));
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
   * @param before the slice on the other side of the last one
   * @param solid the kind of pixels outside of the shape
   * @param near the distance to the nearest edge of the chord
   */
  private double endBeyond(int u, int v, int last, int before, boolean solid, double near) {
    outline.coverAll(u >> 2, v >> 2, last);
    outline.coverAll(u >> 2, v >> 2, before);
    double far = outline.distanceOpposite(u, v, last, solid);
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
}
