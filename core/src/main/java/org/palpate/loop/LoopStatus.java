package org.palpate.loop;

/**
 * The status of a running loop. The figures may belong to neighbouring frames.
 *
 * @param frames frames so far
 * @param lateFrames frames that began more than half a period after their deadline
 * @param latestLatenessNanos time from the last frame's deadline to its beginning, at least 0
 * @param contact whether there is contact
 * @param forceNewton length of the last written force
 */
public record LoopStatus(
    long frames, long lateFrames, long latestLatenessNanos, boolean contact, double forceNewton) {}
