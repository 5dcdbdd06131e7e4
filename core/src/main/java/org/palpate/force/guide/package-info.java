/**
 * Virtual fixtures: forces that guide the hand along a line, in a plane, about a hinge, along a
 * path, in a ball, along a direction, or away from a segment. Also finds how near a tool came to a
 * segment.
 *
 * <p>Uses the port of {@code force} and {@code volume}. Plans are made by any thread; the effects
 * that they make belong to the haptic thread and allocate nothing in a frame. Millimetres of the
 * frame, newtons, N mm.
 */
package org.palpate.force.guide;
