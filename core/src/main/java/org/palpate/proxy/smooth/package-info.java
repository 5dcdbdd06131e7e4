/**
 * The smooth solver: slides the interaction point on an isosurface of the occupancy field, by legs
 * that exact arithmetic has verified.
 *
 * <p>Uses {@code proxy.smooth.field} and {@code proxy.exact}. Belongs to the haptic thread; a frame
 * allocates nothing. Positions are grid coordinates. Lengths inside the package are in shortest
 * voxel edges ("edges"); lengths that leave it are millimetres.
 */
package org.palpate.proxy.smooth;
