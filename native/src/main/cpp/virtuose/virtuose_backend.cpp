#include "virtuose/virtuose_backend.h"

#include <cmath>

#include "device/clock.h"
#include "device/rotation.h"
#include "virtuose/virtuose_api.h"

namespace palpate::virtuose {
namespace {

constexpr double kMmPerMetre = 1000;
constexpr const char* kDefaultHost = "127.0.0.1#5000";
constexpr float kTimeStepSeconds = 0.001F;
constexpr float kTimeoutSeconds = 0.1F;

// The API does not state the limits of a device. These lie below those of every model.
constexpr double kMaxForceNewton = 10;
constexpr double kContinuousForceNewton = 8;
constexpr double kMaxTorqueNewtonMetre = 1;
constexpr double kMaxStiffnessNewtonPerMm = 1;
constexpr double kRadiusMm = 150;

/** One device of Haption in impedance mode, in which each step sends a force. One thread. */
class VirtuoseDevice : public Device {
 public:
  VirtuoseDevice(VirtuoseApi& api, Context context, std::shared_ptr<Trace> trace,
                 Specification specification)
      : Device(std::move(trace), std::move(specification)), api_(api), context_(context) {}

  ReadStatus read(Sample& sample) override;
  bool write(const Wrench& wrench) override;
  bool close() override;

 private:
  static constexpr int kMostFailures = 20;
  static constexpr int kGoodbyes = 3;
  static constexpr int kButtons = 3;

  void readOneState();
  bool ask(const char* name, int (*function)(Context, int*), int& dest);
  void fill(const float (&pose)[7], Sample& sample);
  ReadStatus failed(const char* call);
  bool push(const Wrench& wrench);

