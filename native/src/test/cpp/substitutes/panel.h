#ifndef PALPATE_SUBSTITUTES_PANEL_H
#define PALPATE_SUBSTITUTES_PANEL_H

#include <atomic>
#include <cstddef>
#include <cstdint>

namespace substitutes {

/** The faults of a call. */
enum Fault : int32_t {
  kNone = 0,
  kErrorOnce = 1,   // the function's own error, once
  kError = 2,       // the same at every call from now on
  kTimeOut = 3,     // an error after 30 ms, once
  kNotANumber = 4,  // NaN as a result, from now on
  kUnplugged = 5,   // every function fails from now on
  kHang = 6,        // does not return until the panel releases it
};

/** A function that was called, and the number of its calls. */
struct Called {
  char name[40];
  std::atomic<int32_t> times;
  int32_t unused;
};

/**
 * The memory that a test and a substitute library share, through a file that both map. The test
 * sets the faults and the position of the device; the library records its calls and forces. Java
 * tests use these offsets too.
 */
struct Panel {
  char faultCall[40];                // 0: name of the function that fails
  std::atomic<int32_t> fault;        // 40
  std::atomic<int32_t> released;     // 44: lets hanging calls go on
  std::atomic<int32_t> unplugged;    // 48
  std::atomic<int32_t> inside;       // 52: threads in the library now
  std::atomic<int32_t> overlaps;     // 56: times that there were two
  std::atomic<int32_t> struck;       // 60: times that the fault occurred
  std::atomic<int32_t> ruleBreaks;   // 64: calls against the documented order
  std::atomic<int32_t> openDevices;  // 68
  std::atomic<int32_t> noDevices;    // 72: 1 if none is plugged in
  std::atomic<int32_t> tickMicros;   // 76: period of a scheduler; 0 means 1000
  double position[3];                // 80: of the probe, vendor's unit and frame
  std::atomic<double> force[3];      // 104: last one that reached the device
  std::atomic<double> torque[3];     // 128
  std::atomic<int64_t> forces;       // 152: number of forces that did
  std::atomic<double> largest;       // 160: largest component so far
  std::atomic<int32_t> buttons;      // 168
  std::atomic<int32_t> notReady;     // 172: safety switch released, or force off
  std::atomic<int32_t> calledCount;  // 176
  int32_t unused;
  Called called[96];  // 184
};
static_assert(offsetof(Panel, fault) == 40 && offsetof(Panel, position) == 80 &&
                  offsetof(Panel, force) == 104 && offsetof(Panel, called) == 184,
              "layout is shared with FaultPanel.java");

/**
 * Returns the panel that the environment variable PALPATE_PANEL names; a private one if it is not
 * set.
 */
Panel& panel();

/** Records a call; every substitute function begins with one. */
class Call {
 public:
  /**
   * Begins a call. `oneThreadAtATime` states whether the vendor forbids calls on several threads at
   * once.
   */
  explicit Call(const char* name, bool oneThreadAtATime = true);
  ~Call();
  Call(const Call&) = delete;
  Call& operator=(const Call&) = delete;

  /** Whether this call must fail. */
  bool fails() const { return fails_; }
  bool givesNaN() const { return givesNaN_; }

 private:
  bool counted_;
  bool fails_ = false;
  bool givesNaN_ = false;
};

/** Records a force that reached the device. */
void noteForce(const double* force, const double* torque);

}  // namespace substitutes

#endif
