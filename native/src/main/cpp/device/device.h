#ifndef PALPATE_DEVICE_DEVICE_H
#define PALPATE_DEVICE_DEVICE_H

#include <atomic>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "device/frame.h"

namespace palpate {

/** The result of a read. The numbers are those of ReadStatus.java. */
enum class ReadStatus : int { kFresh = 0, kRepeated = 1, kDisconnected = 2 };

/**
 * The capabilities of a device, as its maker states them. A maximum force of 0 means an input
 * device, infinity means no limit.
 */
struct Specification {
  std::string name;
  std::string serial;
  /** The name of what sets the force to zero if this program no longer can, for messages. */
  std::string watchdog;
  double maxForceNewton = 0;
  double continuousForceNewton = 0;
  double maxTorqueNewtonMetre = 0;
  double maxStiffnessNewtonPerMm = 0;
  double workspaceRadiusMm = 0;
  int64_t reportIntervalNanos = 0;  // 0 if every read is a sample
};

/** The state of a device for other threads: the vendor's call in progress, and why it ended. */
class Trace {
 public:
  /** Returns the vendor's function that is running now, or nullptr. Any thread. */
  const char* call() const { return call_.load(std::memory_order_relaxed); }

  void enter(const char* function) { call_.store(function, std::memory_order_relaxed); }
  void leave() { call_.store(nullptr, std::memory_order_relaxed); }

  /** Stores the reason why the device has ended. Later reasons are dropped. Any thread. */
  void end(const std::string& why) {
    if (!claimed_.exchange(true)) {
      why_ = why;
      ended_.store(true, std::memory_order_release);
    }
  }

  /** Returns the reason that was given to end(), or an empty text. Any thread. */
  std::string why() const { return ended_.load(std::memory_order_acquire) ? why_ : std::string(); }

 private:
  std::atomic<const char*> call_{nullptr};
  std::atomic<bool> claimed_{false};
  std::atomic<bool> ended_{false};
  std::string why_;
};

/** Calls a vendor's function and records its name while it runs, so that a hang can be reported. */
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
 * One open device. Session ensures that one thread at a time reads, writes or closes it. Once it is
 * open, it never throws, and it never waits longer than the vendor's own call.
 */
class Device {
 public:
  Device(std::shared_ptr<Trace> trace, Specification specification)
      : trace_(std::move(trace)), specification_(std::move(specification)) {}
  virtual ~Device() = default;
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  /** Reads the newest sample. `sample` is written only if the result is kFresh. */
  virtual ReadStatus read(Sample& sample) = 0;

  /** Sends a wrench that is already limited. Returns false if the device could not be reached. */
  virtual bool write(const Wrench& wrench) = 0;

  /**
   * Sends zero force, then releases the device. Returns false if the zero could not be sent. Called
   * once.
   */
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
  std::string id;  // the text to write after the back end's name and a colon
  std::string name;
  bool usable = false;
  std::string why;  // one line: the reason if it is not usable, and the remedy
};

/** The result of a back end's search for devices on this machine. */
struct Finding {
  bool usable = false;
  std::string library;
  std::string version;
  std::string why;
  std::vector<FoundDevice> devices;
};

/** A back end: it opens the devices of one vendor, whose library it loads at run time. */
class Backend {
 public:
  Backend() = default;
  virtual ~Backend() = default;
  Backend(const Backend&) = delete;
  Backend& operator=(const Backend&) = delete;

  virtual const char* name() const = 0;

  /** Lists the devices without enabling the force of any. */
  virtual Finding probe(Trace& trace) = 0;

  /**
   * Opens one device; an empty `id` means the first. Returns nullptr and fills `why` if that fails.
   */
  virtual std::unique_ptr<Device> open(const std::string& id, std::shared_ptr<Trace> trace,
                                       std::string& why) = 0;

  /** Captures a device as lines of text. Returns an empty text and fills `why` if that fails. */
  virtual std::string capture(const std::string& id, Trace& trace, std::string& why) {
    (void)id;
    (void)trace;
    why = std::string("a device of ") + name() + " cannot be captured: capture one of hid";
    return "";
  }
};

/**
 * Returns all back ends in the order in which they are listed. They live as long as the process.
 */
const std::vector<Backend*>& backends();

/** Returns the back end of a name, or nullptr. */
Backend* backendNamed(const std::string& name);

}  // namespace palpate

#endif
