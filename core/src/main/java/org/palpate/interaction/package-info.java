/**
 * One haptic frame as a plain method, the loop that paces it, the watchdog, edits and the recorder.
 *
 * <p>Uses {@code device}, {@code proxy}, {@code force}, {@code sync}. Owns the haptic thread. Grid
 * coordinates, millimetres, newtons, nanoseconds.
 *
 * <p>A session, from the outside in: a device in world mm, a {@link
 * org.palpate.interaction.RecordingDevice} where it is recorded, the decorator of {@code host} that
 * turns world into grid, a {@link org.palpate.interaction.HapticFrame} over it, a {@link
 * org.palpate.interaction.HapticLoop} that runs the frame, a thread that calls {@link
 * org.palpate.interaction.HapticLoop#supervise} now and then.
 */
package org.palpate.interaction;
