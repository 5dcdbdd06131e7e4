// Every call of every back end fails in every way: at opening, in a frame and at closing. Each time
// the session either goes on or ends with one line. It sends zero force if the device can still be
// reached, and two threads are never inside the vendor's library at once.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "bench.h"
#include "check.h"
#include "device/clock.h"
#include "fake_device.h"

using palpate::ReadStatus;
using palpate::Session;
using substitutes::Fault;
using substitutes::Panel;

namespace {

enum class When { kOpening, kRunning, kClosing };

constexpr Fault kFaults[] = {Fault::kErrorOnce,  Fault::kError,     Fault::kTimeOut,
                             Fault::kNotANumber, Fault::kUnplugged, Fault::kHang};
constexpr const char* kFaultNames[] = {"none",         "error once", "error", "time-out",
                                       "not a number", "unplugged",  "hang"};
constexpr int64_t kShort = 30 * palpate::kNanosPerMilli;
constexpr int64_t kLong = 5 * palpate::kNanosPerSecond;

int injected = 0;
int survived = 0;

void arm(Panel& panel, const std::string& call, Fault fault) {
  std::strncpy(panel.faultCall, call.c_str(), sizeof panel.faultCall - 1);
  panel.fault = fault;
}

/** One back end; for hid, with a fake device that sends reports by itself. */
class Subject {
 public:
  explicit Subject(const char* backend) : backend_(backend) {
    if (std::string(backend) == "hid") {
      fake_ = std::make_unique<FakeDevice>(bench::fakeFolder(), "SN0001");
      pump_ = std::thread([this] { pump(); });
    }
  }
  ~Subject() {
    ending_ = true;
    if (pump_.joinable()) {
      pump_.join();
    }
  }

  const char* backend() const { return backend_; }

  /** Returns the largest component of the force that the motors exert now. */
  double felt(Panel& panel) {
    if (fake_) {
      // The clock of the fake device runs on. After 20 ms its watchdog has set the force to zero.
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      return felt_.load();
    }
    return std::fabs(panel.force[0]) + std::fabs(panel.force[1]) + std::fabs(panel.force[2]);
  }

 private:
  void pump() {
    while (!ending_) {
      const auto micros = static_cast<uint32_t>(palpate::steadyNanos() / 1000);
      fake_->receive(micros);
      fake_->step(micros);
      felt_ = std::abs(fake_->motors(micros).force_mn[0]) / 1000.0;
      std::this_thread::sleep_for(std::chrono::microseconds(100));
    }
  }

