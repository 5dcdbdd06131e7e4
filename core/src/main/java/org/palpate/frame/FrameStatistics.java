package org.palpate.frame;

import java.util.Map;
import java.util.OptionalLong;

/**
 * The statistics of the frames of a session so far.
 *
 * @param frames all frames
 * @param contactFrames frames that ended in contact
 * @param freed frames that set the point or the tool free: at a start in a solid, after an edit or
 *     a change of solver that left it in one, or because the device jumped
 * @param maxForceNewton length of the longest force that was written
 * @param maxTorqueNewtonMm length of the longest torque that was written
 * @param firstHold the number, from 0, of the first frame in which the hand held a body; empty if
 *     it held none
 * @param skipped how often work was skipped, by {@link org.palpate.statistics.SkipKind#key}
 * @param faults faults of device and clocks
 */
public record FrameStatistics(
    long frames,
    long contactFrames,
    long freed,
    double maxForceNewton,
    double maxTorqueNewtonMm,
    OptionalLong firstHold,
    Map<String, Long> skipped,
    Faults faults) {

  /**
   * Faults that the frames met and handled.
   *
   * @param held frames without a new sample
   * @param notFinite samples whose position was NaN or infinite
   * @param badOrientations samples of a tool without a valid orientation; the last one was kept
   * @param badTimes samples whose time went back or stood still
   * @param silences silences of the device
   * @param clockJumps gaps between frames that were longer than a silence, and backward steps of
   *     the clock
   * @param forceNotFinite forces and torques that were not finite and became zero
   * @param unreached forces that did not reach the device
   */
  public record Faults(
      long held,
      long notFinite,
      long badOrientations,
      long badTimes,
      long silences,
      long clockJumps,
      long forceNotFinite,
      long unreached) {}
}
