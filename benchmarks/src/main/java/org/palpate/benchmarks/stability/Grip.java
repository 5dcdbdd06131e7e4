package org.palpate.benchmarks.stability;

/**
 * A model of the person: the arm drives a hand that grips the handle. Two springs and dampers in
 * series with the hand's mass between them.
 *
 * <p>The values span what is plausible for fingers and a hand. They have no single source, and the
 * study sweeps them.
 *
 * @param name the name in tables
 * @param handKg the mass of the hand that moves with the handle
 * @param gripNewtonPerM the spring between hand and handle
 * @param gripNewtonSecondPerM the damper between hand and handle
 * @param armNewtonPerM the spring between the hand and its intended position
 * @param armNewtonSecondPerM the damper between the hand and its intended position
 * @param pressNewton a constant force on the handle towards the surface, if no hand holds it
 */
public record Grip(
    String name,
    double handKg,
    double gripNewtonPerM,
    double gripNewtonSecondPerM,
    double armNewtonPerM,
    double armNewtonSecondPerM,
    double pressNewton) {

  /**
   * The radius about which the hand turns the handle, mm: rotations have the masses, springs and
   * dampers of translations times its square.
   */
  static final double RADIUS_MM = 20;

  /** No hand; 0.5 N press the handle on the surface. The hardest case, and that of the theory. */
  public static final Grip NONE = new Grip("none", 0.1, 0, 0, 0, 1, 0.5);

  /** A light grip with two fingers. */
  public static final Grip LIGHT = new Grip("light", 0.08, 400, 1.5, 150, 1.5, 0);

  /** A firm grip of the hand. */
  public static final Grip FIRM = new Grip("firm", 0.3, 1500, 8, 400, 8, 0);
}
