package org.palpate.benchmarks.stability;

import org.palpate.edit.EditQueue;
import org.palpate.force.ForceSettings;
import org.palpate.frame.FrameOutcome;
import org.palpate.frame.FramePublisher;
import org.palpate.frame.FrameSettings;
import org.palpate.frame.HapticFrame;
import org.palpate.geometry.GridMetric;
import org.palpate.proxy.ProxySolver;
import org.palpate.volume.VoxelGrid;

/**
 * One set-up of the closed loop: who, with what, on what, by which solver, how often.
 *
 * @param device the device
 * @param grip the person
 * @param sampling rate and delay
 * @param shape what is pressed
 * @param solver the solver's maker and name
 * @param limited whether the force passes the limits of a live session (maximum and slew)
 */
public record Trial(
    DeviceModel device,
    Grip grip,
    Sampling sampling,
    TouchedShape shape,
    SolverChoice solver,
    boolean limited) {
  private static final double FRICTION = 0.2;
  private static final double AWAY_MM = 2;
  private static final double IN_SECONDS = 0.15;

  private static final double STAY_SECONDS = 2;

  /** A handle that no hand holds takes its time: so many time constants 2 m / b. */
  private static final double STAY_ALONE_CONSTANTS = 10;

  /** How much force the hand wants to press with, as a share of the device's maximum. */
  private static final double PRESSED_SHARE = 0.4;

  /** Play below this counts as rest: a few encoder steps and 10 um. */
  private static final double REST_ENCODER_STEPS = 3;

  private static final double REST_MM = 0.01;

  /**
   * A handle in a hand that has not settled yet is stable if its play shrinks at least so fast in
   * {@link Plant#APART_SECONDS}: a heavy one that two fingers hardly hold swings for seconds, with
   * or without a surface, and that is no shaking.
   */
  private static final double SETTLING_SHARE = 0.9;

  /** A solver with a name. */
  public record SolverChoice(String name, Maker maker) {
    /** Makes a solver. */
    @FunctionalInterface
    public interface Maker {
      /** A fresh one for a metric and w_max, mm. */
      ProxySolver make(GridMetric metric, double maxStepMm);
    }
  }

  /**
   * What came of it.
   *
   * @param rests whether the handle came to rest while the hand wanted to
   * @param playMm how far it moved then
   * @param energyBackMillijoule the most that the contact had put into the handle at any time
   * @param riseNewtonPerMs the fastest change of force from frame to frame
   */
  public record Outcome(
      boolean rests, double playMm, double energyBackMillijoule, double riseNewtonPerMs) {}

  /** Runs it with a stiffness, N/m. */
  public Outcome run(double newtonPerM) {
    Plant plant = new Plant(device, grip, sampling, reach(), TouchedShape.VOXEL_MM);
    HapticFrame frame = frame(plant, newtonPerM);
    long period = sampling.periodNanos();
    long now = 0;
    while (frame.run(now) == FrameOutcome.RUNNING) {
      now += period;
    }
    return new Outcome(
        rests(plant), plant.playMm(), plant.mostEnergyJoule() * 1e3, plant.steepestNewtonPerMs());
  }

  private boolean rests(Plant plant) {
    double rest = REST_ENCODER_STEPS * device.encoderStepMm() + REST_MM;
    boolean settling = plant.playMm() <= SETTLING_SHARE * plant.earlierPlayMm();
    return plant.playMm() <= rest || (!isAlone() && settling);
  }

  private boolean isAlone() {
    return grip.armNewtonPerM() == 0;
  }

  private Reach reach() {
    boolean alone = isAlone();
    double depthMm =
        alone ? 1 : 1e3 * PRESSED_SHARE * device.maxForceNewton() / grip.armNewtonPerM();
    return new Reach(
        shape.alongMm(alone ? 0.05 : AWAY_MM),
        shape.alongMm(-depthMm),
        IN_SECONDS,
        alone ? STAY_SECONDS + STAY_ALONE_CONSTANTS * decaySeconds() : STAY_SECONDS);
  }

  private double decaySeconds() {
    return 2 * device.handleKg() / device.dampingNewtonSecondPerM();
  }

  private HapticFrame frame(Plant plant, double newtonPerM) {
    double voxel = TouchedShape.VOXEL_MM;
    GridMetric metric = new GridMetric(voxel, voxel, voxel);
    ForceSettings force = ForceSettings.of(newtonPerM * 1e-3, FRICTION);
    FrameSettings live = FrameSettings.live(plant.specification(), force);
    FrameSettings settings =
        limited
            ? live
            : new FrameSettings(
                force,
                live.maxForceNewton(),
                Double.POSITIVE_INFINITY,
                live.rampNanos(),
                live.silenceNanos(),
                live.editVoxelsAFrame());
    VoxelGrid unit = VoxelGrid.ofUnitVoxels(1, 1, 1);
    return new HapticFrame(
        plant,
        solver.maker().make(metric, 8 * voxel),
        shape.obstacles(),
        metric,
        settings,
        new EditQueue(unit, 1),
        FramePublisher.NONE);
  }
}
