#include "hid/wooden_kinematics.h"

#include <cmath>

namespace palpate::hid {
namespace {

constexpr double kPi = 3.14159265358979323846;
/** The sign of each body's rotation per encoder count, as the makers wired the motors. */
constexpr double kEncoderSign[3] = {-1, -1, -1};
constexpr double kMotorSign[3] = {1, -1, -1};

double gear(const WoodenArm& arm, int body) {
  return arm.bodyDiameterMetre[body] / arm.capstanMetre[body];
}

}  // namespace

void woodenAngles(const WoodenArm& arm, const double (&counts)[3], double (&anglesRad)[3]) {
  for (int body = 0; body < 3; body++) {
    const double motorRad = 2 * kPi * counts[body] / arm.countsPerTurn[body];
    anglesRad[body] = kEncoderSign[body] * motorRad / gear(arm, body);
  }
  anglesRad[2] += kPi / 2;  // body C is level at rest
}

void woodenTip(const WoodenArm& arm, const double (&anglesRad)[3], double (&tipMetre)[3]) {
  const double a = anglesRad[0];
  const double b = anglesRad[1];
  const double c = anglesRad[2];
  const double out = arm.lengthMetre[1] * std::sin(b) + arm.lengthMetre[2] * std::sin(c);
  const double up = arm.lengthMetre[1] * std::cos(b) - arm.lengthMetre[2] * std::cos(c);
  tipMetre[0] = std::cos(a) * out - arm.originMetre[0];
  tipMetre[1] = std::sin(a) * out - arm.originMetre[1];
  tipMetre[2] = arm.lengthMetre[0] + up - arm.originMetre[2];
}

void woodenCurrents(const WoodenArm& arm, const double (&anglesRad)[3],
                    const double (&forceNewton)[3], double (&ampere)[3]) {
  const double a = anglesRad[0];
  const double b = anglesRad[1];
  const double c = anglesRad[2];
  const double out = arm.lengthMetre[1] * std::sin(b) + arm.lengthMetre[2] * std::sin(c);
  const double outward = std::cos(a) * forceNewton[0] + std::sin(a) * forceNewton[1];
  const double sideways = std::cos(a) * forceNewton[1] - std::sin(a) * forceNewton[0];
  const double torque[3] = {
      out * sideways,
      arm.lengthMetre[1] * (std::cos(b) * outward - std::sin(b) * forceNewton[2]),
      arm.lengthMetre[2] * (std::cos(c) * outward + std::sin(c) * forceNewton[2]),
  };
  for (int body = 0; body < 3; body++) {
    ampere[body] = kMotorSign[body] * torque[body] /
                   (gear(arm, body) * arm.torqueConstantNewtonMetrePerAmpere);
  }
}

}  // namespace palpate::hid
