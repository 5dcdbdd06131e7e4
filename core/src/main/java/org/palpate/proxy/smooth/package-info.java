/**
 * The smooth solver: an implicit surface made on the fly from the voxels around the interaction
 * point, and a point that slides on it.
 *
 * <p>Uses {@code raycast}, {@code volume} and {@code geometry}. Everything keeps scratch and
 * belongs to the haptic thread. Positions are grid coordinates; lengths inside are in shortest
 * voxel edges ("edges"), lengths that leave the package are millimetres.
 */
package org.palpate.proxy.smooth;
