/**
 * Landmarks and brush strokes that the user adds to a stack while touching it.
 *
 * <p>Uses {@code imagej.stack}, {@code scene} and {@code io}. Any thread. Grid coordinates in,
 * calibrated units out.
 */
package org.palpate.imagej.annotation;
