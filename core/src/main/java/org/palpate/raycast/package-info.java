/**
 * Finds the first solid voxel on a straight segment, by sampling or exactly.
 *
 * <p>Uses {@code volume}, {@code geometry} and {@code statistics}. An instance keeps scratch memory
 * and belongs to one thread. All coordinates are grid coordinates.
 */
package org.palpate.raycast;
