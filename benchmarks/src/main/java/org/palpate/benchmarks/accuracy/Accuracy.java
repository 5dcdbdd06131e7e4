package org.palpate.benchmarks.accuracy;

/**
 * The errors of a solver's coupling force against that of the true surface, over a slide.
 *
 * @param angleRmsDegrees angle between the force and the true normal, root mean square
 * @param angleWorstDegrees the largest such angle
 * @param heightMeanMm mean distance of the point from the true surface, positive outside
 * @param heightStdMm the standard deviation of that distance
 * @param lag mean of the force's length over stiffness times depth; 1 is exact
 * @param forceChange root mean square change of the force per frame, relative to that of the true
 *     force; infinity if that is constant
 * @param lostFrames frames without a force although the device was inside the solid
 */
public record Accuracy(
    double angleRmsDegrees,
    double angleWorstDegrees,
    double heightMeanMm,
    double heightStdMm,
    double lag,
    double forceChange,
    int lostFrames) {}
