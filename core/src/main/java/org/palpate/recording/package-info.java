/**
 * Records the samples of a device, edits, poses of bodies, updates of elastic segments and frames
 * without delaying the haptic thread, and writes samples as a trajectory.
 *
 * <p>Uses {@code body}, {@code device}, {@code elastic} and {@code frame}. The haptic thread puts
 * samples into a ring buffer, and a thread of its own writes them into a file. Positions are those
 * of the device; times are milliseconds from the first sample.
 */
package org.palpate.recording;
