// A substitute for OpenHaptics' libHD: a scheduler thread that runs its callbacks once a tick,
// frames that must be begun and ended, and a stack of errors.
#include <atomic>
#include <chrono>
#include <cmath>
#include <mutex>
#include <thread>
#include <vector>

#include "substitutes/panel.h"

using substitutes::Call;
using substitutes::panel;

namespace {

struct ErrorInfo {
  unsigned code;
  int internalCode;
  unsigned device;
};

using Callback = unsigned (*)(void*);

constexpr unsigned kInvalid = 0xFFFFFFFF;
constexpr unsigned kCommError = 0x302;
constexpr unsigned kIllegalBegin = 0x400;
constexpr unsigned kFrameError = 0x402;

std::mutex guard;  // guards the members below
std::vector<ErrorInfo> errors;
Callback scheduled = nullptr;
void* scheduledData = nullptr;
std::atomic<bool> running{false};
std::thread scheduler;
thread_local bool inFrame = false;

/** The size of the stack. A session that stays unplugged pushes an error at every call. */
constexpr size_t kMostErrors = 1000;

void push(unsigned code) {
  const std::lock_guard<std::mutex> lock(guard);
  if (errors.size() < kMostErrors) {
    errors.push_back({code, 0, 0});
  }
}

void fail(const Call& call) {
  if (call.fails()) {
    push(kCommError);
  }
}

void runScheduler() {
  while (running.load()) {
    Callback callback = nullptr;
    void* data = nullptr;
    {
      const std::lock_guard<std::mutex> lock(guard);
      callback = scheduled;
      data = scheduledData;
    }
    if (callback != nullptr && callback(data) == 0) {
      const std::lock_guard<std::mutex> lock(guard);
      scheduled = nullptr;
    }
    const int tick = panel().tickMicros.load();
    std::this_thread::sleep_for(std::chrono::microseconds(tick > 0 ? tick : 1000));
  }
}

void stop() {
  running = false;
  if (scheduler.joinable()) {
    scheduler.join();
  }
}

/**
 * Checks that the servo thread is in a frame: once the scheduler runs, it alone may use the state,
 * in frames.
 */
void mustBeInFrame() {
  if (running.load() && !inFrame) {
    panel().ruleBreaks++;
    push(kFrameError);
  }
}

void giveTransform(const Call& call, double* m) {
  // A rotation by 90 degrees about the y axis, which points up; column-major, translation in mm.
  const double turned[16] = {0, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1};
  for (int i = 0; i < 16; i++) {
    m[i] = call.givesNaN() ? NAN : turned[i];
  }
  for (int axis = 0; axis < 3 && !call.givesNaN(); axis++) {
    m[12 + axis] = panel().position[axis];
  }
}

}  // namespace

