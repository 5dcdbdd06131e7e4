package org.palpate.benchmarks.stability;

/**
 * The sampling of the loop.
 *
 * @param rateHz frames per second; the force is constant between them
 * @param delaySamples frames between a position and the force that results from it
 */
public record Sampling(double rateHz, int delaySamples) {
  private static final double NANOS_PER_SECOND = 1e9;

  /** Returns the length of a frame. */
  public long periodNanos() {
    return Math.round(NANOS_PER_SECOND / rateHz);
  }

  /**
   * Returns the largest stiffness, N/m, of a virtual wall that is passive for physical damping b:
   * {@code K < b/(T/2 + delay)}. Source: Colgate and Schenkel 1997 without delay (2b/T); Hulin,
   * Albu-Schaeffer and Hirzinger 2014 with delay.
   */
  public double passiveNewtonPerM(double dampingNewtonSecondPerM) {
    return dampingNewtonSecondPerM * rateHz / (0.5 + delaySamples);
  }
}
