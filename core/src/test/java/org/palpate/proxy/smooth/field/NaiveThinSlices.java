package org.palpate.proxy.smooth.field;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.smooth.field.NaiveOccupancyField.Cells;

/**
 * Shape-based interpolation between two slices written down as its definition says: a test oracle.
 * Every cell is computed for itself, and every pixel within reach is looked at.
 */
final class NaiveThinSlices implements Cells {
  private final Cells cells;
  private final int axis;
  private final double perVoxel;
  private final boolean isLast;
  private final int reach;

  /** The least length of a terrace that is bent, pixels. */
  private final double minBent;

  /** The edges of a pixel along u and v, in shortest voxel edges. */
  private final double edgeU;

  private final double edgeV;

  /** The cells that were computed already. */
  private final Map<List<Integer>, Boolean> known = new HashMap<>();

  /** The pixel that {@link #findNearest} found, less the one from which it searched. */
  private int nearestU;

  private int nearestV;

  /** Creates the thin slices of one cut through cells of some edges. */
  private NaiveThinSlices(
      Cells cells, AxisCut cut, boolean isLast, Vec3 edges, int reach, double minBent) {
    this.cells = cells;
    this.isLast = isLast;
    this.reach = reach;
    this.minBent = minBent;
    axis = cut.axis();
    perVoxel = cut.perVoxel();
    edgeU = edges.get(axis == 0 ? 2 : 0);
    edgeV = edges.get(axis == 1 ? 2 : 1);
  }

  /** Returns the cells of a grid that are no voxels; the edges are in shortest edges. */
  static NaiveThinSlices of(Cells voxels, ThinGrid grid, Vec3 edges) {
    Cells cells = voxels;
    NaiveThinSlices slices = null;
    double[] left = {edges.x, edges.y, edges.z};
    for (AxisCut cut : grid.cuts()) {
      int reach = Math.min(slices == null ? 24 : 12, 4 * (int) Math.ceil(2 * cut.perVoxel()));
      boolean isLast = grid.cuts().indexOf(cut) == grid.cuts().size() - 1;
      Vec3 pixels = new Vec3(left[0], left[1], left[2]);
      slices = new NaiveThinSlices(cells, cut, isLast, pixels, reach, 4);
      cells = slices;
      left[cut.axis()] /= cut.perVoxel();
    }
    return slices;
  }

  /** Returns the slices of cells that are not cut along an axis; terraces on them are not bent. */
  static NaiveThinSlices ofWholeCells(Cells cells, int axis, Vec3 edges) {
    AxisCut whole = new AxisCut(axis, 1);
    return new NaiveThinSlices(cells, whole, true, edges, 16, Double.POSITIVE_INFINITY);
  }

  /** Returns the axis along which the cells were cut last. */
  int axis() {
    return axis;
  }

  @Override
  public boolean isSolid(int x, int y, int z) {
    List<Integer> cell = List.of(x, y, z);
    Boolean before = known.get(cell);
    boolean solid = before != null ? before : compute(x, y, z);
    known.put(cell, solid);
    return solid;
  }

  private boolean compute(int x, int y, int z) {
    return switch (axis) {
      case 0 -> isSolidCell(z, y, x);
      case 1 -> isSolidCell(x, z, y);
      default -> isSolidCell(x, y, z);
    };
  }

  /**
   * Returns the cells that may be seeds for a voxel, given its middle. Along each cut they are the
   * one that holds the middle, the next, the one before, and so on; those along the last cut follow
   * one another.
   */
  static int[][] seeds(Vec3 middle, ThinGrid grid) {
    List<int[]> seeds = new ArrayList<>();
    seeds.add(new int[] {floor(middle.x), floor(middle.y), floor(middle.z)});
    for (AxisCut cut : grid.cuts()) {
      List<int[]> cutSeeds = new ArrayList<>();
      double voxel = Math.floor(middle.get(cut.axis()));
      int first = floor((voxel + 0.5) * cut.perVoxel());
      for (int[] seed : seeds) {
        for (int step : new int[] {0, 1, -1, 2, -2, 3, -3, 4, -4, 5, -5, 6, -6}) {
          int[] cell = seed.clone();
          cell[cut.axis()] = first + step;
          if (Math.floor((first + step + 0.5) / cut.perVoxel()) == voxel) {
            cutSeeds.add(cell);
          }
        }
      }
      seeds = cutSeeds;
    }
    return seeds.toArray(new int[0][]);
  }

