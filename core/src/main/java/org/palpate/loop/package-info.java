/**
 * Runs haptic frames in a thread of their own: pacing, warm-up, supervision and an ending with zero
 * force.
 *
 * <p>Uses {@code frame}. Starts the haptic thread. Times are nanoseconds of a {@code NanoClock};
 * reports are in microseconds and seconds.
 *
 * <p>A session, from the outside in: a device in world millimetres; a {@code RecordingDevice} if it
 * is recorded; the adapter of {@code host} that turns world into grid coordinates; a {@code
 * HapticFrame}; a {@code HapticLoop} that runs the frame; and a thread that calls {@code
 * HapticLoop.supervise} some 30 times a second.
 */
package org.palpate.loop;
