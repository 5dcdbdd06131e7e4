#include "openhaptics/openhaptics_backend.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

#include "device/clock.h"
#include "openhaptics/hdapi.h"
#include "openhaptics/servo.h"

namespace palpate::openhaptics {
namespace {

constexpr int kDeepestStack = 10000;

/**
 * One device of HDAPI. The servo loop calls the vendor; this class exchanges samples and wrenches
 * with it. One thread.
 */
class OpenHapticsDevice : public Device {
 public:
  OpenHapticsDevice(HdApi& api, DeviceHandle device, std::shared_ptr<Trace> trace,
                    Specification specification, bool hasTorque, bool isCalibrated)
      : Device(std::move(trace), std::move(specification)),
        api_(api),
        device_(device),
        isCalibrated_(isCalibrated),
        servo_(new Servo(api, device, hasTorque)) {}

  bool start(std::string& why);

  ReadStatus read(Sample& sample) override;
  bool write(const Wrench& wrench) override;
  bool close() override;

 private:
  /** A servo loop without a tick for this time counts as dead. */
  static constexpr int64_t kStandstillNanos = 500 * kNanosPerMilli;
  static constexpr int64_t kLastTickNanos = 100 * kNanosPerMilli;

  ReadStatus standing();
  void stopServo();

  HdApi& api_;
  const DeviceHandle device_;
  const bool isCalibrated_;
  Servo* servo_;  // never deleted if its thread hangs
  SchedulerHandle scheduled_ = kInvalidHandle;
  int64_t tickedNanos_ = 0;
  int64_t lastTick_ = 0;
  bool gone_ = false;
};

/** Keeps a servo alive because its thread may still use it. The caller holds the lock. */
void keepForEver(Servo* servo) {
  static auto* kept = new std::vector<Servo*>();
  kept->push_back(servo);
}

/** Returns the first error on the library's stack as text; empty if there is none. */
std::string errorNow(HdApi& api, Trace& trace, int most = 8) {
  std::string first;
  for (int i = 0; i < most; i++) {
    const ErrorInfo info = traced(trace, "hdGetError", api.getError);
    if (info.code == kSuccess) {
      break;
    }
    if (first.empty()) {
      const char* text = api.getErrorString(info.code);
      first = text != nullptr ? text : "error " + std::to_string(info.code);
    }
  }
  return first;
}

bool OpenHapticsDevice::start(std::string& why) {
  traced(trace(), "hdEnable", api_.enable, kForceOutput);
  if (api_.openDevices == 0) {
    traced(trace(), "hdStartScheduler", api_.startScheduler);
  }
  api_.openDevices++;
  scheduled_ = traced(trace(), "hdScheduleAsynchronous", api_.scheduleAsynchronous, &Servo::tick,
                      static_cast<void*>(servo_), kPriority);
  tickedNanos_ = steadyNanos();
  why = errorNow(api_, trace());
  return why.empty();
}

ReadStatus OpenHapticsDevice::read(Sample& sample) {
  Reading reading;
  if (gone_) {
    return ReadStatus::kDisconnected;
  }
  if (!servo_->take(reading)) {
    return standing();
  }
  tickedNanos_ = steadyNanos();
  counters().samples++;
  counters().merged += std::max<int64_t>(0, reading.tick - lastTick_ - 1);
  counters().errors = reading.failures;
  lastTick_ = reading.tick;
  if (reading.fatal) {
    const char* text = api_.getErrorString(reading.error);
    trace().end(std::string("the servo loop fails: ") + (text != nullptr ? text : "?") +
                ": check the device's cable and power");
    gone_ = true;
    return ReadStatus::kDisconnected;
  }
  if (reading.error != kSuccess) {
    return ReadStatus::kRepeated;
  }
  sample = reading.sample;
  sample.flags &= isCalibrated_ ? ~uint32_t{0} : ~uint32_t{kForceReady};
  sample.flags |= isCalibrated_ ? 0 : uint32_t{kNeedsCalibration};
  return ReadStatus::kFresh;
}

ReadStatus OpenHapticsDevice::standing() {
  if (steadyNanos() - tickedNanos_ < kStandstillNanos) {
    return ReadStatus::kRepeated;
  }
  const char* call = servo_->call();
  trace().end(std::string("the servo loop stands still") +
              (call != nullptr ? std::string(" in ") + call : std::string()) +
              ": the force is left to " + specification().watchdog);
  gone_ = true;
  return ReadStatus::kDisconnected;
}

bool OpenHapticsDevice::write(const Wrench& wrench) {
  if (!gone_) {
    servo_->order(wrench);
  }
  return !gone_;
}

void OpenHapticsDevice::stopServo() {
  if (scheduled_ == kInvalidHandle) {
    return;
  }
  servo_->end();
  const Deadline deadline(kLastTickNanos);
  while (!servo_->hasSentZero() && !deadline.isOver()) {
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
}

bool OpenHapticsDevice::close() {
  stopServo();
  const std::lock_guard<std::mutex> guard(api_.lock);
  const bool stopped = --api_.openDevices == 0;
  if (stopped) {
    traced(trace(), "hdStopScheduler", api_.stopScheduler);
    if (!servo_->hasSentZero()) {
      servo_->sendZero();  // no tick has done it, and none can run at the same time any more
    }
  }
  const bool zeroSent = servo_->hasSentZero();
  if (scheduled_ != kInvalidHandle) {
    traced(trace(), "hdUnschedule", api_.unschedule, scheduled_);
  }
  traced(trace(), "hdDisableDevice", api_.disableDevice, device_);
  if (stopped || zeroSent) {
    delete servo_;
  } else {
    keepForEver(servo_);
  }
  return zeroSent;
}

double doubleOf(HdApi& api, Trace& trace, unsigned what, double atLeast, double atMost,
                double otherwise) {
  double value[6] = {NAN, NAN, NAN, NAN, NAN, NAN};
  traced(trace, "hdGetDoublev", api.getDoublev, what, value);
  return value[0] > atLeast && value[0] <= atMost ? value[0] : otherwise;
}

std::string textOf(HdApi& api, Trace& trace, unsigned what, const char* otherwise) {
  const char* text = traced(trace, "hdGetString", api.getString, what);
  return text != nullptr ? text : otherwise;
}

/**
 * Returns half the smallest edge of the workspace, mm. The library gives the minima, then the
 * maxima.
 */
double radiusOf(HdApi& api, Trace& trace) {
  double box[6] = {-60, -40, -30, 60, 40, 30};
  traced(trace, "hdGetDoublev", api.getDoublev, kUsableWorkspace, box);
  const double edge = std::min({box[3] - box[0], box[4] - box[1], box[5] - box[2]});
  return edge > 0 ? edge / 2 : 30;
}

Specification specify(HdApi& api, Trace& trace) {
  Specification specification;
  specification.name = textOf(api, trace, kModelType, "PHANToM");
  specification.serial = textOf(api, trace, kSerialNumber, "");
  specification.watchdog = "our part of the vendor's servo loop, 20 ms";
  specification.maxForceNewton = doubleOf(api, trace, kNominalMaxForce, 0, 100, 3.3);
  specification.continuousForceNewton = doubleOf(api, trace, kNominalContinuousForce, 0, 100, 0.9);
  specification.maxStiffnessNewtonPerMm = doubleOf(api, trace, kNominalMaxStiffness, 0, 5, 0.4);
  specification.workspaceRadiusMm = radiusOf(api, trace);
  specification.reportIntervalNanos =
      static_cast<int64_t>(kNanosPerSecond / doubleOf(api, trace, kUpdateRate, 100, 10000, 1000));
  return specification;
}

/** Returns whether the device is calibrated. Updates the calibration if nothing else is needed. */
bool calibrate(HdApi& api, Trace& trace) {
  unsigned state = traced(trace, "hdCheckCalibration", api.checkCalibration);
  if (state == kCalibrationNeedsUpdate) {
    const unsigned style = traced(trace, "hdCheckCalibrationStyle", api.checkCalibrationStyle);
    traced(trace, "hdUpdateCalibration", api.updateCalibration, style);
    state = traced(trace, "hdCheckCalibration", api.checkCalibration);
  }
  return state == kCalibrationOk;
}

}  // namespace

Finding OpenHapticsBackend::probe(Trace&) {
  HdApi& api = HdApi::instance();
  Finding finding;
  finding.library = api.library;
  finding.why = api.whyNot;
  finding.usable = api.whyNot.empty();
  if (finding.usable) {
    // HDAPI lists no devices. The vendor's set-up program gives each device its name.
    finding.devices.push_back({"", "the one that the vendor's set-up calls default", true, ""});
  }
  return finding;
}

std::unique_ptr<Device> OpenHapticsBackend::open(const std::string& id,
                                                 std::shared_ptr<Trace> trace, std::string& why) {
  HdApi& api = HdApi::instance();
  why = api.whyNot;
  if (!why.empty()) {
    return nullptr;
  }
  std::unique_lock<std::mutex> guard(api.lock);
  errorNow(api, *trace, kDeepestStack);  // discards the errors of an earlier session
  const DeviceHandle device =
      traced(*trace, "hdInitDevice", api.initDevice, id.empty() ? nullptr : id.c_str());
  why = errorNow(api, *trace);
  if (device == kInvalidHandle || !why.empty()) {
    why = "hdInitDevice: " + (why.empty() ? std::string("no such device") : why) +
          ": check cable, power and the name in the vendor's set-up";
    if (device != kInvalidHandle) {
      traced(*trace, "hdDisableDevice", api.disableDevice, device);
    }
    return nullptr;
  }
  traced(*trace, "hdMakeCurrentDevice", api.makeCurrentDevice, device);
  Specification specification = specify(api, *trace);
  int outputDof = 3;
  traced(*trace, "hdGetIntegerv", api.getIntegerv, kOutputDof, &outputDof);
  specification.maxTorqueNewtonMetre =
      outputDof >= 6 ? doubleOf(api, *trace, kNominalMaxTorque, 0, 1000, 188) / 1000 : 0;
  const bool calibrated = calibrate(api, *trace);
  errorNow(api, *trace);  // discards the errors of functions that this model does not have
  auto opened = std::make_unique<OpenHapticsDevice>(api, device, trace, specification,
                                                    outputDof >= 6, calibrated);
  if (!opened->start(why)) {
    guard.unlock();
    opened->close();
    why = "the servo loop does not start: " + why;
    return nullptr;
  }
  return opened;
}

}  // namespace palpate::openhaptics
