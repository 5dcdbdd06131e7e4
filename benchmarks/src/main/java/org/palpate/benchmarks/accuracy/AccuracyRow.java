package org.palpate.benchmarks.accuracy;

import java.util.List;

/**
 * The result of one solver on one slide.
 *
 * @param solver the solver with its collision method
 * @param shape the phantom
 * @param edge the edge of the cube that the phantom fills, mm
 * @param spacing the edges of a voxel, mm, as 1:1:3
 * @param depth the depth of the device, voxels
 * @param speed the speed of the device, voxels per frame
 * @param accuracy the errors
 * @param nanosPerFrame processor time, median of passes that alternate with the other solvers
 */
record AccuracyRow(
    String solver,
    String shape,
    int edge,
    String spacing,
    double depth,
    double speed,
    Accuracy accuracy,
    double nanosPerFrame) {

  /** Returns the cells of its row in {@code accuracy.csv}. */
  List<Object> cells() {
    return List.of(
        shape,
        edge,
        spacing,
        depth,
        speed,
        solver,
        accuracy.angleRmsDegrees(),
        accuracy.angleWorstDegrees(),
        accuracy.heightMeanMm(),
        accuracy.heightStdMm(),
        accuracy.lag(),
        accuracy.forceChange(),
        (double) accuracy.lostFrames(), // a count, but "0.0" in every earlier table
        nanosPerFrame);
  }

  /** Returns the solver, with the size of the phantom and the edges of a voxel if they differ. */
  String series() {
    String size = edge == AccuracyStudy.EDGE ? "" : ", " + edge + " mm";
    String voxels = spacing.equals(AccuracyStudy.CUBES) ? "" : ", voxels of " + spacing;
    return solver + size + voxels;
  }
}
