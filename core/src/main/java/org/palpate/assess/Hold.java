package org.palpate.assess;

/**
 * A time for which the hand held a body.
 *
 * @param body index of the body in the scene
 * @param fromSeconds the first frame
 * @param toSeconds the last frame
 * @param movedMm distance between the places of its reference point at both times, mm
 * @param turnedRad angle between its orientations at both times, rad
 */
public record Hold(
    int body, double fromSeconds, double toSeconds, double movedMm, double turnedRad) {}
