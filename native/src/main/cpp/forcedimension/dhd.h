#ifndef PALPATE_FORCEDIMENSION_DHD_H
#define PALPATE_FORCEDIMENSION_DHD_H

#include <mutex>
#include <string>

#ifdef _WIN32
#define PALPATE_DHD_CALL __stdcall
#else
#define PALPATE_DHD_CALL
#endif

namespace palpate::forcedimension {

// The part of Force Dimension's DHD that is used here, with the vendor's constants and signatures.
// Every function takes the device's number, whose default value exists in the vendor's header
// alone.

constexpr int kTimeGuard = 1;  // called too early: the previous value; not an error
constexpr int kStatusLength = 17;
constexpr int kStatusPower = 0;
constexpr int kStatusConnected = 1;
constexpr int kStatusForce = 5;
constexpr unsigned char kWatchdogSteps = 160;  // of 125 us each: 20 ms

struct Dhd {
  int(PALPATE_DHD_CALL* getDeviceCount)() = nullptr;
  int(PALPATE_DHD_CALL* open)() = nullptr;
  int(PALPATE_DHD_CALL* openSerial)(int) = nullptr;
  int(PALPATE_DHD_CALL* close)(char) = nullptr;
  int(PALPATE_DHD_CALL* stop)(char) = nullptr;
  int(PALPATE_DHD_CALL* enableForce)(unsigned char, char) = nullptr;
  int(PALPATE_DHD_CALL* getSystemType)(char) = nullptr;
  const char*(PALPATE_DHD_CALL* getSystemName)(char) = nullptr;
  int(PALPATE_DHD_CALL* getSerialNumber)(unsigned short*, char) = nullptr;
  int(PALPATE_DHD_CALL* getPosition)(double*, double*, double*, char) = nullptr;
  int(PALPATE_DHD_CALL* getPositionAndFrame)(double*, double*, double*, double (*)[3],
                                             char) = nullptr;
  unsigned(PALPATE_DHD_CALL* getButtonMask)(char) = nullptr;
  int(PALPATE_DHD_CALL* setForceAndTorque)(double, double, double, double, double, double,
                                           char) = nullptr;
  int(PALPATE_DHD_CALL* getStatus)(int*, char) = nullptr;
  bool(PALPATE_DHD_CALL* hasWrist)(char) = nullptr;
  bool(PALPATE_DHD_CALL* hasActiveWrist)(char) = nullptr;
  const char*(PALPATE_DHD_CALL* errorGetLastStr)() = nullptr;
  void(PALPATE_DHD_CALL* enableExpertMode)() = nullptr;               // may be missing
  int(PALPATE_DHD_CALL* setWatchdog)(unsigned char, char) = nullptr;  // may be missing

  std::string library;
  std::string whyNot;  // one line; empty if it can be used
  std::mutex lock;     // guards opening and closing

  static Dhd& instance();

  /** Returns the last error of this thread as text. */
  std::string lastError() const;

 private:
  Dhd();
};

}  // namespace palpate::forcedimension

#endif
