/**
 * Cuts bones into fragments with known truth, displaces the fragments, and puts posed fragments
 * together into one label volume.
 *
 * <p>Uses {@code volume} and {@code geometry}. Starts no thread. Every result depends on the
 * arguments alone and is the same, bit for bit, on every JDK. Voxels are in grid coordinates; poses
 * map rest to present, world mm.
 */
package org.palpate.volume.fracture;
