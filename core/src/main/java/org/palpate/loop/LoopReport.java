package org.palpate.loop;

import org.palpate.frame.FrameStatistics;

/**
 * What a session measured of its loop.
 *
 * @param seconds from the first frame's beginning to the last one's
 * @param rateHz frames a second over that time; 0 for fewer than two frames
 * @param frames all frames that were begun and came back
 * @param lateFrames those that began more than half a period after their deadline
 * @param periodMicros from one frame's beginning to the next one's
 * @param workMicros from a frame's beginning to its end
 * @param granted what the system granted the thread
 * @param counts what happened in the frames
 */
public record LoopReport(
    double seconds,
    double rateHz,
    long frames,
    long lateFrames,
    Quantiles periodMicros,
    Quantiles workMicros,
    ThreadSetup.Granted granted,
    FrameStatistics counts) {}
