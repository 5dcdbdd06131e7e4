#include "hand.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>

namespace {

constexpr long kNanosPerMilli = 1000000;
constexpr double kTurn = 6.283185307179586;

}  // namespace

void moveHand(palpate_pose& pose, double seconds) {
  const double moving = seconds > 1 ? seconds - 1 : 0;
  pose.position_um[0] = static_cast<int32_t>(std::lround(8000 * std::sin(kTurn * moving / 7)));
  pose.position_um[1] = static_cast<int32_t>(std::lround(8000 * std::sin(kTurn * moving / 11)));
  pose.position_um[2] =
      static_cast<int32_t>(std::lround(60000 - 30000 * (1 - std::cos(kTurn * moving / 4))));
}

void Felt::note(const palpate_motors& motors, int reports) {
  int largest = 0;
  for (const int16_t component : motors.force_mn) {
    largest = std::max(largest, std::abs(int{component}));
  }
  intervals_++;
  reports_ += reports;
  silent_ += reports == 0 ? 1 : 0;
  pushing_ += largest > 0 ? 1 : 0;
  largestMn_ = std::max(largestMn_, largest);
}

void Felt::say(const char* name, const palpate_device& firmware, const palpate_motors& last) const {
  const int rest = std::abs(int{last.force_mn[0]}) + std::abs(int{last.force_mn[1]}) +
                   std::abs(int{last.force_mn[2]});
  std::fprintf(stderr,
               "%s: %ld intervals, %ld forces, %ld intervals without one, %ld with a push, largest "
               "%d mN, watchdog tripped %d times, %d mN at the end\n",
               name, intervals_, reports_, silent_, pushing_, largestMn_,
               int{firmware.watchdog_trips}, rest);
}

long nowNanos() {
  timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return now.tv_sec * 1000 * kNanosPerMilli + now.tv_nsec;
}

long nextMillisecond(long startNanos) {
  const long millisecond = (nowNanos() - startNanos) / kNanosPerMilli + 1;
  const long at = startNanos + millisecond * kNanosPerMilli;
  const timespec until = {at / (1000 * kNanosPerMilli), at % (1000 * kNanosPerMilli)};
  clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr);
  return millisecond;
}
