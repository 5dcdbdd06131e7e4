package org.palpate.benchmarks.stability;

import org.palpate.device.DeviceSpecification;
import org.palpate.force.ForceSettings;
import org.palpate.frame.FrameOutcome;
import org.palpate.frame.FrameSettings;
import org.palpate.frame.HapticFrame;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;

/**
 * A person who presses a device's handle on a surface, stays, and leaves.
 *
 * @param touchMm where the handle meets the surface
 * @param inward unit direction into the solid
 * @param pressedNewton the force with which the hand means to press
 */
public record ClosedLoop(
    DeviceModel device,
    Grip grip,
    Sampling sampling,
    Vec3 touchMm,
    Vec3 inward,
    double pressedNewton) {
  static final double FRICTION = 0.2;
  private static final double AWAY_MM = 2;
  private static final double AWAY_ALONE_MM = 0.05;
  private static final double DEPTH_ALONE_MM = 1;
  private static final double IN_SECONDS = 0.15;
  private static final double STAY_SECONDS = 2;

  /** Extra stay of a handle without a hand, in time constants 2 m / b. */
  private static final double STAY_ALONE_CONSTANTS = 10;

  /** The intended force of the hand as a fraction of the device's maximum. */
  private static final double PRESSED_FRACTION = 0.4;

  /** An excursion below this counts as rest: a few encoder steps and 10 um. */
  private static final double REST_ENCODER_STEPS = 3;

  private static final double REST_MM = 0.01;

  /**
   * A gripped handle that has not settled is stable if its excursion shrinks at least by this
   * factor in {@link Plant#WINDOW_DISTANCE_SECONDS}. A heavy handle in a light grip swings for
   * seconds with or without a surface, which is no vibration.
   */
  private static final double SETTLING_FRACTION = 0.9;

  /**
   * The outcome of a trial.
   *
   * @param stable whether the handle came to rest during the stay
   * @param excursionMm the excursion of the handle during the last part of the stay; its longest
   *     way back if it sinks
   * @param energyBackMillijoule the largest energy that the contact had put into the handle
   * @param riseNewtonPerMs the largest change of force between two frames
   */
  public record Outcome(
      boolean stable, double excursionMm, double energyBackMillijoule, double riseNewtonPerMs) {}

  /** Creates a person who means to press with a part of the force that the device can give. */
  ClosedLoop(DeviceModel device, Grip grip, Sampling sampling, Vec3 touchMm, Vec3 inward) {
    this(device, grip, sampling, touchMm, inward, PRESSED_FRACTION * device.maxForceNewton());
  }

  /** Returns a handle that does not turn; positions are in units of {@code unitMm}. */
  Plant plant(double unitMm) {
    Reach reach = reach();
    HandleMotion motion = new HandleMotion(device, grip, reach);
    return new Plant(device, sampling, reach, unitMm, motion, new Quaternion());
  }

  /** Returns a handle that also turns about an intended orientation; positions are in mm. */
  Plant turningPlant(Quaternion upright) {
    Reach reach = reach();
    return new Plant(
        device, sampling, reach, 1, HandleMotion.turning(device, grip, reach), upright);
  }

  /** Returns where the handle begins, mm. */
  Vec3 startMm() {
    return reach().awayMm();
  }

  private boolean isBare() {
    return grip.armNewtonPerM() == 0;
  }

  private Reach reach() {
    boolean bare = isBare();
    double depthMm = bare ? DEPTH_ALONE_MM : 1e3 * pressedNewton / grip.armNewtonPerM();
    return new Reach(
        alongMm(bare ? AWAY_ALONE_MM : AWAY_MM),
        alongMm(-depthMm),
        IN_SECONDS,
        bare ? STAY_SECONDS + STAY_ALONE_CONSTANTS * decaySeconds() : STAY_SECONDS);
  }

  /** Returns a point on the line through the touched point, mm outside of it (negative: inside). */
  private Vec3 alongMm(double outside) {
    Vec3 at = inward.mul(-outside, new Vec3());
    return at.add(touchMm, at);
  }

  private double decaySeconds() {
    return 2 * device.handleKg() / device.dampingNewtonSecondPerM();
  }

  /**
   * Returns the settings of the frames.
   *
   * @param limited whether the force passes the limits of a live session: maximum and slew rate
   */
  static FrameSettings settings(DeviceSpecification device, double newtonPerM, boolean limited) {
    ForceSettings force = ForceSettings.of(newtonPerM * 1e-3, FRICTION);
    FrameSettings live = FrameSettings.live(device, force);
    return limited
        ? live
        : new FrameSettings(
            force,
            live.maxForceNewton(),
            Double.POSITIVE_INFINITY,
            live.rampNanos(),
            live.silenceNanos(),
            live.editVoxelsAFrame());
  }

  /** Runs the frames of a plant to the end of the motion. */
  Outcome run(Plant plant, HapticFrame frame) {
    runFrames(frame);
    return outcome(isStable(plant), plant.excursionMm(), plant);
  }

  /**
   * Runs the frames of a tool that cuts, whose handle sinks.
   *
   * @param mostBackMm the longest way back of a handle that counts as stable
   */
  Outcome runSinking(Plant plant, HapticFrame frame, double mostBackMm) {
    runFrames(frame);
    return outcome(plant.reboundMm() <= mostBackMm, plant.reboundMm(), plant);
  }

  private void runFrames(HapticFrame frame) {
    long period = sampling.periodNanos();
    long now = 0;
    while (frame.run(now) == FrameOutcome.RUNNING) {
      now += period;
    }
  }

  private static Outcome outcome(boolean isStable, double excursionMm, Plant plant) {
    return new Outcome(
        isStable, excursionMm, plant.maxEnergyJoule() * 1e3, plant.steepestNewtonPerMs());
  }

  private boolean isStable(Plant plant) {
    double rest = REST_ENCODER_STEPS * device.encoderStepMm() + REST_MM;
    boolean settling = plant.excursionMm() <= SETTLING_FRACTION * plant.earlierExcursionMm();
    return plant.excursionMm() <= rest || (!isBare() && settling);
  }
}
