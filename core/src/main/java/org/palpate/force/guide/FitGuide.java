package org.palpate.force.guide;

import java.util.Arrays;
import org.palpate.force.HandState;
import org.palpate.force.HapticEffect;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;

/**
 * Pulls a body in hand to the pose at which it fits, in the directions that the fit determines.
 *
 * <p>A new fit may lie elsewhere, or there may be none any more. The offset along which the guide
 * pulls then changes in a frame by at most twice the motion of the hand, or by {@link
 * PositionGuide#LEAST_STEP_MM} in a millisecond. So the force has no step. Haptic thread; allocates
 * nothing.
 *
 * <p>Reference: Olsson et al., Haptics-assisted virtual surgery planning, 2013, for the attraction.
 */
public final class FitGuide implements HapticEffect {
  private static final int FREEDOMS = FitTarget.FREEDOMS;

  private final FitExchange fits;
  private final GuideSpring spring;

  /** Displacement, mm, and rotation times the lever, mm: the whole way and the part to pull. */
  private final double[] way = new double[FREEDOMS];

  private final double[] wanted = new double[FREEDOMS];

  /** The offset along which the guide pulls. */
  private final double[] offset = new double[FREEDOMS];

  private final Pose last = new Pose();
  private final Vec3 displacement = new Vec3();
  private final Vec3 rotation = new Vec3();
  private final Quaternion scratch = new Quaternion();
  private double leverMm;
  private boolean known;

  /**
   * Creates a guide.
   *
   * @param fits hands over where the body in hand fits
   * @param spring the pull along the offset
   */
  public FitGuide(FitExchange fits, GuideSpring spring) {
    this.fits = fits;
    this.spring = spring;
  }

  @Override
  public void reset() {
    known = false;
  }

  @Override
  public void add(HandState hand, Vec3 forceNewton, Vec3 torqueNewtonMm) {
    if (!known) {
      Arrays.fill(offset, 0);
      last.set(hand.device);
      known = true;
    }
    FitTarget fit = fits.newest();
    Arrays.fill(wanted, 0);
    if (fit != null && hand.heldBody >= 0 && fit.body() == hand.heldBody) {
      setWanted(fit, hand.device);
    }
    follow(hand.device, PositionGuide.leastStepMm(hand));
    double length = Math.sqrt(squaredLength(offset));
    if (length > 0) {
      double factor = spring.newton(length) / length;
      displacement.set(offset[0], offset[1], offset[2]).mul(factor, displacement);
      rotation.set(offset[3], offset[4], offset[5]).mul(factor * leverMm, rotation);
      forceNewton.add(displacement, forceNewton);
      torqueNewtonMm.add(rotation, torqueNewtonMm);
    }
  }

  /** Computes the part of the way to a fit that it determines. */
  private void setWanted(FitTarget fit, Pose from) {
    leverMm = fit.leverMm();
    from.differenceTo(fit.pose(), displacement, rotation, scratch);
    for (int axis = 0; axis < 3; axis++) {
      way[axis] = displacement.get(axis);
      way[3 + axis] = leverMm * rotation.get(axis);
    }
    for (int n = 0; n < FREEDOMS; n++) {
      for (int m = 0; m < FREEDOMS; m++) {
        wanted[n] += fit.pull(FREEDOMS * n + m) * way[m];
      }
    }
  }

  /** Moves the offset towards the wanted one. */
  private void follow(Pose at, double leastStepMm) {
    last.differenceTo(at, displacement, rotation, scratch);
    double motionMm =
        Math.sqrt(displacement.dot(displacement) + leverMm * leverMm * rotation.dot(rotation));
    double mostMm = Math.max(leastStepMm, 2 * motionMm);
    for (int n = 0; n < FREEDOMS; n++) {
      way[n] = wanted[n] - offset[n];
    }
    double stepMm = Math.sqrt(squaredLength(way));
    double fraction = stepMm > mostMm ? mostMm / stepMm : 1;
    for (int n = 0; n < FREEDOMS; n++) {
      offset[n] += fraction * way[n];
    }
    last.set(at);
  }

  private static double squaredLength(double[] vector) {
    double sum = 0;
    for (double component : vector) {
      sum += component * component;
    }
    return sum;
  }
}
