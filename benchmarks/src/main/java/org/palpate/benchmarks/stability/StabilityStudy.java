package org.palpate.benchmarks.stability;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import org.palpate.benchmarks.stability.Trial.Outcome;
import org.palpate.benchmarks.stability.Trial.SolverChoice;
import org.palpate.proxy.exact.GuardedSolver;

/**
 * The sweeps. Each gives rows; what runs is told to a listener, a line at a time.
 *
 * <p>The default stiffness of a device is half its maximum, scaled by the workspace; the scale
 * cancels at the handle, so the model needs none.
 */
public final class StabilityStudy {
  /** The guarded solver, by which devices and theory are measured. */
  public static final SolverChoice GUARDED = new SolverChoice("guarded", GuardedSolver::new);

  private static final double N_PER_M_PER_MM = 1e3;
  private static final double DEFAULT_SHARE = 0.5;
  private static final Sampling USUAL = new Sampling(1000, 1);

  private final boolean quick;
  private final List<SolverChoice> solvers;
  private final Consumer<String> progress;
  private final TouchedShape wall = TouchedShape.wall();

  /**
   * A study.
   *
   * @param quick fewer values in each sweep
   * @param solvers those that are compared on shapes
   * @param progress hears what runs
   */
  public StabilityStudy(boolean quick, List<SolverChoice> solvers, Consumer<String> progress) {
    this.quick = quick;
    this.solvers = List.copyOf(solvers);
    this.progress = progress;
  }

  /**
   * The model beside the theory: a handle that no hand holds, on a flat wall.
   *
   * @param sampling rate and delay
   * @param damping physical damping b, N s/m
   * @param largest largest stiffness at which the handle rests, N/m
   * @param passive what the theory allows, N/m
   */
  public record TheoryRow(Sampling sampling, double damping, double largest, double passive) {}

  /** Sweeps rate, delay and physical damping. */
  public List<TheoryRow> theory() {
    double[] rates =
        quick ? new double[] {1000, 4000} : new double[] {500, 1000, 2000, 4000, 10_000, 20_000};
    double[] dampings = quick ? new double[] {2} : new double[] {0.5, 2, 8};
    DeviceModel bare = new DeviceModel("bare", 1000, 1, 0.1, 1, 1).withFineEncoder();
    List<TheoryRow> rows = new ArrayList<>();
    for (double damping : dampings) {
      for (int delay = 0; delay <= 2; delay++) {
        for (double rate : rates) {
          Sampling sampling = new Sampling(rate, delay);
          progress.accept("theory: b=" + damping + " delay=" + delay + " rate=" + rate);
          Trial trial =
              new Trial(bare.withDamping(damping), Grip.NONE, sampling, wall, GUARDED, false);
          rows.add(
              new TheoryRow(
                  sampling,
                  damping,
                  StiffnessSearch.largest(trial),
                  sampling.passiveNewtonPerM(damping)));
        }
      }
    }
    return rows;
  }

  /**
   * A device at 1 kHz with the limits of a live session.
   *
   * @param trial who with what
   * @param defaultStiffness half the device's maximum, N/m
   * @param largest largest stiffness at which the handle rests, N/m
   * @param atDefault what happens at the default
   */
  public record DeviceRow(Trial trial, double defaultStiffness, double largest, Outcome atDefault) {
    public double margin() {
      return largest / defaultStiffness;
    }
  }

  /** Sweeps devices by name, mass, damping, grip and delay. */
  public List<DeviceRow> devices() {
    double[] shares = quick ? new double[] {0.5, 2} : new double[] {0.5, 1, 2};
    double[] dampingShares = quick ? new double[] {0.25, 1} : new double[] {0.25, 1, 4};
    List<DeviceRow> rows = new ArrayList<>();
    for (DeviceModel device : DeviceModel.KNOWN) {
      for (Grip grip : List.of(Grip.LIGHT, Grip.FIRM)) {
        for (int delay = 1; delay <= 2; delay++) {
          progress.accept("devices: " + device.name() + " grip=" + grip.name() + " delay=" + delay);
          for (double share : shares) {
            for (double dampingShare : dampingShares) {
              DeviceModel varied =
                  device
                      .withHandleKg(device.handleKg() * share)
                      .withDamping(device.dampingNewtonSecondPerM() * dampingShare);
              rows.add(row(varied, grip, new Sampling(USUAL.rateHz(), delay)));
            }
          }
        }
      }
    }
    return rows;
  }

  private DeviceRow row(DeviceModel device, Grip grip, Sampling sampling) {
    double usual = defaultNewtonPerM(device);
    Trial trial = new Trial(device, grip, sampling, wall, GUARDED, true);
    return new DeviceRow(trial, usual, StiffnessSearch.largest(trial), trial.run(usual));
  }

  private static double defaultNewtonPerM(DeviceModel device) {
    return DEFAULT_SHARE * device.maxStiffnessNewtonPerMm() * N_PER_M_PER_MM;
  }

  /** Every shape by every solver: the softest and the stiffest kind of device, firmly held. */
  public List<DeviceRow> shapes() {
    List<DeviceModel> devices =
        DeviceModel.KNOWN.stream()
            .filter(device -> List.of("Touch", "omega").contains(device.name()))
            .toList();
    List<DeviceRow> rows = new ArrayList<>();
    for (TouchedShape shape : TouchedShape.all()) {
      for (SolverChoice solver : solvers) {
        for (DeviceModel device : devices) {
          progress.accept(
              "shapes: " + shape.name() + " by " + solver.name() + " with " + device.name());
          Trial trial = new Trial(device, Grip.FIRM, USUAL, shape, solver, true);
          double usual = defaultNewtonPerM(device);
          rows.add(new DeviceRow(trial, usual, StiffnessSearch.largest(trial), trial.run(usual)));
        }
      }
    }
    return rows;
  }

  /** The least margin of each device, in the order in which devices come. */
  public static Map<String, Double> leastMargins(List<DeviceRow> rows) {
    Map<String, Double> least = new LinkedHashMap<>();
    for (DeviceRow row : rows) {
      least.merge(row.trial().device().name(), row.margin(), Math::min);
    }
    return least;
  }
}
