/**
 * One haptic frame as a plain method, the loop that paces it, the watchdog and the recorder.
 *
 * <p>Uses {@code device}, {@code proxy}, {@code force}, {@code sync}. Owns the haptic thread. Grid
 * coordinates, millimetres, newtons, nanoseconds.
 */
package org.palpate.interaction;