  const char* backend_;
  std::unique_ptr<FakeDevice> fake_;
  std::thread pump_;
  std::atomic<bool> ending_{false};
  std::atomic<double> felt_{0};
};

/** Returns the names of the functions that were called since the panel was reset. */
std::vector<std::string> called(Panel& panel) {
  std::vector<std::string> names;
  for (int i = 0; i < panel.calledCount; i++) {
    names.emplace_back(panel.called[i].name);
  }
  return names;
}

void forget(Panel& panel) {
  std::memset(static_cast<void*>(panel.called), 0, sizeof panel.called);
  panel.calledCount = 0;
}

/**
 * Runs a frame and returns whether the device is still there. Frames go on while a haptic thread
 * hangs elsewhere.
 */
bool frame(int64_t handle) {
  bench::advanceMillis(5);
  ReadStatus status = ReadStatus::kRepeated;
  for (int i = 0; i < 20 && status == ReadStatus::kRepeated; i++) {
    status = Session::read(handle);
    if (status == ReadStatus::kRepeated) {
      std::this_thread::sleep_for(std::chrono::microseconds(100));
    }
  }
  bench::push(handle, 1, 0, 0);
  return status != ReadStatus::kDisconnected;
}

void settle(int64_t handle) {
  for (int i = 0; i < 180; i++) {
    frame(handle);
  }
}

/** Waits until the calls that hung and were released have returned. */
void waitUntilQuiet() {
  while (Session::underWay() > 0) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

void waitUntilClosed(int64_t handle) {
  while (Session::close(handle, kShort) == Session::Closed::kHung) {
  }
  waitUntilQuiet();
}

struct Case {
  Subject& subject;
  Panel& panel;
  std::string where;
};

/** Checks what must hold after every fault. */
void checkAftermath(Case& one, bool reachable) {
  for (int i = 0; i < 100 && one.subject.felt(one.panel) != 0; i++) {
    bench::advanceMillis(5);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  const bool zero = one.subject.felt(one.panel) == 0;
  CHECK_THAT(zero || !reachable, one.where + ": the force stays on");
  CHECK_THAT(one.panel.overlaps == 0, one.where + ": two threads in the library");
  const double largest = one.panel.largest.load();
  CHECK_THAT(largest <= 1 + 1e-6,
             one.where + ": more force than asked for: " + std::to_string(largest));
  injected++;
  survived += (zero || !reachable) && one.panel.overlaps == 0 ? 1 : 0;
}

void failOpening(Case one, const std::string& call, Fault fault) {
  arm(one.panel, call, fault);
  std::string why;
  const int64_t handle = Session::open(*palpate::backendNamed(one.subject.backend()), "",
                                       fault == Fault::kHang ? kShort : kLong, why);
  CHECK_THAT(handle != 0 || (!why.empty() && why.find('\n') == std::string::npos),
             one.where + ": no line says why");
  if (handle != 0) {
    frame(handle);
    Session::close(handle, kLong);
  }
  one.panel.released = 1;
  waitUntilQuiet();
  checkAftermath(one, true);
}

/** Runs frames on a thread of their own, like the haptic thread. Ends when the device is gone. */
void runFrames(int64_t handle, int frames, std::atomic<int>& done) {
  for (int i = 0; i < frames && frame(handle); i++) {
    done++;
  }
  done = frames;
}

void failRunning(Case one, const std::string& call, Fault fault) {
  constexpr int kFrames = 150;
  const int64_t handle = bench::open(one.subject.backend(), "");
  settle(handle);
  arm(one.panel, call, fault);
  std::atomic<int> done{0};
  std::thread haptic([&] { runFrames(handle, kFrames, done); });
  const palpate::Deadline deadline(kLong);
  int before = -1;
  while (done < kFrames && !deadline.isOver()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(fault == Fault::kHang ? 40 : 1));
    if (fault == Fault::kHang && done == before) {
      break;  // it hangs: no progress for 40 ms
    }
    before = done;
  }
  const bool hangs = done < kFrames;
  const bool gone = !hangs && Session::read(handle) == ReadStatus::kDisconnected;
  CHECK_THAT(!gone || !Session::ending(handle).empty(), one.where + ": no line says why");
  CHECK_THAT(fault != Fault::kErrorOnce || !gone, one.where + ": one error ended the session");
  const Session::Closed closed = Session::close(handle, hangs ? kShort : kLong);
  CHECK_THAT(closed != Session::Closed::kHung || !Session::ending(handle).empty(),
             one.where + ": no line names the hang");
  one.panel.released = 1;
  haptic.join();
  waitUntilClosed(handle);
  const bool reachable = one.panel.unplugged == 0 && closed != Session::Closed::kUnreachable;
  checkAftermath(one, reachable);
}

void failClosing(Case one, const std::string& call, Fault fault) {
  const int64_t handle = bench::open(one.subject.backend(), "");
  settle(handle);
  arm(one.panel, call, fault);
  const Session::Closed closed = Session::close(handle, fault == Fault::kHang ? kShort : kLong);
  CHECK_THAT(closed != Session::Closed::kHung || !Session::ending(handle).empty(),
             one.where + ": no line names the hang");
  one.panel.released = 1;
  waitUntilClosed(handle);
  checkAftermath(one, one.panel.unplugged == 0 && closed != Session::Closed::kUnreachable);
}

void failEvery(Subject& subject, When when, const std::vector<std::string>& calls) {
  constexpr const char* kWhens[] = {"opening", "running", "closing"};
  for (const std::string& call : calls) {
    for (const Fault fault : kFaults) {
      Panel& panel = bench::freshPanel();
      const std::string where = std::string(subject.backend()) + ", " +
                                kWhens[static_cast<int>(when)] + ", " + call + ", " +
                                kFaultNames[fault];
      const Case one{subject, panel, where};
      if (std::getenv("PALPATE_VERBOSE") != nullptr) {
        std::fprintf(stderr, "%s\n", where.c_str());
      }
      when == When::kOpening   ? failOpening(one, call, fault)
      : when == When::kRunning ? failRunning(one, call, fault)
                               : failClosing(one, call, fault);
    }
  }
}

/**
 * Runs a session without faults to record the functions that it calls, then makes each one fail.
 */
void failAll(const char* backend) {
  Subject subject(backend);
  Panel& panel = bench::freshPanel();
  const int64_t handle = bench::open(backend, "");
  const std::vector<std::string> opening = called(panel);
  forget(panel);
  settle(handle);
  const std::vector<std::string> running = called(panel);
  CHECK_THAT(subject.felt(panel) > 0.99, std::string(backend) + ": the force is not on");
  forget(panel);
  Session::close(handle, kLong);
  const std::vector<std::string> closing = called(panel);
  const int before = injected;
  const int beforeSurvived = survived;
  failEvery(subject, When::kOpening, opening);
  failEvery(subject, When::kRunning, running);
  failEvery(subject, When::kClosing, closing);
  std::printf("native: %s: %zu + %zu + %zu calls, %d faults injected, %d survived\n", backend,
              opening.size(), running.size(), closing.size(), injected - before,
              survived - beforeSurvived);
}

}  // namespace

TEST("hid survives every fault at every call") { failAll("hid"); }
TEST("openhaptics survives every fault at every call") { failAll("openhaptics"); }
TEST("forcedimension survives every fault at every call") { failAll("forcedimension"); }
TEST("virtuose survives every fault at every call") { failAll("virtuose"); }
