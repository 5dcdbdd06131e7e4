#ifndef PALPATE_VIRTUOSE_VIRTUOSE_API_H
#define PALPATE_VIRTUOSE_VIRTUOSE_API_H

#include <mutex>
#include <string>

namespace palpate::virtuose {

// The part of Haption's Virtuose API 4 that is used here, with the vendor's constants and
// signatures. Every function returns 0 for success and takes floats. A context belongs to one
// thread.

using Context = void*;

constexpr int kImpedance = 3;
constexpr int kIndexingAll = 0;
constexpr unsigned kAlarmOverheat = 0x4000;

struct VirtuoseApi {
  Context (*open)(const char*) = nullptr;
  int (*close)(Context) = nullptr;
  int (*getErrorCode)(Context) = nullptr;
  char* (*getErrorMessage)(int) = nullptr;
  int (*apiVersion)(int*, int*) = nullptr;
  int (*setIndexingMode)(Context, int) = nullptr;
  int (*setForceFactor)(Context, float) = nullptr;
  int (*setSpeedFactor)(Context, float) = nullptr;
  int (*setTimeStep)(Context, float) = nullptr;
  int (*setTimeoutValue)(Context, float) = nullptr;
  int (*setBaseFrame)(Context, float*) = nullptr;
  int (*setObservationFrame)(Context, float*) = nullptr;
  int (*setCommandType)(Context, int) = nullptr;
  int (*saturateTorque)(Context, float, float) = nullptr;
  int (*setPowerOn)(Context, int) = nullptr;
  int (*getPosition)(Context, float*) = nullptr;
  int (*setForce)(Context, float*) = nullptr;
  int (*getButton)(Context, int, int*) = nullptr;
  int (*getDeadMan)(Context, int*) = nullptr;
  int (*getEmergencyStop)(Context, int*) = nullptr;
  int (*getPowerOn)(Context, int*) = nullptr;
  int (*getAlarm)(Context, unsigned*) = nullptr;

  std::string library;
  std::string whyNot;  // one line; empty if it can be used
  std::mutex lock;     // guards opening and closing

  static VirtuoseApi& instance();

  /** Returns the last error of a context as text; with nullptr, that of opening. */
  std::string lastError(Context context) const;

 private:
  VirtuoseApi();
};

}  // namespace palpate::virtuose

#endif
