#ifndef PALPATE_DEVICE_CLOCK_H
#define PALPATE_DEVICE_CLOCK_H

#include <atomic>
#include <chrono>
#include <cstdint>

namespace palpate {

constexpr int64_t kNanosPerMilli = 1000000;
constexpr int64_t kNanosPerSecond = 1000000000;

/** The time that a test sets; steadyNanos returns it unless it is 0. */
inline std::atomic<int64_t> heldNanos{0};

/** Returns nanoseconds on a clock that never goes back. A test can set the time. */
inline int64_t steadyNanos() {
  const int64_t held = heldNanos.load(std::memory_order_relaxed);
  return held != 0 ? held
                   : std::chrono::duration_cast<std::chrono::nanoseconds>(
                         std::chrono::steady_clock::now().time_since_epoch())
                         .count();
}

/** The end of a wait for another thread, in real time. */
class Deadline {
 public:
  explicit Deadline(int64_t waitNanos)
      : until_(std::chrono::steady_clock::now() + std::chrono::nanoseconds(waitNanos)) {}

  bool isOver() const { return std::chrono::steady_clock::now() >= until_; }

 private:
  std::chrono::steady_clock::time_point until_;
};

}  // namespace palpate

#endif
