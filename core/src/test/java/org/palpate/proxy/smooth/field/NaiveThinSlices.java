package org.palpate.proxy.smooth.field;

import java.util.ArrayList;
import java.util.List;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.Vec3;

/**
 * Shape-based interpolation between slices written down as its definition says: a test oracle.
 * Every cell is computed for itself, and every pixel within reach is looked at.
 */
final class NaiveThinSlices {
  private final CollisionScene scene;
  private final int axis;
  private final double perVoxel;
  private final int reach;

  /** The pixel that {@link #findNearest} found, less the one from which it searched. */
  private int nearestU;

  private int nearestV;

  NaiveThinSlices(CollisionScene scene, int axis, double perVoxel, int reach) {
    this.scene = scene;
    this.axis = axis;
    this.perVoxel = perVoxel;
    this.reach = reach;
  }

  /** Whether a cell is solid. */
  boolean isSolid(int x, int y, int z) {
    return switch (axis) {
      case 0 -> isSolidCell(z, y, x);
      case 1 -> isSolidCell(x, z, y);
      default -> isSolidCell(x, y, z);
    };
  }

  /**
   * Returns the cells that may be seeds for a voxel, given its middle: the one that holds the
   * middle, the next, the one before, and so on.
   */
  static int[][] seeds(Vec3 middle, ThinGrid grid) {
    List<int[]> seeds = new ArrayList<>();
    double voxel = Math.floor(middle.get(grid.axis()));
    int first = (int) Math.floor((voxel + 0.5) * grid.perVoxel());
    for (int step : new int[] {0, 1, -1, 2, -2, 3, -3}) {
      int[] cell = {
        (int) Math.floor(middle.x), (int) Math.floor(middle.y), (int) Math.floor(middle.z)
      };
      cell[grid.axis()] = first + step;
      if (Math.floor((first + step + 0.5) / grid.perVoxel()) == voxel) {
        seeds.add(cell);
      }
    }
    return seeds.toArray(new int[0][]);
  }

  private boolean isSolidVoxel(int u, int v, int slice) {
    return switch (axis) {
      case 0 -> scene.isSolid(slice, v, u);
      case 1 -> scene.isSolid(u, slice, v);
      default -> scene.isSolid(u, v, slice);
    };
  }

  private boolean isSolidCell(int u, int v, int cell) {
    int lower = (int) Math.floor(cell / perVoxel) - 3;
    while (fromMiddle(cell, lower + 1) >= 0) {
      lower++;
    }
    boolean solidBelow = isSolidVoxel(u, v, lower);
    boolean solidAbove = isSolidVoxel(u, v, lower + 1);
    if (solidBelow == solidAbove) {
      return solidBelow;
    }
    int solidSlice = solidBelow ? lower : lower + 1;
    double height = height(u, v, solidSlice, solidBelow ? 1 : -1);
    return Math.abs(fromMiddle(cell, solidSlice)) < height;
  }

  /** Returns how far a cell's centre lies beyond the middle of a slice, in cells. */
  private double fromMiddle(int cell, int slice) {
    return cell + 0.5 - (slice + 0.5) * perVoxel;
  }

  private double height(int u, int v, int slice, int step) {
    double inside = distance(u, v, slice, false);
    double outside = distance(u, v, slice + step, true);
    double fraction;
    if (inside < reach && outside < reach) {
      fraction = inside / (inside + outside);
    } else if (inside < reach) {
      fraction = end(u, v, slice, slice - step, false);
    } else if (outside < reach) {
      fraction = 1 - end(u, v, slice + step, slice + 2 * step, true);
    } else {
      fraction = 0.5;
    }
    double longTerrace = ((inside + outside) / perVoxel - 4) / 3;
    double scatter = Math.max(0, Math.min(1, longTerrace)) * lattice(u, v);
    return Math.max(1e-6, Math.min(perVoxel, fraction * perVoxel + scatter));
  }

  /** Returns a number from -0.5 to 0.5: both coordinates times irrational numbers, modulo 1. */
  private static double lattice(int u, int v) {
    long sum = (long) u * 0xC13FA9A9L + (long) v * 0x91E10DA5L;
    return (int) sum / 4294967296.0;
  }

  /** The parabola through the edges of a chord in the last slice and in the one before. */
  private double end(int u, int v, int last, int before, boolean solid) {
    double near = distance(u, v, last, solid);
    double far = distanceOpposite(u, v, last, solid);
    double whole = distance(u, v, before, solid);
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

  /** Returns the distance to the nearest pixel of a kind, less half a pixel, at most the reach. */
  private double distance(int u, int v, int slice, boolean solid) {
    return Math.min(reach, Math.sqrt(findNearest(u, v, slice, solid)) - 0.5);
  }

  /** Finds the nearest pixel: of equals the one of least |dv|, then low v, then high u. */
  private int findNearest(int u, int v, int slice, boolean solid) {
    int best = (reach + 1) * (reach + 1);
    for (int off = 0; off <= reach; off++) {
      for (int dv : new int[] {-off, off}) {
        for (int along = 0; along <= reach; along++) {
          for (int du : new int[] {along, -along}) {
            int square = du * du + dv * dv;
            if (square < best && isSolidVoxel(u + du, v + dv, slice) == solid) {
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
    findNearest(u, v, slice, solid);
    double scale = 1 / Math.sqrt(nearestU * nearestU + nearestV * nearestV);
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
