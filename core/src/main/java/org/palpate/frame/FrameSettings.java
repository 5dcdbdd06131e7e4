package org.palpate.frame;

import org.palpate.device.DeviceSpecification;
import org.palpate.force.ForceRamp;
import org.palpate.force.ForceSettings;

/**
 * What a frame is set up with.
 *
 * @param force what the surface feels like
 * @param maxForceNewton the longest force; infinity for no limit
 * @param slewNewtonPerMs the fastest change of force; infinity for no limit
 * @param rampNanos how long a force takes to come back after a silence or after the point was set
 *     free; 0 for at once
 * @param silenceNanos how long without a new sample the last force is held; {@link #NO_SILENCE}
 *     where time says nothing, as off line
 * @param editVoxelsAFrame how many voxels edits may look at in one frame, at least 1
 */
public record FrameSettings(
    ForceSettings force,
    double maxForceNewton,
    double slewNewtonPerMs,
    long rampNanos,
    long silenceNanos,
    int editVoxelsAFrame) {

  /** A device may be silent for ever. */
  public static final long NO_SILENCE = Long.MAX_VALUE;

  /** A force may go from nothing to the device's maximum in this time. */
  public static final double FULL_FORCE_MS = 4;

  /** Some ten microseconds of a frame. */
  public static final int DEFAULT_EDIT_VOXELS_A_FRAME = 2048;

  /** Checks the ranges that no part checks itself. */
  public FrameSettings {
    if (silenceNanos <= 0 || editVoxelsAFrame < 1) {
      throw new IllegalArgumentException(
          "silence must be positive and edits at least 1 voxel a frame: silenceNanos="
              + silenceNanos
              + " editVoxelsAFrame="
              + editVoxelsAFrame);
    }
  }

  /** A live session with a device: its maximum, the slew that goes with it, its silence. */
  public static FrameSettings live(DeviceSpecification device, ForceSettings force) {
    double max = device.maxForceNewton();
    return new FrameSettings(
        force,
        max,
        max > 0 ? max / FULL_FORCE_MS : Double.POSITIVE_INFINITY,
        ForceRamp.DEFAULT_NANOS,
        Watchdog.silenceNanosFor(device),
        DEFAULT_EDIT_VOXELS_A_FRAME);
  }

  /** The same with a lower maximum force where {@code newton} is lower. */
  public FrameSettings withMaxForce(double newton) {
    return new FrameSettings(
        force,
        Math.min(newton, maxForceNewton),
        slewNewtonPerMs,
        rampNanos,
        silenceNanos,
        editVoxelsAFrame);
  }
}
