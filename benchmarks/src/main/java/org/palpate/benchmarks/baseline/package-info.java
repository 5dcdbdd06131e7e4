/**
 * The paper's solver and ray sampling, written plainly over a flat bit array, as a baseline for
 * speed and accuracy.
 *
 * <p>Uses the interfaces of {@code proxy} and {@code raycast}. One thread. Grid coordinates and
 * voxels.
 */
package org.palpate.benchmarks.baseline;
