#ifndef PALPATE_DEVICE_SESSION_H
#define PALPATE_DEVICE_SESSION_H

#include <cstdint>
#include <string>

#include "device/device.h"

namespace palpate {

/**
 * Open devices by handle. A handle stays safe to use for ever: after its device is closed every
 * call answers as for a device that is gone. At most kMaxOpen are open at once.
 *
 * read and write belong to one thread, the haptic one; close may come from any. No two threads are
 * ever inside a device: a close that finds the haptic thread in a vendor's call waits for it, and
 * where the call does not return, the haptic thread itself sends the zero and lets go when it does.
 */
class Session {
 public:
  static constexpr int kMaxOpen = 32;

  enum class Closed : int { kZeroSent = 0, kUnreachable = 1, kHung = 2, kAlready = 3 };

  /**
   * Opens a device on a thread of its own, so that a vendor's call that hangs cannot take this one
   * along; what opens later than that is closed again. 0 with `why` filled where it cannot.
   */
  static int64_t open(Backend& backend, const std::string& id, int64_t waitNanos, std::string& why);

  /** Looks for devices likewise. */
  static Finding probe(Backend& backend, int64_t waitNanos);

  /** Captures a device likewise; empty with `why` filled where it cannot. */
  static std::string capture(Backend& backend, const std::string& id, int64_t waitNanos,
                             std::string& why);

  static ReadStatus read(int64_t handle) noexcept;
  static bool write(int64_t handle) noexcept;
  static Closed close(int64_t handle, int64_t waitNanos) noexcept;

  /** The bytes shared with Java; they outlive the device. nullptr for a handle of nothing. */
  static Frame* frame(int64_t handle);

  static Specification specification(int64_t handle);

  /** How many threads are inside a vendor's opening, looking or closing, hanging ones too. */
  static int underWay();

  /** One line: why nothing more comes; empty while it does. */
  static std::string ending(int64_t handle);
};

}  // namespace palpate

#endif
