package org.palpate.elastic;

import java.util.Arrays;
import org.palpate.elastic.lattice.LatticeLayout;
import org.palpate.elastic.lattice.LatticeMatter;
import org.palpate.geometry.Vec3;

/**
 * Spreads a point force over the nodes around the point. The weight falls with the distance and
 * grows with the solid matter at a node, so that the force presses on solids and not on air.
 *
 * <p>One thread; allocates nothing after construction.
 */
final class ContactPatch {
  /** The reach of the weights over the radius. */
  private static final double REACH = 1.5;

  private final LatticeMatter matter;
  private final LatticeLayout layout;
  private final double reachMm;
  private final int[] nodes;
  private final float[] weights;
  private int count;
  private final double[] at = new double[3];
  private final double[] inward = new double[3];
  private final int[] low = new int[3];
  private final int[] high = new int[3];

  /**
   * Creates a patch that lies nowhere yet.
   *
   * @param radiusMm at least two thirds of the longest edge of a cell, so that nodes are in reach
   */
  ContactPatch(LatticeMatter matter, double radiusMm) {
    this.matter = matter;
    layout = matter.cells().layout();
    reachMm = REACH * radiusMm;
    int most = 1;
    for (int axis = 0; axis < 3; axis++) {
      double inReach = 2 * Math.ceil(reachMm / layout.edgeMm(axis)) + 1;
      most *= (int) Math.min(inReach, layout.cells(axis) + 1);
    }
    nodes = new int[most];
    weights = new float[most];
  }

  /** Lays the patch around a point in grid coordinates. */
  void place(Vec3 point) {
    for (int axis = 0; axis < 3; axis++) {
      at[axis] = (point.get(axis) - layout.originVoxel(axis)) / layout.voxelsPerCell(axis);
      double reach = reachMm / layout.edgeMm(axis);
      low[axis] = (int) Math.max(0, Math.ceil(at[axis] - reach));
      high[axis] = (int) Math.min(layout.cells(axis), Math.floor(at[axis] + reach));
    }
    collect();
    normalize();
  }

  private void collect() {
    count = 0;
    for (int z = low[2]; z <= high[2]; z++) {
      for (int y = low[1]; y <= high[1]; y++) {
        for (int x = low[0]; x <= high[0]; x++) {
          double weight = weight(x, y, z);
          if (weight > 0) {
            nodes[count] = layout.node(x, y, z);
            weights[count] = (float) weight;
            count++;
          }
        }
      }
    }
  }

  private double weight(int x, int y, int z) {
    double dx = (x - at[0]) * layout.edgeMm(0);
    double dy = (y - at[1]) * layout.edgeMm(1);
    double dz = (z - at[2]) * layout.edgeMm(2);
    double part = Math.sqrt(dx * dx + dy * dy + dz * dz) / reachMm;
    return part >= 1
        ? 0
        : (1 - part) * (1 - part) * (1 + 2 * part) * matter.solidModulusAround(x, y, z);
  }

  /** Makes the weights sum to 1, and finds the direction towards the solid matter. */
  private void normalize() {
    double sum = 0;
    for (int n = 0; n < count; n++) {
      sum += weights[n];
    }
    Arrays.fill(inward, 0);
    for (int n = 0; n < count; n++) {
      weights[n] /= (float) sum;
      for (int axis = 0; axis < 3; axis++) {
        double way = (layout.nodeIndex(axis, nodes[n]) - at[axis]) * layout.edgeMm(axis);
        inward[axis] += weights[n] * way;
      }
    }
  }

  /** Whether no solid matter lies within reach. */
  boolean isEmpty() {
    return count == 0;
  }

  /** Returns the vector from the point to the centre of the patch, mm. */
  double[] inward() {
    return inward;
  }

  /** Adds a force along an axis to a vector of forces, but not to fixed nodes. */
  void addForce(int axis, double newton, float[] dest) {
    for (int n = 0; n < count; n++) {
      if (!matter.cells().isFixed(nodes[n])) {
        dest[axis * layout.nodeCount() + nodes[n]] += weights[n] * (float) newton;
      }
    }
  }
}
