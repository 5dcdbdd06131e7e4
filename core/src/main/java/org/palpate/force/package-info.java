/**
 * Computes force and torque on the hand: virtual coupling, friction, damping, materials and the
 * limiter.
 *
 * <p>Uses {@code proxy} for the path of the interaction point, and {@code rigid} for the motion of
 * a tool. Belongs to the haptic thread and allocates nothing in a frame. Newtons along the grid's
 * axes, or the world's for a tool; millimetres, nanoseconds.
 */
package org.palpate.force;
