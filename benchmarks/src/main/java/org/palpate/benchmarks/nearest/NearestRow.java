package org.palpate.benchmarks.nearest;

/**
 * How far beyond the nearest free point a solver's points stayed.
 *
 * @param shape of the solids
 * @param depth of the device below the true surface, voxels
 * @param solver its name, or that of the search
 * @param meanExcess mean of |p-d| less the distance of the nearest free point, voxels
 * @param worstExcess the largest
 * @param presses how many
 */
record NearestRow(
    String shape,
    double depth,
    String solver,
    double meanExcess,
    double worstExcess,
    int presses) {}
