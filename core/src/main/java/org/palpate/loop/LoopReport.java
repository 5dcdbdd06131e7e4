package org.palpate.loop;

import org.palpate.frame.FrameStatistics;

/**
 * The measurements of a session's loop.
 *
 * @param seconds time from the beginning of the first frame to that of the last
 * @param rateHz frames a second over that time; 0 for fewer than two frames
 * @param frames number of frames that returned
 * @param lateFrames frames that began more than half a period after their deadline
 * @param periodMicros time from the beginning of a frame to that of the next
 * @param latenessMicros time from the deadline of a frame to its beginning
 * @param workMicros time from the beginning of a frame to its end
 * @param granted the requests that the system granted the thread
 * @param statistics statistics of the frames
 */
public record LoopReport(
    double seconds,
    double rateHz,
    long frames,
    long lateFrames,
    Quantiles periodMicros,
    Quantiles latenessMicros,
    Quantiles workMicros,
    ThreadSetup.Granted granted,
    FrameStatistics statistics) {}
