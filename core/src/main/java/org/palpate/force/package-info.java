/**
 * Computes the force on the hand: virtual coupling, friction, damping, materials and the limiter.
 *
 * <p>Uses {@code proxy} for the path of the interaction point. Belongs to the haptic thread and
 * allocates nothing in a frame. Newtons along the grid's axes, millimetres, nanoseconds.
 */
package org.palpate.force;
