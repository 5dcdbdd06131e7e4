/**
 * Runs haptic frames in a thread of their own: pacing, warm-up, supervision and an end with zero
 * force.
 *
 * <p>Uses {@code frame}. Starts the haptic thread. Times are nanoseconds of a {@code NanoClock};
 * reports are in microseconds and seconds.
 *
 * <p>A session consists of these parts, from the outside in:
 *
 * <ul>
 *   <li>a device in world millimetres;
 *   <li>a {@code RecordingDevice}, if the session is recorded;
 *   <li>the adapter of {@code host}, which turns world into grid coordinates;
 *   <li>a {@code HapticFrame};
 *   <li>a {@code HapticLoop} that runs the frame;
 *   <li>a thread that calls {@code HapticLoop.supervise} some 30 times a second.
 * </ul>
 */
package org.palpate.loop;
