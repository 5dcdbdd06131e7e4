/**
 * Helps to place bodies by hand: keys that lock and bind bodies, readings of the fragment in hand,
 * and an autosave.
 *
 * <p>Uses {@code host}, {@code fracture} and {@code io.scene}. Readings are computed on a thread of
 * their own, from poses that were published, and the autosave has one too; keys act on the threads
 * of the window. World millimetres.
 */
package org.palpate.host.placing;
