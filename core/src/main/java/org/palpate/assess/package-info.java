/**
 * Assesses a session for training: forces by segment, paths, the tremor of the hand, and what was
 * held.
 *
 * <p>Uses {@code frame} and {@code geometry}. Runs beside the haptic thread, one thread at a time.
 * Millimetres, newtons and seconds from the first frame.
 */
package org.palpate.assess;
