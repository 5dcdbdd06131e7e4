/**
 * Passes scene properties from the haptic thread, at kilohertz, to the scene, at 30 Hz.
 *
 * <p>Uses {@code geometry}. One writer, the haptic thread, and one reader, the synchronization
 * thread; the writer never waits. The writer of a property states its frame and unit.
 */
package org.palpate.sync;
