#ifndef PALPATE_HID_WOODEN_KINEMATICS_H
#define PALPATE_HID_WOODEN_KINEMATICS_H

namespace palpate::hid {

/**
 * The arm of a WoodenHaptics as its makers publish it: body A turns about the upright axis, bodies
 * B and C stand on it, each driven by a capstan. Metres, radians, newton metres; the maker's frame
 * is x towards the person, y to the right, z up.
 */
struct WoodenArm {
  double capstanMetre[3] = {0.010, 0.010, 0.010};
  double bodyDiameterMetre[3] = {0.160, 0.120, 0.120};
  double lengthMetre[3] = {0.080, 0.205, 0.200};
  double originMetre[3] = {0.220, 0.000, 0.080};
  double torqueConstantNewtonMetrePerAmpere = 0.0603;
  double countsPerTurn[3] = {4096, 2000, 2000};
};

/** Turns of bodies A and B from the upright, of C from the level; from encoder counts. */
void woodenAngles(const WoodenArm& arm, const double (&counts)[3], double (&anglesRad)[3]);

/** Where the tip is. */
void woodenTip(const WoodenArm& arm, const double (&anglesRad)[3], double (&tipMetre)[3]);

/** The currents, in ampere, that make the tip push with that force: the transposed Jacobian. */
void woodenCurrents(const WoodenArm& arm, const double (&anglesRad)[3],
                    const double (&forceNewton)[3], double (&ampere)[3]);

}  // namespace palpate::hid

#endif
