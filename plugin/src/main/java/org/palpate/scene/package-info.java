/**
 * The scene as it is drawn: objects, camera, slices, marks, and its synchronization at 30 Hz.
 *
 * <p>Uses {@code elastic}, {@code sync}, {@code scene.surface} and {@code volume}. Any thread
 * changes the model; one thread synchronizes. World millimetres.
 */
package org.palpate.scene;
