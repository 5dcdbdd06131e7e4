#ifndef PALPATE_OPENHAPTICS_HDAPI_H
#define PALPATE_OPENHAPTICS_HDAPI_H

#include <cstdint>
#include <mutex>
#include <string>

#ifdef _WIN32
#define PALPATE_HD_CALL __stdcall
#else
#define PALPATE_HD_CALL
#endif

namespace palpate::openhaptics {

// The part of HDAPI that is used here, with the vendor's constants and signatures.

using DeviceHandle = unsigned int;
using SchedulerHandle = unsigned long;
using Error = unsigned int;

struct ErrorInfo {
  Error code;
  int internalCode;
  DeviceHandle device;
};

constexpr DeviceHandle kInvalidHandle = 0xFFFFFFFF;
constexpr unsigned kCurrentButtons = 0x2000;
constexpr unsigned kSafetySwitch = 0x2001;
constexpr unsigned kCurrentTransform = 0x2052;
constexpr unsigned kVersion = 0x2500;
constexpr unsigned kModelType = 0x2501;
constexpr unsigned kSerialNumber = 0x2504;
constexpr unsigned kUsableWorkspace = 0x2551;
constexpr unsigned kOutputDof = 0x2554;
constexpr unsigned kUpdateRate = 0x2600;
constexpr unsigned kNominalMaxStiffness = 0x2602;
constexpr unsigned kNominalMaxForce = 0x2603;
constexpr unsigned kNominalContinuousForce = 0x2604;
constexpr unsigned kMotorTemperature = 0x2605;
constexpr unsigned kNominalMaxTorque = 0x2622;
constexpr unsigned kCurrentForce = 0x2700;
constexpr unsigned kCurrentTorque = 0x2701;
constexpr unsigned kForceOutput = 0x4000;
constexpr unsigned kCalibrationOk = 0x5000;
constexpr unsigned kCalibrationNeedsUpdate = 0x5001;
constexpr Error kSuccess = 0;
constexpr Error kWarmMotors = 0x200;
constexpr Error kExceededFirst = 0x201;
constexpr Error kExceededLast = 0x20F;
constexpr unsigned kCallbackDone = 0;
constexpr unsigned kCallbackContinue = 1;
constexpr unsigned short kPriority = 0x7FFF;  // the middle, after the vendor's own callbacks

using Callback = unsigned(PALPATE_HD_CALL*)(void*);

/** HDAPI, loaded at run time. There is one for the process, like its scheduler. */
struct HdApi {
  DeviceHandle(PALPATE_HD_CALL* initDevice)(const char*) = nullptr;
  void(PALPATE_HD_CALL* makeCurrentDevice)(DeviceHandle) = nullptr;
  void(PALPATE_HD_CALL* disableDevice)(DeviceHandle) = nullptr;
  void(PALPATE_HD_CALL* beginFrame)(DeviceHandle) = nullptr;
  void(PALPATE_HD_CALL* endFrame)(DeviceHandle) = nullptr;
  ErrorInfo(PALPATE_HD_CALL* getError)() = nullptr;
  const char*(PALPATE_HD_CALL* getErrorString)(Error) = nullptr;
  void(PALPATE_HD_CALL* enable)(unsigned) = nullptr;
  void(PALPATE_HD_CALL* getBooleanv)(unsigned, unsigned char*) = nullptr;
  void(PALPATE_HD_CALL* getIntegerv)(unsigned, int*) = nullptr;
  void(PALPATE_HD_CALL* getDoublev)(unsigned, double*) = nullptr;
  const char*(PALPATE_HD_CALL* getString)(unsigned) = nullptr;
  void(PALPATE_HD_CALL* setDoublev)(unsigned, const double*) = nullptr;
  unsigned(PALPATE_HD_CALL* checkCalibration)() = nullptr;
  unsigned(PALPATE_HD_CALL* checkCalibrationStyle)() = nullptr;
  void(PALPATE_HD_CALL* updateCalibration)(unsigned) = nullptr;
  void(PALPATE_HD_CALL* startScheduler)() = nullptr;
  void(PALPATE_HD_CALL* stopScheduler)() = nullptr;
  SchedulerHandle(PALPATE_HD_CALL* scheduleAsynchronous)(Callback, void*, unsigned short) = nullptr;
  void(PALPATE_HD_CALL* unschedule)(SchedulerHandle) = nullptr;

  std::string library;
  std::string whyNot;   // one line; empty if it can be used
  std::mutex lock;      // guards opening and closing
  int openDevices = 0;  // the scheduler runs while it is above 0

  static HdApi& instance();

 private:
  HdApi();
};

}  // namespace palpate::openhaptics

#endif
