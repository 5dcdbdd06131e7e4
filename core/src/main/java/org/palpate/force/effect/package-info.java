/**
 * Effects that the hand feels beside contact: viscosity, magnetic attraction, stick-slip, vibration
 * and the texture of grey values.
 *
 * <p>Uses the port of {@code force}, {@code force.guide} and {@code volume}. Plans are made by any
 * thread; the effects that they make belong to the haptic thread and allocate nothing in a frame.
 * Millimetres of the frame, newtons, N mm, seconds.
 */
package org.palpate.force.effect;
