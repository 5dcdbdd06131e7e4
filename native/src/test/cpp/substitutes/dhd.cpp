// A substitute for Force Dimension's libdhd with the functions that the back end uses, as the
// vendor's header and manual describe them.
#include <cmath>

#include "substitutes/panel.h"

using substitutes::Call;
using substitutes::panel;

namespace {

constexpr int kTimeGuard = 1;
int calls = 0;

int answer(const Call& call) { return call.fails() ? -1 : 0; }

/** Reports every tenth query of a position as too early. */
int guarded(const Call& call) { return call.fails() ? -1 : ++calls % 10 == 0 ? kTimeGuard : 0; }

void position(const Call& call, double* x, double* y, double* z) {
  *x = call.givesNaN() ? NAN : panel().position[0];
  *y = panel().position[1];
  *z = panel().position[2];
}

}  // namespace

extern "C" {

int dhdGetDeviceCount() {
  const Call call("dhdGetDeviceCount");
  return call.fails() ? -1 : panel().noDevices ? 0 : 1;
}

int dhdOpen() {
  const Call call("dhdOpen");
  if (call.fails() || panel().noDevices) {
    return -1;
  }
  panel().openDevices++;
  return 0;
}

int dhdOpenSerial(int serial) {
  const Call call("dhdOpenSerial");
  if (call.fails() || serial != 1234) {
    return -1;
  }
  panel().openDevices++;
  return 0;
}

int dhdClose(char) {
  const Call call("dhdClose");
  panel().openDevices--;
  return answer(call);
}

int dhdStop(char) {
  const Call call("dhdStop");
  const double none[3] = {0, 0, 0};
  if (!call.fails()) {
    substitutes::noteForce(none, none);
  }
  return answer(call);
}

int dhdEnableForce(unsigned char, char) {
  const Call call("dhdEnableForce");
  return answer(call);
}

int dhdGetSystemType(char) {
  const Call call("dhdGetSystemType");
  return call.fails() ? -1 : 35;
}

const char* dhdGetSystemName(char) {
  const Call call("dhdGetSystemName");
  return call.fails() ? nullptr : "omega.7";
}

int dhdGetSerialNumber(unsigned short* serial, char) {
  const Call call("dhdGetSerialNumber");
  *serial = 1234;
  return answer(call);
}

int dhdGetPosition(double* x, double* y, double* z, char) {
  const Call call("dhdGetPosition");
  position(call, x, y, z);
  return guarded(call);
}

int dhdGetPositionAndOrientationFrame(double* x, double* y, double* z, double matrix[3][3], char) {
  const Call call("dhdGetPositionAndOrientationFrame");
  // A rotation by 90 degrees about the vendor's z axis, which points up; row-major.
  const double turned[3][3] = {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}};
  position(call, x, y, z);
  for (int row = 0; row < 3; row++) {
    for (int column = 0; column < 3; column++) {
      matrix[row][column] = call.givesNaN() ? NAN : turned[row][column];
    }
  }
  return guarded(call);
}

unsigned dhdGetButtonMask(char) {
  const Call call("dhdGetButtonMask");
  return call.fails() ? 0 : static_cast<unsigned>(panel().buttons.load());
}

int dhdSetForceAndTorque(double fx, double fy, double fz, double tx, double ty, double tz, char) {
  const Call call("dhdSetForceAndTorque");
  const double force[3] = {fx, fy, fz};
  const double torque[3] = {tx, ty, tz};
  if (!call.fails()) {
    substitutes::noteForce(force, torque);
  }
  const bool saturated = std::fabs(fx) > 11 || std::fabs(fy) > 11 || std::fabs(fz) > 11;
  return call.fails() ? -1 : saturated ? 2 : 0;
}

int dhdGetStatus(int status[17], char) {
  const Call call("dhdGetStatus");
  for (int i = 0; i < 17; i++) {
    status[i] = 0;
  }
  status[0] = 1;
  status[1] = panel().unplugged ? 0 : 1;
  status[2] = 1;
  status[5] = panel().notReady ? 0 : 1;
  return answer(call);
}

bool dhdHasWrist(char) {
  const Call call("dhdHasWrist");
  return !call.fails();
}

bool dhdHasActiveWrist(char) {
  const Call call("dhdHasActiveWrist");
  return false;
}

const char* dhdErrorGetLastStr() { return "communication error"; }

void dhdEnableExpertMode() { const Call call("dhdEnableExpertMode"); }

int dhdSetWatchdog(unsigned char steps, char) {
  const Call call("dhdSetWatchdog");
  if (steps != 160) {
    panel().ruleBreaks++;
  }
  return answer(call);
}
}