  VirtuoseApi& api_;
  Context context_;
  int turn_ = 0;
  int power_ = 0;
  int deadMan_ = 0;
  int operational_ = 0;
  unsigned alarms_ = 0;
  uint32_t buttons_ = 0;
  int failures_ = 0;
  bool gone_ = false;
};

ReadStatus VirtuoseDevice::failed(const char* call) {
  counters().errors++;
  if (++failures_ >= kMostFailures) {
    trace().end(std::string("the device is gone: ") + call + ": " + api_.lastError(context_) +
                ": check its power, network and service");
    gone_ = true;
  }
  return gone_ ? ReadStatus::kDisconnected : ReadStatus::kRepeated;
}

bool VirtuoseDevice::ask(const char* name, int (*function)(Context, int*), int& dest) {
  int value = 0;
  const bool answered = traced(trace(), name, function, context_, &value) == 0;
  dest = answered ? value : 0;  // an unknown state counts as unsafe
  counters().errors += answered ? 0 : 1;
  return answered;
}

/** Reads one state in each frame, in turn, so that a frame never makes more than two queries. */
void VirtuoseDevice::readOneState() {
  const int turn = turn_++ % (4 + kButtons);
  if (turn == 0) {
    ask("virtGetPowerOn", api_.getPowerOn, power_);
  } else if (turn == 1) {
    ask("virtGetDeadMan", api_.getDeadMan, deadMan_);
  } else if (turn == 2) {
    ask("virtGetEmergencyStop", api_.getEmergencyStop, operational_);
  } else if (turn == 3) {
    if (traced(trace(), "virtGetAlarm", api_.getAlarm, context_, &alarms_) != 0) {
      counters().errors++;
    }
  } else {
    int pressed = 0;
    const int button = turn - 4;
    traced(trace(), "virtGetButton", api_.getButton, context_, button, &pressed);
    buttons_ = (buttons_ & ~(1U << button)) | (pressed != 0 ? 1U << button : 0);
  }
}

ReadStatus VirtuoseDevice::read(Sample& sample) {
  if (gone_) {
    return ReadStatus::kDisconnected;
  }
  float pose[7] = {NAN, NAN, NAN, 0, 0, 0, 1};
  if (traced(trace(), "virtGetPosition", api_.getPosition, context_, pose) != 0) {
    return failed("virtGetPosition");
  }
  failures_ = 0;
  readOneState();
  fill(pose, sample);
  counters().samples++;
  return ReadStatus::kFresh;
}

void VirtuoseDevice::fill(const float (&pose)[7], Sample& sample) {
  double turned[3];
  toOurFrame(pose, kMmPerMetre, sample.positionMm);
  toOurFrame(pose + 3, 1, turned);  // the axis of a quaternion is converted like a vector
  for (int axis = 0; axis < 3; axis++) {
    sample.orientation[axis] = turned[axis];
  }
  sample.orientation[3] = static_cast<double>(pose[6]);
  sample.timeNanos = steadyNanos();
  sample.buttons = buttons_;
  const bool ready = power_ != 0 && deadMan_ != 0 && operational_ != 0;
  sample.flags = ready ? uint32_t{kForceReady} : 0;
  sample.flags |= (alarms_ & kAlarmOverheat) != 0 ? uint32_t{kMotorsHot} : 0;
}

bool VirtuoseDevice::push(const Wrench& wrench) {
  float wanted[6];
  toTheirFrame(wrench.forceNewton, wanted);
  toTheirFrame(wrench.torqueNewtonMetre, wanted + 3);
  return traced(trace(), "virtSetForce", api_.setForce, context_, wanted) == 0;
}

bool VirtuoseDevice::write(const Wrench& wrench) {
  if (gone_) {
    return false;
  }
  if (push(wrench)) {
    return true;
  }
  failed("virtSetForce");
  return !gone_;
}

bool VirtuoseDevice::close() {
  bool zeroSent = false;
  for (int i = 0; i < kGoodbyes && !zeroSent; i++) {
    zeroSent = push(Wrench());
  }
  const bool off = traced(trace(), "virtSetPowerOn", api_.setPowerOn, context_, 0) == 0;
  const std::lock_guard<std::mutex> guard(api_.lock);
  traced(trace(), "virtClose", api_.close, context_);
  return zeroSent || off;
}

/**
 * Sets the device up in the order that the maker documents. Stops at the first step that fails, and
 * names it in `why`.
 */
bool setUp(VirtuoseApi& api, Context context, Trace& trace, std::string& why) {
  float none[7] = {0, 0, 0, 0, 0, 0, 1};
  const auto step = [&](const char* name, auto function, auto... arguments) {
    const bool done = why.empty() && traced(trace, name, function, context, arguments...) == 0;
    if (!done && why.empty()) {
      why = std::string(name) + ": " + api.lastError(context);
    }
  };
  step("virtSetIndexingMode", api.setIndexingMode, kIndexingAll);
  step("virtSetForceFactor", api.setForceFactor, 1.0F);
  step("virtSetSpeedFactor", api.setSpeedFactor, 1.0F);
  step("virtSetTimeStep", api.setTimeStep, kTimeStepSeconds);
  step("virtSetTimeoutValue", api.setTimeoutValue, kTimeoutSeconds);
  step("virtSetBaseFrame", api.setBaseFrame, &none[0]);
  step("virtSetObservationFrame", api.setObservationFrame, &none[0]);
  step("virtSetCommandType", api.setCommandType, kImpedance);
  step("virtSaturateTorque", api.saturateTorque, static_cast<float>(kMaxForceNewton),
       static_cast<float>(kMaxTorqueNewtonMetre));
  step("virtSetPowerOn", api.setPowerOn, 1);
  return why.empty();
}

Specification specify(const std::string& host) {
  Specification specification;
  specification.name = "Haption device";
  specification.serial = host;
  specification.watchdog = "the device's controller, 0.1 s, and its dead-man sensor";
  specification.maxForceNewton = kMaxForceNewton;
  specification.continuousForceNewton = kContinuousForceNewton;
  specification.maxTorqueNewtonMetre = kMaxTorqueNewtonMetre;
  specification.maxStiffnessNewtonPerMm = kMaxStiffnessNewtonPerMm;
  specification.workspaceRadiusMm = kRadiusMm;
  return specification;
}

}  // namespace

Finding VirtuoseBackend::probe(Trace& trace) {
  VirtuoseApi& api = VirtuoseApi::instance();
  Finding finding;
  finding.library = api.library;
  finding.why = api.whyNot;
  finding.usable = api.whyNot.empty();
  if (finding.usable) {
    int major = 0;
    int minor = 0;
    if (traced(trace, "virtAPIVersion", api.apiVersion, &major, &minor) == 0) {
      finding.version = std::to_string(major) + "." + std::to_string(minor);
    }
    // The API lists no devices; a device is opened by its address.
    finding.devices.push_back({"HOST", "the device at an address, as virtuose:10.0.0.5", true, ""});
  }
  return finding;
}

std::unique_ptr<Device> VirtuoseBackend::open(const std::string& id, std::shared_ptr<Trace> trace,
                                              std::string& why) {
  VirtuoseApi& api = VirtuoseApi::instance();
  why = api.whyNot;
  if (!why.empty()) {
    return nullptr;
  }
  const std::string host = id.empty() ? kDefaultHost : id;
  const std::lock_guard<std::mutex> guard(api.lock);
  Context context = traced(*trace, "virtOpen", api.open, host.c_str());
  if (context == nullptr) {
    why = "virtOpen " + host + ": " + api.lastError(nullptr) +
          ": check the address, the device's power and its service";
    return nullptr;
  }
  if (!setUp(api, context, *trace, why)) {
    traced(*trace, "virtSetPowerOn", api.setPowerOn, context, 0);
    traced(*trace, "virtClose", api.close, context);
    return nullptr;
  }
  return std::make_unique<VirtuoseDevice>(api, context, std::move(trace), specify(host));
}

}  // namespace palpate::virtuose
