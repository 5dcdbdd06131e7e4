package org.palpate.frame;

import java.util.Map;

/**
 * What happened in the frames of a session so far.
 *
 * @param frames all of them
 * @param contactFrames those that ended in contact
 * @param freed times that the point was set free, at the start or from a solid that came to it
 * @param maxForceNewton the longest force that was written
 * @param skipped how often what was left out, by kind, see {@link org.palpate.proxy.SkipKind}
 * @param faults what went wrong and was met
 */
public record FrameStatistics(
    long frames,
    long contactFrames,
    long freed,
    double maxForceNewton,
    Map<String, Long> skipped,
    Faults faults) {

  /**
   * What went wrong and was met.
   *
   * @param held frames without a new sample
   * @param notFinite samples that were NaN or infinite
   * @param badTimes samples whose time went back or stood still
   * @param silences times that the device said nothing for too long
   * @param clockJumps gaps between frames longer than a silence, and times that the clock went back
   * @param forceNotFinite forces that were not finite and became zero
   * @param unreached writes that did not reach the device
   */
  public record Faults(
      long held,
      long notFinite,
      long badTimes,
      long silences,
      long clockJumps,
      long forceNotFinite,
      long unreached) {}
}
