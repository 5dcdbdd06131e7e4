/**
 * How far a point at rest stays from the device, beside the nearest free point: every solver
 * pressed into solids of a few shapes, and a naive search over all voxels that says what is
 * nearest.
 *
 * <p>Uses {@code proxy} and the truths of {@code volume.phantom}. One thread. Voxels are unit
 * cubes.
 */
package org.palpate.benchmarks.nearest;
