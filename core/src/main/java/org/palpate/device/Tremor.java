package org.palpate.device;

import java.util.SplittableRandom;
import org.palpate.geometry.Vec3;

/**
 * The tremor of a hand: a small periodic displacement and rotation, each about three axes with
 * random phases.
 *
 * <p>Physiological tremor of a raised hand lies at 8 to 12 Hz. Source: Elble and Koller, Tremor,
 * 1990. Immutable.
 */
public final class Tremor {
  /** A hand without tremor. */
  public static final Tremor NONE = new Tremor(0, 0, 0, 0);

  private static final int AXES = 6;

  private final double amplitudeMm;
  private final double amplitudeRad;
  private final double hertz;
  private final double[] phases = new double[AXES];

  /**
   * Creates a tremor.
   *
   * @param amplitudeMm the amplitude along each axis, mm
   * @param amplitudeRad the amplitude about each axis, rad
   * @param hertz its frequency
   * @param seed chooses the phases
   */
  public Tremor(double amplitudeMm, double amplitudeRad, double hertz, long seed) {
    this.amplitudeMm = amplitudeMm;
    this.amplitudeRad = amplitudeRad;
    this.hertz = hertz;
    SplittableRandom random = new SplittableRandom(seed);
    for (int axis = 0; axis < AXES; axis++) {
      phases[axis] = 2 * Math.PI * random.nextDouble();
    }
  }

  /**
   * {@return the tremor of a hand that is simulated: 0.3 mm along and 1 degree about each axis, at
   * 8 Hz}
   *
   * @param seed chooses the phases
   */
  public static Tremor ofHand(long seed) {
    return new Tremor(0.3, Math.toRadians(1), 8, seed);
  }

  /**
   * Writes the tremor at a time.
   *
   * @param fraction of the amplitude, 0 to 1
   * @param displacementMm written, mm
   * @param rotationVector written, rad
   */
  void at(double seconds, double fraction, Vec3 displacementMm, Vec3 rotationVector) {
    for (int axis = 0; axis < 3; axis++) {
      displacementMm.set(axis, fraction * amplitudeMm * wave(seconds, axis));
      rotationVector.set(axis, fraction * amplitudeRad * wave(seconds, 3 + axis));
    }
  }

  private double wave(double seconds, int axis) {
    return StrictMath.sin(2 * Math.PI * hertz * seconds + phases[axis]);
  }
}
