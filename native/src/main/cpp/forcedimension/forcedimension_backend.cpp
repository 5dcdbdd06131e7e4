#include "forcedimension/forcedimension_backend.h"

#include <cmath>

#include "device/clock.h"
#include "device/rotation.h"
#include "forcedimension/dhd.h"

namespace palpate::forcedimension {
namespace {

constexpr double kMmPerMetre = 1000;
constexpr const char* kReplug = ": check its cable and power, then start again";

/**
 * The data of a model from its maker and from CHAI3D's tables. Forces are continuous ones, except
 * for the Falcon.
 *
 * The stiffness is not the maker's, which is 3 to 8 N/mm at up to 4 kHz. In the closed-loop model
 * of `bench --stability`, that vibrates a loosely held handle at 1 kHz. The value here is stable in
 * that model with a delay of two frames, twice the assumed mass and a quarter of the assumed
 * damping.
 */
struct Model {
  int type;
  double forceNewton;
  double continuousNewton;
  double stiffnessNewtonPerMm;
  double radiusMm;
};
constexpr Model kModels[] = {
    {33, 12, 12, 0.7, 75},     {34, 12, 12, 0.7, 75},     {35, 12, 12, 0.7, 75},
    {36, 12, 12, 0.7, 75},     {37, 12, 12, 0.7, 75},     {63, 20, 20, 0.6, 150},
    {104, 12, 12, 0.45, 75},   {105, 12, 12, 0.45, 75},   {206, 12, 12, 0.45, 75},
    {108, 12, 12, 0.4, 112.5}, {109, 12, 12, 0.4, 112.5}, {131, 12, 12, 0.4, 112.5},
    {132, 12, 12, 0.4, 112.5}, {203, 12, 12, 0.4, 112.5}, {60, 8, 4, 0.75, 40},
};
/** The model for a type that is not in the table, with less than the smallest of each value. */
constexpr Model kUnknown = {0, 6, 3, 0.4, 40};
constexpr double kMaxTorqueNewtonMetre = 0.2;

/**
 * One device of DHD. The caller's thread polls it, because DHD has no loop of its own. One thread.
 */
class ForceDimensionDevice : public Device {
 public:
  ForceDimensionDevice(Dhd& api, int number, bool hasWrist, std::shared_ptr<Trace> trace,
                       Specification specification)
      : Device(std::move(trace), std::move(specification)),
        api_(api),
        number_(static_cast<char>(number)),
        hasWrist_(hasWrist) {}

  ReadStatus read(Sample& sample) override;
  bool write(const Wrench& wrench) override;
  bool close() override;

 private:
  static constexpr int kMostFailures = 5;
  static constexpr int kReadsBetweenStatus = 50;
  static constexpr int kGoodbyes = 3;

  int readPose(double (&metre)[3], double (&rotation)[3][3]);
  void fill(const double (&metre)[3], const double (&rotation)[3][3], Sample& sample);
  void readStatus();
  ReadStatus failed(const char* call);
  bool push(const Wrench& wrench);

