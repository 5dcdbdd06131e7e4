/**
 * Measures how far a resting interaction point is from the free point that is nearest to the
 * device.
 *
 * <p>Uses {@code benchmarks.baseline} and {@code benchmarks.report}. One thread. Millimetres and
 * voxels.
 */
package org.palpate.benchmarks.nearest;
