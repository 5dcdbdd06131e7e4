/**
 * Records the samples of a device without delaying the haptic thread, and writes them as a
 * trajectory.
 *
 * <p>Uses {@code device}. The haptic thread puts samples into a ring buffer; a thread of its own
 * drains the ring into a file. Positions are as the device gave them; times are milliseconds from
 * the first sample.
 */
package org.palpate.recording;
