/**
 * Passes properties from the haptic thread, at kilohertz, to a slower thread, at 30 Hz: those of
 * the scene to the synchronization thread, and the load to the updates of elastic segments.
 *
 * <p>Uses {@code geometry}. One writer, the haptic thread, and one reader; the writer never waits.
 * The writer of a property states its frame and unit.
 */
package org.palpate.sync;
