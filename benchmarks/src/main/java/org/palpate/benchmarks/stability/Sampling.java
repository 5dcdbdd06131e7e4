package org.palpate.benchmarks.stability;

/**
 * When the force follows the position.
 *
 * @param rateHz frames a second; the force is held between them
 * @param delaySamples frames between the position and the force that answers it
 */
public record Sampling(double rateHz, int delaySamples) {
  private static final double NANOS_PER_SECOND = 1e9;

  public long periodNanos() {
    return Math.round(NANOS_PER_SECOND / rateHz);
  }

  /**
   * The largest stiffness, N/m, of a virtual wall that is passive for physical damping b: K <
   * b/(T/2 + delay). Source: Colgate and Schenkel 1997 for no delay (2b/T); Hulin, Albu-Schaeffer
   * and Hirzinger 2014 for the delayed form.
   */
  public double passiveNewtonPerM(double dampingNewtonSecondPerM) {
    return dampingNewtonSecondPerM * rateHz / (0.5 + delaySamples);
  }
}
