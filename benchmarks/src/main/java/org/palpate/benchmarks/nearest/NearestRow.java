package org.palpate.benchmarks.nearest;

import java.util.List;

/**
 * The distance of a solver's resting points beyond the nearest free point.
 *
 * @param shape the kind of solid
 * @param depth the depth of the device below the true surface, voxels
 * @param solver the name of the solver or of the search
 * @param meanExcess mean of |p-d| minus the distance to the nearest free point, voxels
 * @param worstExcess the largest such difference
 * @param presses the number of presses
 */
record NearestRow(
    String shape, double depth, String solver, double meanExcess, double worstExcess, int presses) {

  /** Returns the cells of its row in {@code nearest.csv}. */
  List<Object> cells() {
    return List.of(shape, depth, solver, meanExcess, worstExcess, presses);
  }
}
