/**
 * The port to a volume platform: contact scene, session, and the change from world to grid
 * coordinates.
 *
 * <p>Uses {@code frame}, {@code loop}, {@code scene} and {@code device}. Each class states its
 * thread. World millimetres outside, grid coordinates inside.
 */
package org.palpate.host;
