#ifndef PALPATE_DEVICE_CLOCK_H
#define PALPATE_DEVICE_CLOCK_H

#include <chrono>
#include <cstdint>

namespace palpate {

constexpr int64_t kNanosPerMilli = 1000000;
constexpr int64_t kNanosPerSecond = 1000000000;

/** Nanoseconds on a clock that never goes back. */
inline int64_t steadyNanos() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

}  // namespace palpate

#endif
