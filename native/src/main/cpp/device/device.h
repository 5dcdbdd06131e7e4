#ifndef PALPATE_DEVICE_DEVICE_H
#define PALPATE_DEVICE_DEVICE_H

#include <atomic>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "device/frame.h"

namespace palpate {

/** What a read gave; the numbers are those of ReadStatus.java. */
enum class ReadStatus : int { kFresh = 0, kRepeated = 1, kDisconnected = 2 };

/** What a device can do, as its maker says. A force of 0: an input alone; infinity: no limit. */
struct Specification {
  std::string name;
  std::string serial;
  /** Who zeroes the force when this program no longer can, for the line that says so. */
  std::string watchdog;
  double maxForceNewton = 0;
  double continuousForceNewton = 0;
  double maxTorqueNewtonMetre = 0;
  double maxStiffnessNewtonPerMm = 0;
  double workspaceRadiusMm = 0;
  int64_t reportIntervalNanos = 0;  // 0 where every read is a sample
};

/** What other threads may see of a device: the vendor's call under way, and why it ended. */
class Trace {
 public:
  /** The vendor's function that is running now, or nullptr. Any thread. */
  const char* call() const { return call_.load(std::memory_order_relaxed); }

  void enter(const char* function) { call_.store(function, std::memory_order_relaxed); }
  void leave() { call_.store(nullptr, std::memory_order_relaxed); }

  /** Says once why nothing more will come; later reasons are dropped. Any thread. */
  void end(const std::string& why) {
    if (!claimed_.exchange(true)) {
      why_ = why;
      ended_.store(true, std::memory_order_release);
    }
  }

  /** The reason given to end, or empty. Any thread. */
  std::string why() const { return ended_.load(std::memory_order_acquire) ? why_ : std::string(); }

 private:
  std::atomic<const char*> call_{nullptr};
  std::atomic<bool> claimed_{false};
  std::atomic<bool> ended_{false};
  std::string why_;
};

/** Calls a vendor's function and leaves a mark while it runs, so that a hang can be named. */
template <typename F, typename... A>
auto traced(Trace& trace, const char* name, F function, A&&... arguments) {
  struct Mark {
    Trace& trace;
    ~Mark() { trace.leave(); }
  };
  trace.enter(name);
  const Mark mark{trace};
  return function(std::forward<A>(arguments)...);
}

/**
 * One open device. Read, written and closed by one thread at a time (Session sees to it), never
 * throws once it is open, never waits longer than the vendor's own call does.
 */
class Device {
 public:
  Device(std::shared_ptr<Trace> trace, Specification specification)
      : trace_(std::move(trace)), specification_(std::move(specification)) {}
  virtual ~Device() = default;
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  /** The newest sample; `sample` is written where the answer is kFresh, else left as it was. */
  virtual ReadStatus read(Sample& sample) = 0;

  /** Sends what is already limited; false where the device could not be reached. */
  virtual bool write(const Wrench& wrench) = 0;

  /** Zero force first, then lets go; false where the zero could not be sent. Called once. */
  virtual bool close() = 0;

  const Specification& specification() const { return specification_; }
  Trace& trace() { return *trace_; }
  void countInto(Counters* counters) { counters_ = counters; }

 protected:
  Counters& counters() { return *counters_; }
  void respecify(Specification specification) { specification_ = std::move(specification); }

 private:
  std::shared_ptr<Trace> trace_;
  Specification specification_;
  Counters discarded_;
  Counters* counters_ = &discarded_;
};

/** One device that a back end sees. */
struct FoundDevice {
  std::string id;  // what to write after the back end's name and a colon
  std::string name;
  bool usable = false;
  std::string why;  // one line: why not, and what to do
};

/** What a back end found here. */
struct Finding {
  bool usable = false;
  std::string library;
  std::string version;
  std::string why;
  std::vector<FoundDevice> devices;
};

/** A way to reach devices of one vendor. Its library is looked for at run time. */
class Backend {
 public:
  Backend() = default;
  virtual ~Backend() = default;
  Backend(const Backend&) = delete;
  Backend& operator=(const Backend&) = delete;

  virtual const char* name() const = 0;

  /** Looks without opening a device's force. */
  virtual Finding probe(Trace& trace) = 0;

  /** Opens one device: empty `id` means the first; nullptr with `why` filled where it cannot. */
  virtual std::unique_ptr<Device> open(const std::string& id, std::shared_ptr<Trace> trace,
                                       std::string& why) = 0;

  /** Captures a device, as lines of text; empty with `why` filled where it cannot. */
  virtual std::string capture(const std::string& id, Trace& trace, std::string& why) {
    (void)id;
    (void)trace;
    why = std::string("a device of ") + name() + " cannot be captured: capture one of hid";
    return "";
  }
};

/** All back ends, in the order in which they are listed. They live as long as the process. */
const std::vector<Backend*>& backends();

/** The back end of that name, or nullptr. */
Backend* backendNamed(const std::string& name);

}  // namespace palpate

#endif
