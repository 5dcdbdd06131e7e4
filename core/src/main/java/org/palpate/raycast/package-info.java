/**
 * Finds the first solid voxel on a straight segment, by sampling or exactly.
 *
 * <p>Uses {@code volume}. An instance keeps scratch memory and belongs to one thread. Everything is
 * in grid coordinates.
 */
package org.palpate.raycast;
