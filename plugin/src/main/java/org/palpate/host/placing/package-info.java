/**
 * Helps to place bodies by hand: keys that lock and bind bodies, and readings of the fragment in
 * hand.
 *
 * <p>Uses {@code host} and {@code fracture}. Readings are computed on a thread of their own, from
 * poses that were published; keys act on the threads of the window. World millimetres.
 */
package org.palpate.host.placing;
