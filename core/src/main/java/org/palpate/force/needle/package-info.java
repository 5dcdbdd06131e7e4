/**
 * Needles: layers that a needle punctures, and the track that holds it.
 *
 * <p>Uses {@code force}, {@code rigid}, {@code raycast} and {@code volume}. Haptic thread.
 * Millimetres in the world, newtons.
 */
package org.palpate.force.needle;
