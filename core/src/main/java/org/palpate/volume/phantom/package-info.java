/**
 * Synthetic volumes, with analytic surfaces to measure forces against.
 *
 * <p>Uses {@code volume.fracture}, {@code volume} and {@code geometry}. Starts no thread. Every
 * result depends on the arguments alone and is the same, bit for bit, on every JDK. Voxels are
 * cubes of 1 mm, and grid coordinates equal world coordinates.
 */
package org.palpate.volume.phantom;
