// A virtual wall in real time. A fake device runs on a thread of its own at 1 kHz, and the host on
// another.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <set>
#include <thread>
#include <vector>

#include "bench.h"
#include "check.h"
#include "device/clock.h"
#include "fake_device.h"
#include "hand.h"
#include "hid/bytes.h"

using palpate::ReadStatus;
using palpate::Session;

namespace {

constexpr double kStiffness = 0.6;  // N/mm, below the governor's slew rate for this hand
constexpr long kStillMillis = 1200;
constexpr int64_t kLongGapNanos = 15 * palpate::kNanosPerMilli;
constexpr int64_t kRecoveryNanos =
    200 * palpate::kNanosPerMilli;  // the governor needs less to return the force

/**
 * Returns the position of the hand at a millisecond: at rest until the force is permitted, then to
 * and fro.
 */
int32_t handMicrometre(long millis) {
  const long moving = std::max(0L, millis - kStillMillis);
  return static_cast<int32_t>(std::lround(3000 * std::sin(static_cast<double>(moving) * 0.006)));
}

double wallNewton(double handMm) { return -kStiffness * std::max(0.0, handMm); }

/** A force that the device received, and the sample that the host computed it from. */
struct Answer {
  int64_t sampleMicros;
  double newton;
};

/** The device's side: sends samples and records forces. */
class Wall {
 public:
  explicit Wall(long millis) : millis_(millis) {
    device_.heard = [this](const uint8_t* report) {
      answers_.push_back(
          {palpate::hid::uint32At(report + 20), palpate::hid::int16At(report + 4) / 1000.0});
    };
  }

  FakeDevice& device() { return device_; }
  /**
   * Returns the number of reports for which there was room; a host that is delayed for long leaves
   * none.
   */
  int64_t sent() const { return made_ - device_.withoutRoom(); }
  const std::vector<Answer>& answers() const { return answers_; }

  void run() {
    const long start = nowNanos();
    for (long millis = 0; millis < millis_;) {
      millis = nextMillisecond(start);
      const auto micros = static_cast<uint32_t>(millis * 1000);
      device_.receive(micros);
      device_.pose.position_um[0] = handMicrometre(millis);
      device_.step(micros);
      made_++;
    }
    // The last report must arrive, so that a gap before it is noticed.
    do {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      made_++;
    } while (!device_.step(static_cast<uint32_t>(millis_ * 1000)));
  }

  void receiveRest() { device_.receive(static_cast<uint32_t>(millis_ * 1000)); }

 private:
  const long millis_;
  FakeDevice device_{bench::fakeFolder(), "WALL1"};
  int64_t made_ = 0;
  std::vector<Answer> answers_;
};

long secondsAsked() {
  const char* text = std::getenv("PALPATE_REALTIME_SECONDS");
  return text != nullptr && std::atol(text) > 0 ? std::atol(text) : 3;
}

/** The host's side. */
struct Host {
  explicit Host(int64_t opened) : handle(opened) {}

  const int64_t handle;
  std::atomic<bool> ending{false};
  std::atomic<int64_t> samples{0};
  int64_t written = 0;
  /** Samples that were answered while the force was returning, after this thread was delayed. */
  std::set<int64_t> recoveringMicros;

  void run() {
    int64_t beforeNanos = 0;
    int64_t recoveredNanos = 0;
    while (!ending) {
      if (Session::read(handle) != ReadStatus::kFresh) {
        std::this_thread::sleep_for(std::chrono::microseconds(50));
        continue;
      }
      const palpate::Sample& sample = Session::frame(handle)->sample;
      written += bench::push(handle, wallNewton(sample.positionMm[0]), 0, 0) ? 1 : 0;
      const int64_t now = palpate::steadyNanos();
      recoveredNanos = now - beforeNanos > kLongGapNanos ? now + kRecoveryNanos : recoveredNanos;
      if (now < recoveredNanos) {
        recoveringMicros.insert(sample.timeNanos / 1000);
      }
      beforeNanos = now;
      samples = Session::frame(handle)->counters.samples;
    }
  }
};

/**
 * Compares each force with its sample, and returns the number of forces that were still returning.
 */
int64_t checkAll(const Wall& wall, const Host& host) {
  int64_t recovering = 0;
  for (const Answer& answer : wall.answers()) {
    const int32_t hand = handMicrometre(static_cast<long>(answer.sampleMicros / 1000));
    const double right = wallNewton(hand / 1000.0);
    if (host.recoveringMicros.count(answer.sampleMicros) > 0) {
      recovering++;
      CHECK(answer.newton <= 0.0005 && answer.newton >= right - 0.0005 - 1e-9);
    } else {
      CHECK_NEAR(right, answer.newton, 0.0005 + 1e-9);
    }
  }
  return recovering;
}

}  // namespace

TEST("a virtual wall in real time: every force is its own sample's and none is lost") {
  bench::freshPanel();
  palpate::heldNanos = 0;  // the real clock
  {
    Wall wall(secondsAsked() * 1000);
    Host host{bench::open("hid", "WALL1")};
    while (!wall.device().isOpen()) {
      std::this_thread::yield();
    }
    std::thread haptic([&host] { host.run(); });
    wall.run();
    const palpate::Deadline deadline(10 * palpate::kNanosPerSecond);
    while (host.samples < wall.sent() && !deadline.isOver()) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    host.ending = true;
    haptic.join();
    wall.receiveRest();
    const palpate::Counters counters = Session::frame(host.handle)->counters;
    CHECK_EQUAL(wall.sent(), counters.samples);
    CHECK_EQUAL(wall.device().withoutRoom(), counters.lost);
    CHECK_EQUAL(int64_t{0},
                counters.duplicated + counters.outOfOrder + counters.wrongLength + counters.errors);
    CHECK_EQUAL(counters.samples - counters.merged, host.written);
    CHECK_EQUAL(host.written, static_cast<int64_t>(wall.answers().size()));
    const int64_t recovering = checkAll(wall, host);
    std::printf(
        "native: a wall in real time: %ld s, %lld samples, %lld forces, each its sample's;"
        " %lld samples merged, %lld late, %lld without room, %lld forces on their way back\n",
        secondsAsked(), static_cast<long long>(counters.samples),
        static_cast<long long>(host.written), static_cast<long long>(counters.merged),
        static_cast<long long>(counters.late), static_cast<long long>(counters.lost),
        static_cast<long long>(recovering));
    Session::close(host.handle, palpate::kNanosPerSecond);
  }
  palpate::heldNanos = palpate::steadyNanos();  // the tests' own clock again
}
