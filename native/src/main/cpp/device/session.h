#ifndef PALPATE_DEVICE_SESSION_H
#define PALPATE_DEVICE_SESSION_H

#include <cstdint>
#include <string>

#include "device/device.h"

namespace palpate {

/**
 * Open devices by handle. A handle never becomes invalid: after its device is closed, every call
 * reports that the device is gone. At most kMaxOpen devices are open at once.
 *
 * The haptic thread alone calls read and write; any thread may call close. Two threads are never
 * inside a device at once. If the haptic thread is in a vendor's call, close waits for it for a
 * limited time. If the call has not returned by then, the haptic thread itself sends zero force and
 * releases the device once it returns.
 */
class Session {
 public:
  static constexpr int kMaxOpen = 32;

  enum class Closed : int { kZeroSent = 0, kUnreachable = 1, kHung = 2, kAlready = 3 };

  /**
   * Opens a device on a helper thread, so that a vendor's call that hangs does not block the
   * caller. A device that opens too late is closed again. Returns 0 and fills `why` if the device
   * cannot be opened.
   */
  static int64_t open(Backend& backend, const std::string& id, int64_t waitNanos, std::string& why);

  /** Searches for devices, on a helper thread as well. */
  static Finding probe(Backend& backend, int64_t waitNanos);

  /**
   * Captures a device, on a helper thread as well. Returns an empty text and fills `why` if that
   * fails.
   */
  static std::string capture(Backend& backend, const std::string& id, int64_t waitNanos,
                             std::string& why);

  static ReadStatus read(int64_t handle) noexcept;
  static bool write(int64_t handle) noexcept;
  static Closed close(int64_t handle, int64_t waitNanos) noexcept;

  /**
   * Returns the bytes that are shared with Java, which outlive the device; nullptr if the handle
   * never belonged to a device.
   */
  static Frame* frame(int64_t handle);

  static Specification specification(int64_t handle);

  /**
   * Returns the number of threads in a vendor's open, probe or close call, hanging ones included.
   */
  static int underWay();

  /** Returns one line with the reason why the device is gone; empty while it works. */
  static std::string ending(int64_t handle);
};

}  // namespace palpate

#endif
