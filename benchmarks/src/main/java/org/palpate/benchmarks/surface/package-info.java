/**
 * The surfaces of the paper's Table 1: triangles, time and memory, on scans as they are and
 * resampled to its sizes.
 *
 * <p>Uses {@code scene.surface} and {@code io}. One thread. Grid millimetres.
 */
package org.palpate.benchmarks.surface;