extern "C" {

unsigned hdInitDevice(const char*) {
  const Call call("hdInitDevice", false);
  if (call.fails() || panel().noDevices) {
    push(0x300);
    return kInvalid;
  }
  panel().openDevices++;
  return 0;
}

void hdMakeCurrentDevice(unsigned) {
  const Call call("hdMakeCurrentDevice", false);
  fail(call);
}

void hdDisableDevice(unsigned) {
  const Call call("hdDisableDevice", false);
  panel().openDevices--;
  fail(call);
}

void hdBeginFrame(unsigned) {
  const Call call("hdBeginFrame");
  if (inFrame) {
    push(kIllegalBegin);
    panel().ruleBreaks++;
  }
  inFrame = true;
  fail(call);
}

void hdEndFrame(unsigned) {
  const Call call("hdEndFrame");
  if (!inFrame) {
    panel().ruleBreaks++;
  }
  inFrame = false;
  fail(call);
}

ErrorInfo hdGetError() {
  const Call call("hdGetError", false);
  const std::lock_guard<std::mutex> lock(guard);
  if (call.fails()) {
    return {kCommError, 0, 0};
  }
  if (errors.empty()) {
    return {0, 0, 0};
  }
  const ErrorInfo last = errors.back();
  errors.pop_back();
  return last;
}

const char* hdGetErrorString(unsigned) { return "HD_COMM_ERROR"; }

void hdEnable(unsigned) {
  const Call call("hdEnable", false);
  fail(call);
}

void hdGetBooleanv(unsigned what, unsigned char* value) {
  const Call call("hdGetBooleanv", false);
  mustBeInFrame();
  *value = what == 0x2001 && panel().notReady == 0 ? 1 : 0;
  fail(call);
}

void hdGetIntegerv(unsigned what, int* value) {
  const Call call("hdGetIntegerv", false);
  if (what == 0x2000) {
    mustBeInFrame();
    *value = panel().buttons.load();
  } else {
    *value = 6;
  }
  fail(call);
}

void hdGetDoublev(unsigned what, double* value) {
  const Call call("hdGetDoublev", false);
  const double workspace[6] = {-80, -60, -35, 80, 60, 35};
  if (what == 0x2052) {
    mustBeInFrame();
    giveTransform(call, value);
  } else if (what == 0x2551) {
    for (int i = 0; i < 6; i++) {
      value[i] = workspace[i];
    }
  } else if (what == 0x2605) {
    for (int i = 0; i < 6; i++) {
      value[i] = 0.25;
    }
  } else {
    const double known = what == 0x2600   ? 1000
                         : what == 0x2602 ? 0.8
                         : what == 0x2603 ? 8.5
                         : what == 0x2604 ? 1.4
                                          : 188;
    *value = call.givesNaN() ? NAN : known;
  }
  fail(call);
}

const char* hdGetString(unsigned what) {
  const Call call("hdGetString", false);
  fail(call);
  return call.fails() ? nullptr : what == 0x2504 ? "30524S00212" : "PHANTOM Premium 1.5 6-DOF";
}

void hdSetDoublev(unsigned what, const double* value) {
  const Call call("hdSetDoublev", false);
  mustBeInFrame();
  if (what == 0x2700 && !call.fails()) {
    const double torque[3] = {panel().torque[0], panel().torque[1], panel().torque[2]};
    substitutes::noteForce(value, torque);
  } else if (what == 0x2701 && !call.fails()) {
    for (int axis = 0; axis < 3; axis++) {
      panel().torque[axis] = value[axis];
    }
  }
  fail(call);
}

unsigned hdCheckCalibration() {
  const Call call("hdCheckCalibration", false);
  const int state = panel().notReady;  // 1 needs the user, 2 an update
  return state == 0 ? 0x5000 : state == 1 ? 0x5002 : 0x5001;
}

unsigned hdCheckCalibrationStyle() {
  const Call call("hdCheckCalibrationStyle", false);
  return 2;
}

void hdUpdateCalibration(unsigned style) {
  const Call call("hdUpdateCalibration", false);
  fail(call);
  if (!call.fails() && panel().notReady == 2 && style == 2) {
    panel().notReady = 0;
  }
}

void hdStartScheduler() {
  const Call call("hdStartScheduler", false);
  fail(call);
  if (!call.fails() && !running.exchange(true)) {
    scheduler = std::thread(runScheduler);
  }
}

void hdStopScheduler() {
  const Call call("hdStopScheduler", false);
  fail(call);
  stop();
}

unsigned long hdScheduleAsynchronous(Callback callback, void* data, unsigned short) {
  const Call call("hdScheduleAsynchronous", false);
  if (call.fails()) {
    push(0x501);
    return kInvalid;
  }
  const std::lock_guard<std::mutex> lock(guard);
  scheduled = callback;
  scheduledData = data;
  return 7;
}

void hdUnschedule(unsigned long) {
  const Call call("hdUnschedule", false);
  const std::lock_guard<std::mutex> lock(guard);
  scheduled = nullptr;
}
}
