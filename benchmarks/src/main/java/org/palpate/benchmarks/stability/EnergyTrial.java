package org.palpate.benchmarks.stability;

/** One set-up of the closed loop that measures the energy which its forces give to the hand. */
public interface EnergyTrial extends LoopTrial {
  /** An effect that gives less over a whole motion counts as passive. */
  double PASSIVE_MILLIJOULE = 0.01;

  /**
   * Returns the energy that the forces gave to the hand over the whole motion, mJ; see {@link
   * HandWork}.
   *
   * @param newtonPerM the stiffness, N/m
   */
  double givenMillijoule(double newtonPerM);

  /** Whether a force follows time; such an effect is active. */
  default boolean isDriven() {
    return false;
  }

  /** Whether the trial counts as passive if its forces gave this energy to the hand. */
  default boolean isPassive(double givenMillijoule) {
    return !isDriven() && givenMillijoule <= PASSIVE_MILLIJOULE;
  }
}
