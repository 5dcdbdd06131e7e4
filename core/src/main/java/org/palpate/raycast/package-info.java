/**
 * Collision: where the straight way from one point to another first meets a solid voxel, sampled or
 * exact.
 *
 * <p>Uses {@code volume}. An instance keeps scratch and belongs to one thread. Everything is in
 * grid coordinates.
 */
package org.palpate.raycast;
