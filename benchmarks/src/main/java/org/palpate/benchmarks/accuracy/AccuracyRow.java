package org.palpate.benchmarks.accuracy;

/**
 * What one solver did on one slide.
 *
 * @param solver with its collision method
 * @param shape the phantom
 * @param depth voxels
 * @param speed voxels a frame
 * @param nanosPerFrame processor time, median of passes that took turns with the other solvers'
 */
record AccuracyRow(
    String solver,
    String shape,
    double depth,
    double speed,
    Accuracy accuracy,
    double nanosPerFrame) {}
