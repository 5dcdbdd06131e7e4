#ifndef PALPATE_HID_WOODEN_KINEMATICS_H
#define PALPATE_HID_WOODEN_KINEMATICS_H

namespace palpate::hid {

/**
 * The arm of a WoodenHaptics, as its makers publish it. Body A turns about the vertical axis and
 * carries bodies B and C. A capstan drives each body. Units are metres, radians and newton metres.
 * The makers' frame has x towards the person, y to the right and z up.
 */
struct WoodenArm {
  double capstanMetre[3] = {0.010, 0.010, 0.010};
  double bodyDiameterMetre[3] = {0.160, 0.120, 0.120};
  double lengthMetre[3] = {0.080, 0.205, 0.200};
  double originMetre[3] = {0.220, 0.000, 0.080};
  double torqueConstantNewtonMetrePerAmpere = 0.0603;
  double countsPerTurn[3] = {4096, 2000, 2000};
};

/** Converts encoder counts to the angles of the bodies: A and B from upright, C from level. */
void woodenAngles(const WoodenArm& arm, const double (&counts)[3], double (&anglesRad)[3]);

/** Writes the position of the tip. */
void woodenTip(const WoodenArm& arm, const double (&anglesRad)[3], double (&tipMetre)[3]);

/** Writes the currents, A, with which the tip exerts a force, by the transposed Jacobian. */
void woodenCurrents(const WoodenArm& arm, const double (&anglesRad)[3],
                    const double (&forceNewton)[3], double (&ampere)[3]);

}  // namespace palpate::hid

#endif
