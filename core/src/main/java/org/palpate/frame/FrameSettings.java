package org.palpate.frame;

import org.palpate.device.DeviceSpecification;
import org.palpate.force.ForceRamp;
import org.palpate.force.ForceSettings;

/**
 * The settings of a frame.
 *
 * @param force materials and friction
 * @param maxForceNewton the longest force; infinity for no limit
 * @param slewNewtonPerMs the fastest change of the force; infinity for no limit
 * @param rampNanos time in which a force returns after a silence or after the point was set free; 0
 *     for at once
 * @param silenceNanos time without a new sample for which the last force is held; {@link
 *     #NO_SILENCE} for a replay, in which time means nothing
 * @param editVoxelsAFrame number of voxels that edits may visit in one frame, at least 1
 * @param maxTorqueNewtonMm the longest torque; 0 for none, infinity for no limit
 * @param slewNewtonMmPerMs the fastest change of the torque; infinity for no limit
 */
public record FrameSettings(
    ForceSettings force,
    double maxForceNewton,
    double slewNewtonPerMs,
    long rampNanos,
    long silenceNanos,
    int editVoxelsAFrame,
    double maxTorqueNewtonMm,
    double slewNewtonMmPerMs) {

  /** Lets a device be silent for ever. */
  public static final long NO_SILENCE = Long.MAX_VALUE;

  /** The least time in which a force or a torque may rise from zero to the device's maximum, ms. */
  public static final double FULL_FORCE_MS = 4;

  /** The usual number of voxels, which take some ten microseconds of a frame. */
  public static final int DEFAULT_EDIT_VOXELS_A_FRAME = 2048;

  /**
   * Checks the ranges that the parts of a frame do not check.
   *
   * @throws IllegalArgumentException if the silence is not positive or no voxel may be edited in a
   *     frame
   */
  public FrameSettings {
    if (silenceNanos <= 0 || editVoxelsAFrame < 1) {
      throw new IllegalArgumentException(
          "silence must be positive and edits at least 1 voxel a frame: silenceNanos="
              + silenceNanos
              + " editVoxelsAFrame="
              + editVoxelsAFrame);
    }
  }

  /**
   * Makes settings without torque.
   *
   * @param force materials and friction
   * @param maxForceNewton the longest force; infinity for no limit
   * @param slewNewtonPerMs the fastest change of the force; infinity for no limit
   * @param rampNanos time in which a force returns; 0 for at once
   * @param silenceNanos time without a new sample for which the last force is held
   * @param editVoxelsAFrame number of voxels that edits may visit in one frame, at least 1
   */
  public FrameSettings(
      ForceSettings force,
      double maxForceNewton,
      double slewNewtonPerMs,
      long rampNanos,
      long silenceNanos,
      int editVoxelsAFrame) {
    this(
        force,
        maxForceNewton,
        slewNewtonPerMs,
        rampNanos,
        silenceNanos,
        editVoxelsAFrame,
        0,
        Double.POSITIVE_INFINITY);
  }

  /**
   * {@return the settings of a live session: the device's maxima, slew rates and silence}
   *
   * @param device states the maxima and the interval of its reports
   * @param force materials and friction
   */
  public static FrameSettings live(DeviceSpecification device, ForceSettings force) {
    return new FrameSettings(
        force,
        device.maxForceNewton(),
        slewPerMs(device.maxForceNewton()),
        ForceRamp.DEFAULT_NANOS,
        Watchdog.silenceNanosFor(device),
        DEFAULT_EDIT_VOXELS_A_FRAME,
        device.maxTorqueNewtonMm(),
        slewPerMs(device.maxTorqueNewtonMm()));
  }

  private static double slewPerMs(double max) {
    return max > 0 ? max / FULL_FORCE_MS : Double.POSITIVE_INFINITY;
  }

  /**
   * {@return these settings with another longest torque, and with no limit to its slew}
   *
   * @param newtonMm the longest torque, N mm; 0 for none, infinity for no limit
   */
  public FrameSettings withTorque(double newtonMm) {
    return new FrameSettings(
        force,
        maxForceNewton,
        slewNewtonPerMs,
        rampNanos,
        silenceNanos,
        editVoxelsAFrame,
        newtonMm,
        Double.POSITIVE_INFINITY);
  }

  /**
   * {@return these settings with a lower maximum force}
   *
   * @param newton the maximum, N; it has no effect if the present one is lower
   */
  public FrameSettings withMaxForce(double newton) {
    return new FrameSettings(
        force,
        Math.min(newton, maxForceNewton),
        slewNewtonPerMs,
        rampNanos,
        silenceNanos,
        editVoxelsAFrame,
        maxTorqueNewtonMm,
        slewNewtonMmPerMs);
  }
}
