package org.palpate.loop;

/**
 * A glance at a loop while it runs; the numbers may be of neighbouring frames.
 *
 * @param frames frames so far
 * @param lateFrames those that began late
 * @param latestLatenessNanos how late the last frame began
 * @param contact whether there is contact
 * @param forceNewton length of the force that was written last
 */
public record LoopStatus(
    long frames, long lateFrames, long latestLatenessNanos, boolean contact, double forceNewton) {}
