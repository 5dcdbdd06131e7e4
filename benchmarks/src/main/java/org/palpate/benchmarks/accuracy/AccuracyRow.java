package org.palpate.benchmarks.accuracy;

/**
 * The result of one solver on one slide.
 *
 * @param solver the solver with its collision method
 * @param shape the phantom
 * @param depth the depth of the device, voxels
 * @param speed the speed of the device, voxels per frame
 * @param accuracy the errors
 * @param nanosPerFrame processor time, median of passes that alternate with the other solvers
 */
record AccuracyRow(
    String solver,
    String shape,
    double depth,
    double speed,
    Accuracy accuracy,
    double nanosPerFrame) {}
