package org.palpate.benchmarks.surface;

import java.util.List;

/**
 * The surface of a scan.
 *
 * @param data the name of the scan
 * @param voxels the number of solid voxels
 * @param triangles the triangles of the finest level
 * @param vertices the vertices of its bricks
 * @param cpuSeconds processor time of one thread for the whole surface
 * @param heapBytes memory in the JVM
 * @param cardBytes memory on the graphics card
 * @param coarseTriangles the triangles of the first picture, at a quarter of the resolution
 * @param coarseCpuSeconds processor time of one thread for the first picture, voxels included
 * @param brickMedianMs processor time of a brick that is extracted again after an edit
 * @param brickMaxMs processor time of the slowest brick
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
    double brickMaxMs) {

  /** Returns the cells of its row in {@code surfaces.csv}. */
  List<Object> cells() {
    return List.of(
        data,
        voxels,
        triangles,
        vertices,
        cpuSeconds,
        heapBytes,
        cardBytes,
        coarseTriangles,
        coarseCpuSeconds,
        brickMedianMs,
        brickMaxMs);
  }
}