  private static int floor(double value) {
    return (int) Math.floor(value);
  }

  private boolean isSolidVoxel(int u, int v, int slice) {
    return switch (axis) {
      case 0 -> cells.isSolid(slice, v, u);
      case 1 -> cells.isSolid(u, slice, v);
      default -> cells.isSolid(u, v, slice);
    };
  }

  private boolean isSolidCell(int u, int v, int cell) {
    int lower = pairOf(cell);
    boolean solidBelow = isSolidVoxel(u, v, lower);
    boolean solidAbove = isSolidVoxel(u, v, lower + 1);
    if (solidBelow == solidAbove) {
      return solidBelow;
    }
    int solidSlice = solidBelow ? lower : lower + 1;
    double height = height(u, v, solidSlice, solidBelow ? 1 : -1);
    return Math.abs(fromMiddle(cell, solidSlice)) < betweenMiddles(height);
  }

  /**
   * Returns a height that leaves their bits to the cells that hold the middles of both voxels, if
   * this is the last cut.
   */
  private double betweenMiddles(double height) {
    if (!isLast) {
      return height;
    }
    double half = 0.5 + 1e-6;
    return Math.max(half, Math.min(perVoxel - half, height));
  }

  /** Returns the lower of the two slices between whose middles the centre of a cell lies. */
  private int pairOf(int cell) {
    int lower = (int) Math.floor(cell / perVoxel) - 3;
    while (fromMiddle(cell, lower + 1) >= 0) {
      lower++;
    }
    return lower;
  }

  /**
   * Returns the solid fraction of a cell, in steps of 1/32. Of a column that ends between two
   * slices, one cell makes up for the rounding: the first empty one if the cells are too short in
   * all, and else the last solid one.
   */
  double occupancy(int x, int y, int z) {
    return switch (axis) {
      case 0 -> occupancyOfCell(z, y, x);
      case 1 -> occupancyOfCell(x, z, y);
      default -> occupancyOfCell(x, y, z);
    };
  }

  private double occupancyOfCell(int u, int v, int cell) {
    int lower = pairOf(cell);
    boolean solidBelow = isSolidVoxel(u, v, lower);
    int whole = isSolidCell(u, v, cell) ? 1 : 0;
    if (solidBelow == isSolidVoxel(u, v, lower + 1)) {
      return whole;
    }
    int first = cell;
    while (pairOf(first - 1) == lower) {
      first--;
    }
    int end = cell + 1;
    while (pairOf(end) == lower) {
      end++;
    }
    int step = solidBelow ? 1 : -1;
    int near = solidBelow ? first : end - 1;
    int solid = 0;
    while (solid < end - first && isSolidCell(u, v, near + step * solid)) {
      solid++;
    }
    int solidSlice = solidBelow ? lower : lower + 1;
    double length =
        height(u, v, solidSlice, step) - (step * fromMiddle(near, solidSlice) - 0.5) - solid;
    double correction = Math.floor(32 * length + 0.5) / 32;
    int corrected = correction > 0 ? Math.min(solid, end - first - 1) : Math.max(solid - 1, 0);
    return whole + (cell == near + step * corrected ? correction : 0);
  }

  /** Returns how far a cell's centre lies beyond the middle of a slice, in cells. */
  private double fromMiddle(int cell, int slice) {
    return cell + 0.5 - (slice + 0.5) * perVoxel;
  }

  /** Returns how far a column is solid beyond the middle of a slice, in cells. */
  double height(int u, int v, int slice, int step) {
    double inside = distanceInBoth(u, v, slice, slice + step, false);
    double outside = distance(u, v, slice + step, true);
    double fraction;
    if (inside < reach && outside < reach) {
      fraction =
          inside + outside < minBent * Math.max(edgeU, edgeV)
              ? inside / (inside + outside)
              : bent(u, v, slice, step, inside, outside);
    } else if (inside < reach) {
      fraction = end(u, v, slice, slice - step, false);
    } else if (outside < reach) {
      fraction = 1 - end(u, v, slice + step, slice + 2 * step, true);
    } else {
      fraction = 0.5;
    }
    return Math.min(perVoxel, fraction * perVoxel + 1e-6);
  }

