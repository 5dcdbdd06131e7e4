package org.palpate.benchmarks.accuracy;

/**
 * How far a solver's coupling force was from that of the true surface, over the frames of a slide.
 *
 * @param angleRmsDegrees angle of the force to the true normal, root of the mean square
 * @param angleWorstDegrees the largest such angle
 * @param heightMeanMm mean distance of the point from the true surface, outside positive
 * @param heightStdMm its standard deviation
 * @param lag mean of the force's length over stiffness times depth: 1 is true
 * @param forceChange root mean square change of force from frame to frame, over that of the true
 *     force; infinity where that does not change
 * @param lostFrames frames in which the device, inside, met no resistance: the solver was through
 */
public record Accuracy(
    double angleRmsDegrees,
    double angleWorstDegrees,
    double heightMeanMm,
    double heightStdMm,
    double lag,
    double forceChange,
    int lostFrames) {}
