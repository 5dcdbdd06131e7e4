/**
 * Edits of voxels and grey values that any thread queues and the haptic thread applies between
 * frames.
 *
 * <p>Uses {@code collision} and {@code proxy.smooth.field}. Each class states its thread. Grid
 * coordinates; radii in millimetres.
 */
package org.palpate.edit;
