package org.palpate.benchmarks.stability;

import org.palpate.edit.EditQueue;
import org.palpate.force.ForceSettings;
import org.palpate.frame.FrameOutcome;
import org.palpate.frame.FramePublisher;
import org.palpate.frame.FrameSettings;
import org.palpate.frame.GridDevice;
import org.palpate.frame.PointFrame;
import org.palpate.geometry.GridMetric;
import org.palpate.proxy.ProxySolver;
import org.palpate.volume.VoxelGrid;

/**
 * One set-up of the closed loop.
 *
 * @param device the device
 * @param grip the person
 * @param sampling rate and delay
 * @param shape the shape that is pressed
 * @param solver the factory of the solver and its name
 * @param limited whether the force passes the limits of a live session (maximum and slew rate)
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

  /** The factory of a solver with its name. */
  public record SolverChoice(String name, Factory factory) {
    /** Makes a solver. */
    @FunctionalInterface
    public interface Factory {
      /** Creates a solver for a metric and w_max, mm. */
      ProxySolver make(GridMetric metric, double maxStepMm);
    }
  }

  /**
   * The outcome of a trial.
   *
   * @param stable whether the handle came to rest during the stay
   * @param excursionMm the excursion of the handle during the last part of the stay
   * @param energyBackMillijoule the largest energy that the contact had put into the handle
   * @param riseNewtonPerMs the largest change of force between two frames
   */
  public record Outcome(
      boolean stable, double excursionMm, double energyBackMillijoule, double riseNewtonPerMs) {}

  /** Runs the trial with a stiffness, N/m. */
  public Outcome run(double newtonPerM) {
    Plant plant = new Plant(device, grip, sampling, reach(), TouchedShape.VOXEL_MM);
    PointFrame frame = frame(plant, newtonPerM);
    long period = sampling.periodNanos();
    long now = 0;
    while (frame.run(now) == FrameOutcome.RUNNING) {
      now += period;
    }
    return new Outcome(
        isStable(plant),
        plant.excursionMm(),
        plant.maxEnergyJoule() * 1e3,
        plant.steepestNewtonPerMs());
  }

  private boolean isStable(Plant plant) {
    double rest = REST_ENCODER_STEPS * device.encoderStepMm() + REST_MM;
    boolean settling = plant.excursionMm() <= SETTLING_FRACTION * plant.earlierExcursionMm();
    return plant.excursionMm() <= rest || (!isBare() && settling);
  }

  private boolean isBare() {
    return grip.armNewtonPerM() == 0;
  }

  private Reach reach() {
    boolean bare = isBare();
    double depthMm =
        bare ? 1 : 1e3 * PRESSED_FRACTION * device.maxForceNewton() / grip.armNewtonPerM();
    return new Reach(
        shape.alongMm(bare ? 0.05 : AWAY_MM),
        shape.alongMm(-depthMm),
        IN_SECONDS,
        bare ? STAY_SECONDS + STAY_ALONE_CONSTANTS * decaySeconds() : STAY_SECONDS);
  }

  private double decaySeconds() {
    return 2 * device.handleKg() / device.dampingNewtonSecondPerM();
  }

  private PointFrame frame(Plant plant, double newtonPerM) {
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
    return new PointFrame(
        GridDevice.inGridCoordinates(plant),
        solver.factory().make(metric, 8 * voxel),
        shape.scene(),
        metric,
        settings,
        new EditQueue(unit, 1),
        FramePublisher.NONE);
  }
}