  Dhd& api_;
  const char number_;
  const bool hasWrist_;
  int failures_ = 0;
  int reads_ = 0;
  bool ready_ = true;
  bool gone_ = false;
};

ReadStatus ForceDimensionDevice::failed(const char* call) {
  counters().errors++;
  if (++failures_ >= kMostFailures) {
    trace().end(std::string("the device is gone: ") + call + ": " + api_.lastError() + kReplug);
    gone_ = true;
  }
  return gone_ ? ReadStatus::kDisconnected : ReadStatus::kRepeated;
}

int ForceDimensionDevice::readPose(double (&metre)[3], double (&rotation)[3][3]) {
  if (hasWrist_) {
    return traced(trace(), "dhdGetPositionAndOrientationFrame", api_.getPositionAndFrame, &metre[0],
                  &metre[1], &metre[2], &rotation[0], number_);
  }
  return traced(trace(), "dhdGetPosition", api_.getPosition, &metre[0], &metre[1], &metre[2],
                number_);
}

ReadStatus ForceDimensionDevice::read(Sample& sample) {
  if (gone_) {
    return ReadStatus::kDisconnected;
  }
  double metre[3] = {NAN, NAN, NAN};
  double rotation[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  if (reads_++ % kReadsBetweenStatus == 0) {
    readStatus();
  }
  const int answer = readPose(metre, rotation);
  if (gone_ || answer < 0) {
    return gone_ ? ReadStatus::kDisconnected : failed("reading the position");
  }
  failures_ = 0;
  if (answer == kTimeGuard) {
    return ReadStatus::kRepeated;
  }
  fill(metre, rotation, sample);
  counters().samples++;
  return ReadStatus::kFresh;
}

void ForceDimensionDevice::fill(const double (&metre)[3], const double (&rotation)[3][3],
                                Sample& sample) {
  double ours[3][3];
  for (int row = 0; row < 3; row++) {
    for (int column = 0; column < 3; column++) {
      ours[row][column] = rotation[kFromTowardsRightUp[row]][kFromTowardsRightUp[column]];
    }
  }
  toOurFrame(metre, kMmPerMetre, sample.positionMm);
  quaternionOf(ours, sample.orientation);
  sample.timeNanos = steadyNanos();
  sample.buttons = traced(trace(), "dhdGetButtonMask", api_.getButtonMask, number_);
  sample.flags = ready_ ? uint32_t{kForceReady} : 0;
}

void ForceDimensionDevice::readStatus() {
  int status[kStatusLength] = {0};
  if (traced(trace(), "dhdGetStatus", api_.getStatus, status, number_) < 0) {
    counters().errors++;
    return;
  }
  ready_ = status[kStatusPower] != 0 && status[kStatusForce] != 0;
  if (status[kStatusConnected] == 0) {
    trace().end(std::string("the device is gone: it reports that it is not connected") + kReplug);
    gone_ = true;
  }
}

bool ForceDimensionDevice::push(const Wrench& wrench) {
  double force[3];
  double torque[3];
  toTheirFrame(wrench.forceNewton, force);
  toTheirFrame(wrench.torqueNewtonMetre, torque);
  return traced(trace(), "dhdSetForceAndTorque", api_.setForceAndTorque, force[0], force[1],
                force[2], torque[0], torque[1], torque[2], number_) >= 0;
}

bool ForceDimensionDevice::write(const Wrench& wrench) {
  if (gone_) {
    return false;
  }
  if (push(wrench)) {
    return true;
  }
  failed("dhdSetForceAndTorque");
  return !gone_;
}

bool ForceDimensionDevice::close() {
  bool zeroSent = false;
  for (int i = 0; i < kGoodbyes && !zeroSent; i++) {
    zeroSent = push(Wrench());
  }
  const bool stopped = traced(trace(), "dhdStop", api_.stop, number_) >= 0;
  const std::lock_guard<std::mutex> guard(api_.lock);
  traced(trace(), "dhdClose", api_.close, number_);
  return zeroSent || stopped;
}

const Model& modelOf(int type) {
  for (const Model& model : kModels) {
    if (model.type == type) {
      return model;
    }
  }
  return kUnknown;
}

/** Requests that the device's controller sets the force to zero after 20 ms of silence. */
std::string setWatchdog(Dhd& api, Trace& trace, char number) {
  if (api.enableExpertMode != nullptr && api.setWatchdog != nullptr) {
    traced(trace, "dhdEnableExpertMode", api.enableExpertMode);
    if (traced(trace, "dhdSetWatchdog", api.setWatchdog, kWatchdogSteps, number) >= 0) {
      return "the device's own watchdog, 20 ms";
    }
  }
  return "the device's controller, which has no watchdog set: switch it off";
}

Specification specify(Dhd& api, Trace& trace, char number, bool turns) {
  const Model& model = modelOf(traced(trace, "dhdGetSystemType", api.getSystemType, number));
  unsigned short serial = 0;
  const bool hasSerial =
      traced(trace, "dhdGetSerialNumber", api.getSerialNumber, &serial, number) >= 0;
  const char* name = traced(trace, "dhdGetSystemName", api.getSystemName, number);
  Specification specification;
  specification.name = name != nullptr ? name : "Force Dimension device";
  specification.serial = hasSerial ? std::to_string(serial) : "";
  specification.watchdog = setWatchdog(api, trace, number);
  specification.maxForceNewton = model.forceNewton;
  specification.continuousForceNewton = model.continuousNewton;
  specification.maxTorqueNewtonMetre = turns ? kMaxTorqueNewtonMetre : 0;
  specification.maxStiffnessNewtonPerMm = model.stiffnessNewtonPerMm;
  specification.workspaceRadiusMm = model.radiusMm;
  return specification;
}

/** Returns a serial number of up to five digits, or -1. */
int serialOf(const std::string& id) {
  int serial = 0;
  for (const char digit : id) {
    if (digit < '0' || digit > '9' || serial > 65535) {
      return -1;
    }
    serial = 10 * serial + (digit - '0');
  }
  return id.empty() ? -1 : serial;
}

}  // namespace

Finding ForceDimensionBackend::probe(Trace& trace) {
  Dhd& api = Dhd::instance();
  Finding finding;
  finding.library = api.library;
  finding.why = api.whyNot;
  if (!finding.why.empty()) {
    return finding;
  }
  const std::lock_guard<std::mutex> guard(api.lock);
  const int count = traced(trace, "dhdGetDeviceCount", api.getDeviceCount);
  finding.usable = count > 0;
  if (count < 0) {
    finding.why = "dhdGetDeviceCount: " + api.lastError();
  } else if (count == 0) {
    finding.why = "no Force Dimension device is connected: check its cable and power";
  }
  for (int i = 0; i < count; i++) {
    // Only an opened device states its serial number, and opening takes it from another program.
    finding.devices.push_back({"", "device " + std::to_string(i + 1), true, ""});
  }
  return finding;
}

std::unique_ptr<Device> ForceDimensionBackend::open(const std::string& id,
                                                    std::shared_ptr<Trace> trace,
                                                    std::string& why) {
  Dhd& api = Dhd::instance();
  why = api.whyNot;
  if (!why.empty()) {
    return nullptr;
  }
  const int serial = serialOf(id);
  if (!id.empty() && serial < 0) {
    why = "a serial number is at most five digits, not " + id;
    return nullptr;
  }
  const std::lock_guard<std::mutex> guard(api.lock);
  const int number = id.empty() ? traced(*trace, "dhdOpen", api.open)
                                : traced(*trace, "dhdOpenSerial", api.openSerial, serial);
  if (number < 0) {
    why = std::string(id.empty() ? "dhdOpen: " : "dhdOpenSerial: ") + api.lastError() +
          ": check its cable and power, and that no other program has it";
    return nullptr;
  }
  const char device = static_cast<char>(number);
  const bool wrist = traced(*trace, "dhdHasWrist", api.hasWrist, device);
  const bool turns = traced(*trace, "dhdHasActiveWrist", api.hasActiveWrist, device);
  Specification specification = specify(api, *trace, device, turns);
  if (traced(*trace, "dhdEnableForce", api.enableForce, static_cast<unsigned char>(1), device) <
      0) {
    why = "dhdEnableForce: " + api.lastError();
    traced(*trace, "dhdClose", api.close, device);
    return nullptr;
  }
  return std::make_unique<ForceDimensionDevice>(api, number, wrist, std::move(trace),
                                                specification);
}

}  // namespace palpate::forcedimension
