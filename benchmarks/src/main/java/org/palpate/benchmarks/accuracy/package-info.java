/**
 * Measures how far forces and positions are from those on an analytic surface.
 *
 * <p>Uses {@code benchmarks.baseline} and {@code benchmarks.report}. One thread. Degrees, voxels,
 * nanoseconds.
 */
package org.palpate.benchmarks.accuracy;