  /** The parabola through two outlines and a third one, as far as those are known. */
  private double bent(int u, int v, int slice, int step, double inside, double outside) {
    double straight = inside / (inside + outside);
    double before = distance(u, v, slice - step, false);
    double behind = distance(u, v, slice + 2 * step, true);
    double terrace = inside + outside;
    double most = 0.5 / (terrace * terrace);
    List<Double> bends = new ArrayList<>();
    if (before > inside && before < reach) {
      double excess = (before - inside) / terrace - 1;
      bends.add(excess / ((before - inside) * (before + outside)));
    }
    if (behind > outside && behind < reach) {
      double excess = 1 - (behind - outside) / terrace;
      bends.add(excess / ((behind + inside) * (behind - outside)));
    }
    double sum = 0;
    for (double bend : bends) {
      sum += Math.max(-most, Math.min(most, bend));
    }
    return bends.isEmpty() ? straight : straight - sum / bends.size() * inside * outside;
  }

  /** The parabola through the edges of a chord in the last slice and in the one before. */
  private double end(int u, int v, int last, int before, boolean solid) {
    double near = distance(u, v, last, solid);
    double far = distanceOpposite(u, v, last, solid);
    double whole = distanceInBoth(u, v, before, last, solid);
    if (whole >= reach && far > reach - 1) {
      return near / (near + reach);
    }
    double half = 0.5 * (near + far);
    double least = whole < reach ? 0.25 : 0.55 * half;
    double shift = Math.max(least, whole - near);
    double sag = shift * (2 * half + shift);
    double top = half * half / sag;
    double height = Math.min(1, near * far / sag);
    return top <= 1 ? height : height * Math.max(0.5, 1 / top);
  }

  /**
   * Returns the distance to the nearest pixel of a kind, less half a pixel on the way there, at
   * most the reach; -0.5 if the pixel is of that kind itself.
   */
  private double distance(int u, int v, int slice, boolean solid) {
    return distanceInBoth(u, v, slice, slice, solid);
  }

  /** Returns the same for the nearest pixel that is of a kind in two slices. */
  private double distanceInBoth(int u, int v, int slice, int other, boolean solid) {
    double length = Math.sqrt(findNearest(u, v, slice, other, solid));
    if (length >= reach + 1) {
      return reach;
    }
    if (length == 0) {
      return -0.5;
    }
    double pixel = length / Math.sqrt(nearestU * nearestU + nearestV * nearestV);
    return Math.min(reach, length - 0.5 * pixel);
  }

  /**
   * Finds the nearest pixel: of equals the one of least |dv|, then low v, then high u. Returns the
   * square of its distance, in shortest edges; that of a pixel beyond the reach if there is none.
   */
  private double findNearest(int u, int v, int slice, int other, boolean solid) {
    double best = (reach + 1) * (reach + 1);
    for (int off = 0; off <= reach; off++) {
      for (int dv : new int[] {-off, off}) {
        for (int along = 0; along <= reach; along++) {
          for (int du : new int[] {along, -along}) {
            double square = du * du * (edgeU * edgeU) + dv * dv * (edgeV * edgeV);
            if (square < best
                && isSolidVoxel(u + du, v + dv, slice) == solid
                && isSolidVoxel(u + du, v + dv, other) == solid) {
              best = square;
              nearestU = du;
              nearestV = dv;
            }
          }
        }
      }
    }
    return best;
  }

  private double distanceOpposite(int u, int v, int slice, boolean solid) {
    double scale = 1 / Math.sqrt(findNearest(u, v, slice, slice, solid));
    for (int steps = 1; steps < reach; steps++) {
      int du = (int) Math.floor(steps * scale * nearestU + 0.5);
      int dv = (int) Math.floor(steps * scale * nearestV + 0.5);
      if (isSolidVoxel(u - du, v - dv, slice) == solid) {
        return steps - 0.5;
      }
    }
    return reach - 0.5;
  }
}
