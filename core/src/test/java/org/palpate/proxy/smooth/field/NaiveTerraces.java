package org.palpate.proxy.smooth.field;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.smooth.field.NaiveOccupancyField.Cells;

/**
 * The corrections of cells on wide terraces written down as their definition says: a test oracle.
 * Every cell looks at its own tiles.
 */
final class NaiveTerraces {
  private final Cells cells;
  private final ThinGrid grid;
  private final Vec3 cellEdges;
  private final Map<List<Integer>, Double> known = new HashMap<>();

  NaiveTerraces(Cells cells, ThinGrid grid, Vec3 edges) {
    this.cells = cells;
    this.grid = grid;
    cellEdges = grid.cellEdges(edges);
  }

  /** Returns by how much the occupancy of a cell differs from its bit. */
  double correction(int x, int y, int z) {
    return known.computeIfAbsent(List.of(x, y, z), cell -> compute(new int[] {x, y, z}));
  }

  private double compute(int[] cell) {
    double sum = 0;
    for (int axis = 0; axis < 3 && grid.cuts().size() < 2; axis++) {
      if (grid.perVoxel(axis) == 1) {
        sum += alongAxis(cell, axis, 1) + alongAxis(cell, axis, -1);
      }
    }
    return sum;
  }

  private double alongAxis(int[] cell, int axis, int step) {
    int u = axis == 0 ? 2 : 0;
    int v = axis == 1 ? 2 : 1;
    int lowU = cell[u] & ~3;
    int lowV = cell[v] & ~3;
    int solid = cell[axis] - step;
    if (!at(axis, cell[u], cell[v], solid)) {
      return 0;
    }
    for (int n = 0; n < 16; n++) {
      int atU = lowU + n % 4;
      int atV = lowV + n / 4;
      if (at(axis, atU, atV, cell[axis]) || !at(axis, atU, atV, solid)) {
        return 0;
      }
    }
    NaiveThinSlices slices = NaiveThinSlices.ofWholeCells(cells, axis, cellEdges);
    double[] first = new double[2];
    for (int n = 0; n < 2; n++) {
      double near = slices.height(lowU, lowV + 3 * n, solid, step);
      double far = slices.height(lowU + 3, lowV + 3 * n, solid, step);
      first[n] = between(near, far, cell[u] & 3);
    }
    double height = between(first[0], first[1], cell[v] & 3);
    return Math.floor(32 * (height - 0.5) + 0.5) / 32;
  }

  /** Returns the value at position n of four, given those at both ends. */
  private static double between(double first, double last, int n) {
    return switch (n) {
      case 0 -> first;
      case 1 -> first + (last - first) / 3;
      case 2 -> last + (first - last) / 3;
      default -> last;
    };
  }

  private boolean at(int axis, int u, int v, int layer) {
    return switch (axis) {
      case 0 -> cells.isSolid(layer, v, u);
      case 1 -> cells.isSolid(u, layer, v);
      default -> cells.isSolid(u, v, layer);
    };
  }
}
