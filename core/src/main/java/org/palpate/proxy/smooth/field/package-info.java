/**
 * The occupancy field: a smooth function between 0 (empty) and 1 (solid), evaluated on the fly from
 * the bits or grey values around a point.
 *
 * <p>Uses {@code collision} and {@code volume}. Belongs to the haptic thread; an evaluation
 * allocates nothing. Positions are grid coordinates; lengths are in shortest voxel edges ("edges").
 */
package org.palpate.proxy.smooth.field;
