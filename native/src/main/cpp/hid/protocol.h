#ifndef PALPATE_HID_PROTOCOL_H
#define PALPATE_HID_PROTOCOL_H

#include <cstddef>
#include <cstdint>

#include "device/device.h"

namespace palpate::hid {

// The host side of the protocol for hand-built devices, version 1; see docs/hid-protocol.md.

constexpr uint16_t kUsagePage = 0xFF00;
constexpr uint16_t kUsage = 0x50;
constexpr size_t kInBytes = 48;
constexpr size_t kOutBytes = 24;
constexpr size_t kCapabilitiesBytes = 32;
constexpr uint8_t kInId = 1;
constexpr uint8_t kOutId = 2;
constexpr uint8_t kCapabilitiesId = 3;
constexpr uint8_t kVersion = 1;
constexpr uint8_t kFatalFault = 128;

/** An IN report, unpacked. */
struct InReport {
  uint16_t sequence = 0;
  uint16_t acknowledged = 0;
  uint32_t timeMicros = 0;
  uint8_t fault = 0;
  Sample sample;
};

/** The capabilities that a device states in feature report 3. */
struct Capabilities {
  double maxForceNewton = 0;
  double continuousForceNewton = 0;
  double maxStiffnessNewtonPerMm = 0;
  double maxTorqueNewtonMetre = 0;
  double workspaceRadiusMm = 0;
  int reportIntervalMicros = 0;
  int watchdogMillis = 0;
};

/** Unpacks a report of kInBytes, except for the time of the sample, which must be unwrapped. */
InReport unpackIn(const uint8_t* report);

/** Packs a force; `ending` means that no other one follows. */
void packOut(const Wrench& wrench, bool ending, uint16_t sequence, uint32_t echoMicros,
             uint8_t (&report)[kOutBytes]);

/** The kinds of answers to a request for feature report 3. */
enum class CapabilitiesStatus { kOk, kAnotherReport, kOlderVersion, kNewerVersion };

/** Unpacks feature report 3. `dest` is filled if the result is kOk. */
CapabilitiesStatus unpackCapabilities(const uint8_t* report, size_t length, Capabilities& dest);

}  // namespace palpate::hid

#endif
