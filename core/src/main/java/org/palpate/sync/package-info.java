/**
 * Accumulators of scene properties: the hand-over from the haptic thread at kilohertz to the scene
 * at 30 Hz.
 *
 * <p>Uses {@code geometry}. One writer, the haptic thread; one reader, the synchronization thread.
 * A value's frame and unit are what its writer says.
 */
package org.palpate.sync;
