#ifndef PALPATE_VIRTUAL_DEVICE_H
#define PALPATE_VIRTUAL_DEVICE_H

#include "hand.h"
#include "palpate_device.h"

/**
 * A hand-built device that another program finds: the example firmware, and a hand that moves it at
 * 1 kHz. The firmware's clock advances by a millisecond with each report: while a busy machine
 * keeps this process waiting it stands still, and no watchdog trips. Subclasses connect the device
 * to the host's side of HID. One thread.
 */
class VirtualDevice {
 public:
  static constexpr const char* kName = "Virtual hand-built device";
  static constexpr const char* kSerial = "SN0001";
  static constexpr unsigned kVendor = 0x1209;
  static constexpr unsigned kProduct = 0x4A01;
  static constexpr int kFailed = 125;

  VirtualDevice();
  virtual ~VirtualDevice() = default;
  VirtualDevice(const VirtualDevice&) = delete;
  VirtualDevice& operator=(const VirtualDevice&) = delete;

  /**
   * Runs a command and moves the hand until it ends. Prints the statistics of the forces under
   * `name`, and returns the command's exit code.
   */
  int serve(const char* name, char** command);

 protected:
  palpate_device firmware_;

 private:
  /** Takes the reports that the host has sent, and returns the number of forces. */
  virtual int receive(uint32_t micros) = 0;

  /** Sends a report if there is room for it. */
  virtual void send(const uint8_t (&report)[PALPATE_IN_BYTES]) = 0;
};

#endif
