/**
 * Records the samples of a device without delaying the haptic thread, and writes them as a
 * trajectory.
 *
 * <p>Uses {@code device}. The haptic thread puts samples into a ring buffer, and a thread of its
 * own writes them into a file. Positions are those of the device; times are milliseconds from the
 * first sample.
 */
package org.palpate.recording;
