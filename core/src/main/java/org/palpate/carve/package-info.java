/**
 * Cuts: removes the voxels that keep a tool from its device pose, at a rate that follows the force.
 *
 * <p>Uses {@code edit} and {@code rigid}. Belongs to the haptic thread and allocates nothing in a
 * frame. Rates in mm^3 per N s; voxels in grid coordinates.
 */
package org.palpate.carve;
