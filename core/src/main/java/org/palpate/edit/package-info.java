/**
 * Changes voxels and grey values: any thread queues an edit, and the haptic thread applies it
 * between frames. Strokes of changes are undone and done again to the bit.
 *
 * <p>Uses {@code collision} and {@code proxy.smooth.field}. Each class states its thread. Grid
 * coordinates; radii in millimetres.
 */
package org.palpate.edit;
