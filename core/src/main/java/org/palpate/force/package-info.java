/**
 * Force on the hand: virtual coupling, friction, limiter.
 *
 * <p>Uses {@code proxy} for the path that was travelled. Belongs to the haptic thread. Newton along
 * the grid's axes, millimetres, nanoseconds.
 */
package org.palpate.force;
