// A substitute for Haption's Virtuose API 4, with floats, metres and 0 for success. It records each
// call against the documented order.
#include <cmath>

#include "substitutes/panel.h"

using substitutes::Call;
using substitutes::panel;

namespace {

struct State {
  int commandType = 0;
  int power = 0;
  bool stepSet = false;
  bool factorsSet = false;
} state;

constexpr int kImpedance = 3;
constexpr int kWrongMode = 17;
constexpr int kCommunicationFailure = 2;
char context;
char message[] = "communication failure";

int answer(const Call& call) { return call.fails() ? kCommunicationFailure : 0; }

void mustBe(bool inOrder) { panel().ruleBreaks += inOrder ? 0 : 1; }

int give(const Call& call, int* to, int value) {
  *to = value;
  return answer(call);
}

}  // namespace

extern "C" {

void* virtOpen(const char* host) {
  const Call call("virtOpen");
  if (call.fails() || panel().noDevices || host == nullptr) {
    return nullptr;
  }
  state = State();
  panel().openDevices++;
  return &context;
}

int virtClose(void*) {
  const Call call("virtClose");
  panel().openDevices--;
  return answer(call);
}

int virtGetErrorCode(void*) { return kCommunicationFailure; }
char* virtGetErrorMessage(int) { return message; }

int virtAPIVersion(int* major, int* minor) {
  const Call call("virtAPIVersion");
  *major = 4;
  *minor = 4;
  return answer(call);
}

int virtSetIndexingMode(void*, int) {
  const Call call("virtSetIndexingMode");
  mustBe(state.commandType == 0);
  return answer(call);
}

int virtSetForceFactor(void*, float) {
  const Call call("virtSetForceFactor");
  mustBe(state.commandType == 0);
  state.factorsSet = true;
  return answer(call);
}

int virtSetSpeedFactor(void*, float) {
  const Call call("virtSetSpeedFactor");
  mustBe(state.commandType == 0);
  return answer(call);
}

int virtSetTimeStep(void*, float seconds) {
  const Call call("virtSetTimeStep");
  mustBe(state.commandType == 0 && seconds > 0);
  state.stepSet = true;
  return answer(call);
}

int virtSetTimeoutValue(void*, float) {
  const Call call("virtSetTimeoutValue");
  return answer(call);
}

int virtSetBaseFrame(void*, float* pose) {
  const Call call("virtSetBaseFrame");
  mustBe(pose[6] == 1);
  return answer(call);
}

int virtSetObservationFrame(void*, float* pose) {
  const Call call("virtSetObservationFrame");
  mustBe(pose[6] == 1);
  return answer(call);
}

int virtSetCommandType(void*, int type) {
  const Call call("virtSetCommandType");
  mustBe(state.stepSet && state.factorsSet);
  state.commandType = type;
  return answer(call);
}

int virtSaturateTorque(void*, float, float) {
  const Call call("virtSaturateTorque");
  return answer(call);
}

int virtSetPowerOn(void*, int on) {
  const Call call("virtSetPowerOn");
  mustBe(on == 0 || state.commandType == kImpedance);
  const double none[3] = {0, 0, 0};
  if (on == 0 && !call.fails()) {
    substitutes::noteForce(none, none);
  }
  state.power = on;
  return answer(call);
}

int virtGetPosition(void*, float* pose) {
  const Call call("virtGetPosition");
  for (int axis = 0; axis < 3; axis++) {
    pose[axis] = static_cast<float>(panel().position[axis]);
    pose[3 + axis] = 0;
  }
  pose[0] = call.givesNaN() ? NAN : pose[0];
  pose[5] = std::sqrt(0.5F);  // a rotation by 90 degrees about the vendor's z axis, up
  pose[6] = std::sqrt(0.5F);
  return answer(call);
}

int virtSetForce(void*, float* wanted) {
  const Call call("virtSetForce");
  if (state.commandType != kImpedance || state.power == 0) {
    return kWrongMode;
  }
  const double force[3] = {wanted[0], wanted[1], wanted[2]};
  const double torque[3] = {wanted[3], wanted[4], wanted[5]};
  if (!call.fails()) {
    substitutes::noteForce(force, torque);
  }
  return answer(call);
}

int virtGetButton(void*, int button, int* pressed) {
  const Call call("virtGetButton");
  return give(call, pressed, panel().buttons.load() >> button & 1);
}

int virtGetDeadMan(void*, int* held) {
  const Call call("virtGetDeadMan");
  return give(call, held, panel().notReady ? 0 : 1);
}

int virtGetEmergencyStop(void*, int* operational) {
  const Call call("virtGetEmergencyStop");
  return give(call, operational, 1);
}

int virtGetPowerOn(void*, int* on) {
  const Call call("virtGetPowerOn");
  return give(call, on, state.power);
}

int virtGetAlarm(void*, unsigned* alarms) {
  const Call call("virtGetAlarm");
  *alarms = 0;
  return answer(call);
}
}
