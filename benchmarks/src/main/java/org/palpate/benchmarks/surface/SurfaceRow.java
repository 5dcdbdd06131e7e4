package org.palpate.benchmarks.surface;

/**
 * The surface of a scan.
 *
 * @param data its name
 * @param voxels solid ones
 * @param triangles of the finest level
 * @param vertices of its bricks
 * @param cpuSeconds processor time of one thread for all of it
 * @param heapBytes in the JVM
 * @param cardBytes on the graphics card
 * @param coarseTriangles of the first picture, at a quarter of the resolution
 * @param coarseCpuSeconds processor time of one thread for that, its voxels included
 * @param brickMedianMs processor time of a brick that is made anew after an edit
 * @param brickMostMs of the slowest brick
 */
record SurfaceRow(
    String data,
    long voxels,
    long triangles,
    long vertices,
    double cpuSeconds,
    long heapBytes,
    long cardBytes,
    long coarseTriangles,
    double coarseCpuSeconds,
    double brickMedianMs,
    double brickMostMs) {}
