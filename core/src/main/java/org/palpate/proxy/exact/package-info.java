/**
 * The guarded solver: moves the interaction point along voxel faces, by legs that exact arithmetic
 * has verified.
 *
 * <p>Uses {@code proxy}, {@code collision} and {@code raycast}. Belongs to the haptic thread; a
 * frame allocates nothing. Positions are grid coordinates; lengths are millimetres.
 */
package org.palpate.proxy.exact;
