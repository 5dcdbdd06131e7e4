package org.palpate.benchmarks.stability;

import java.util.ArrayList;
import java.util.List;
import org.palpate.benchmarks.stability.ClosedLoop.Outcome;

/**
 * The margin of a device's default stiffness in a trial with the limits of a live session.
 *
 * @param trial the set-up
 * @param defaultStiffness half the device's maximum, N/m
 * @param largest the largest stable stiffness, N/m
 * @param atDefault the outcome at the default stiffness
 */
public record MarginRow<T extends LoopTrial>(
    T trial, double defaultStiffness, double largest, Outcome atDefault) {
  private static final double N_PER_M_PER_MM = 1e3;
  private static final double DEFAULT_FRACTION = 0.5;

  /** Runs a trial at the default stiffness, and searches its largest stable stiffness. */
  static <T extends LoopTrial> MarginRow<T> of(T trial) {
    double defaultStiffness = defaultNewtonPerM(trial.device());
    return new MarginRow<>(
        trial, defaultStiffness, StiffnessSearch.largest(trial::run), trial.run(defaultStiffness));
  }

  /** Returns the default stiffness of a device, N/m. */
  static double defaultNewtonPerM(DeviceModel device) {
    return DEFAULT_FRACTION * device.maxStiffnessNewtonPerMm() * N_PER_M_PER_MM;
  }

  /** Returns the largest stable stiffness relative to the default. */
  public double margin() {
    return largest / defaultStiffness;
  }

  /** Returns the cells of its row in {@code stability-devices.csv} and its like. */
  List<Object> cells() {
    List<Object> cells = new ArrayList<>();
    cells.add(trial.device().name());
    cells.add(trial.grip().name());
    cells.addAll(trial.conditionCells());
    cells.add(trial.sampling().rateHz());
    cells.add(trial.sampling().delaySamples());
    cells.add(trial.device().handleKg());
    cells.add(trial.device().dampingNewtonSecondPerM());
    cells.add(defaultStiffness);
    cells.add(largest);
    cells.add(margin());
    cells.add(atDefault.excursionMm());
    cells.add(atDefault.energyBackMillijoule());
    cells.add(atDefault.riseNewtonPerMs());
    return cells;
  }
}
