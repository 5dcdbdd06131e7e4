#include "device/session.h"

#include <atomic>
#include <chrono>
#include <thread>

#include "check.h"
#include "device/clock.h"
#include "device/latest.h"

using palpate::kNanosPerMilli;
using palpate::ReadStatus;
using palpate::Session;

namespace {

/** The behaviour that a test sets for a device, and the record of its calls. */
struct Script {
  std::atomic<bool> hangs{false};
  std::atomic<bool> hangsInOpen{false};
  std::atomic<bool> isInCall{false};
  std::atomic<int> inside{0};
  std::atomic<int> overlaps{0};
  std::atomic<int> closes{0};
} script;

void vendorCall() {
  script.overlaps += script.inside++ > 0 ? 1 : 0;
  script.isInCall = true;
  while (script.hangs) {
    std::this_thread::sleep_for(std::chrono::microseconds(50));
  }
  script.isInCall = false;
  script.inside--;
}

class ScriptedDevice : public palpate::Device {
 public:
  using Device::Device;
  ReadStatus read(palpate::Sample&) override {
    palpate::traced(trace(), "vendorRead", vendorCall);
    return ReadStatus::kFresh;
  }
  bool write(const palpate::Wrench&) override {
    palpate::traced(trace(), "vendorWrite", vendorCall);
    return true;
  }
  bool close() override {
    vendorCall();
    script.closes++;
    return true;
  }
};

class ScriptedBackend : public palpate::Backend {
 public:
  const char* name() const override { return "scripted"; }
  palpate::Finding probe(palpate::Trace& trace) override {
    palpate::traced(trace, "vendorList", vendorCall);
    return palpate::Finding();
  }
  std::unique_ptr<palpate::Device> open(const std::string&, std::shared_ptr<palpate::Trace> trace,
                                        std::string&) override {
    if (script.hangsInOpen) {
      palpate::traced(*trace, "vendorOpen", [] {
        while (script.hangsInOpen) {
          std::this_thread::sleep_for(std::chrono::microseconds(50));
        }
      });
    }
    palpate::Specification specification;
    specification.watchdog = "its own watchdog, 20 ms";
    return std::make_unique<ScriptedDevice>(std::move(trace), specification);
  }
} backend;

int64_t openOne() {
  std::string why;
  const int64_t handle = Session::open(backend, "", 1000 * kNanosPerMilli, why);
  CHECK_THAT(handle != 0, why);
  return handle;
}

void waitFor(const std::atomic<int>& counter, int value) {
  while (counter < value) {
    std::this_thread::sleep_for(std::chrono::microseconds(50));
  }
}

}  // namespace

TEST("a hang in a frame's call is named, and the device is let go by the thread that returns") {
  const int closes = script.closes;
  const int64_t handle = openOne();
  script.hangs = true;
  std::thread haptic([handle] { Session::read(handle); });
  while (!script.isInCall) {
    std::this_thread::yield();
  }
  CHECK(Session::close(handle, 20 * kNanosPerMilli) == Session::Closed::kHung);
  CHECK_EQUAL(
      std::string("vendorRead does not return: the force is left to its own watchdog, 20 ms"),
      Session::ending(handle));
  CHECK_EQUAL(closes, script.closes.load());
  script.hangs = false;
  haptic.join();
  CHECK_EQUAL(closes + 1, script.closes.load());
  CHECK(Session::read(handle) == ReadStatus::kDisconnected);
  CHECK_EQUAL(0, script.overlaps.load());
}

TEST("closing from other threads never meets the haptic thread inside") {
  for (int round = 0; round < 50; round++) {
    const int64_t handle = openOne();
    const int closes = script.closes;
    std::thread haptic([handle] {
      while (Session::read(handle) == ReadStatus::kFresh) {
        Session::write(handle);
      }
    });
    std::thread other([handle] { Session::close(handle, 1000 * kNanosPerMilli); });
    Session::close(handle, 1000 * kNanosPerMilli);
    other.join();
    haptic.join();
    CHECK_EQUAL(closes + 1, script.closes.load());
  }
  CHECK_EQUAL(0, script.overlaps.load());
}

TEST("an opening that hangs gives up with the call's name, and what opens later is closed") {
  const int closes = script.closes;
  std::string why;
  script.hangsInOpen = true;
  CHECK_EQUAL(int64_t{0}, Session::open(backend, "", 10 * kNanosPerMilli, why));
  CHECK_EQUAL(std::string("vendorOpen did not answer within 10 ms: switch the device off and on"),
              why);
  script.hangsInOpen = false;
  waitFor(script.closes, closes + 1);
}

TEST("a look that hangs gives up with the call's name") {
  script.hangs = true;
  const palpate::Finding finding = Session::probe(backend, 10 * kNanosPerMilli);
  CHECK(!finding.usable);
  CHECK_EQUAL(std::string("vendorList did not answer within 10 ms: switch the device off and on"),
              finding.why);
  script.hangs = false;
  while (script.inside != 0) {
    std::this_thread::yield();
  }
}

TEST("handles that were never given out are gone devices") {
  for (const int64_t handle : {int64_t{0}, int64_t{1}, int64_t{-1}, int64_t{1} << 60}) {
    CHECK(Session::read(handle) == ReadStatus::kDisconnected);
    CHECK(!Session::write(handle));
    CHECK(Session::frame(handle) == nullptr);
    CHECK(Session::close(handle, 0) == Session::Closed::kAlready);
  }
}

TEST("as many as allowed can be open, one more cannot, and all can again after") {
  for (int round = 0; round < 3; round++) {
    std::vector<int64_t> handles;
    for (int i = 0; i < Session::kMaxOpen; i++) {
      handles.push_back(openOne());
    }
    std::string why;
    CHECK_EQUAL(int64_t{0}, Session::open(backend, "", 1000 * kNanosPerMilli, why));
    CHECK_EQUAL(std::string("32 devices are open already: close one"), why);
    for (const int64_t handle : handles) {
      Session::close(handle, 1000 * kNanosPerMilli);
    }
  }
}

TEST("the newest value crosses whole between two threads that never wait") {
  struct Pair {
    int64_t a = 0;
    int64_t b = 0;
  };
  constexpr int64_t kLast = 200000;
  palpate::Latest<Pair> latest;
  std::thread writer([&latest] {
    for (int64_t i = 1; i <= kLast; i++) {
      latest.publish({i, -i});
    }
  });
  Pair seen;
  int64_t before = 0;
  while (before < kLast) {
    if (latest.take(seen)) {
      CHECK(seen.a == -seen.b && seen.a > before);
      before = seen.a;
    }
  }
  writer.join();
  CHECK(!latest.take(seen));
}
