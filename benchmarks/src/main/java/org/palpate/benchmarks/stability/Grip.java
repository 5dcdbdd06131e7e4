package org.palpate.benchmarks.stability;

/**
 * The person: a hand held by the arm, with the handle in its grip. Two springs and dampers in a
 * row, the hand's mass between them.
 *
 * <p>The values span what is plausible for fingers and a hand; no single source stands behind them,
 * and the study sweeps them.
 *
 * @param name as tables tell it
 * @param handKg mass of the hand that moves with the handle
 * @param gripNewtonPerM spring between hand and handle
 * @param gripNewtonSecondPerM damper between hand and handle
 * @param armNewtonPerM spring between the hand and where the person wants it
 * @param armNewtonSecondPerM damper there
 * @param pressNewton a constant force on the handle downwards, for one that no hand holds
 */
public record Grip(
    String name,
    double handKg,
    double gripNewtonPerM,
    double gripNewtonSecondPerM,
    double armNewtonPerM,
    double armNewtonSecondPerM,
    double pressNewton) {

  /** Nobody: the handle lies on the surface with 0.5 N. The hardest case, and the theory's. */
  public static final Grip NONE = new Grip("none", 0.1, 0, 0, 0, 1, 0.5);

  /** Two fingers that hardly hold. */
  public static final Grip LIGHT = new Grip("light", 0.08, 400, 1.5, 150, 1.5, 0);

  /** A hand that holds firmly. */
  public static final Grip FIRM = new Grip("firm", 0.3, 1500, 8, 400, 8, 0);
}
