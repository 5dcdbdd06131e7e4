#ifndef PALPATE_SUBSTITUTES_PANEL_H
#define PALPATE_SUBSTITUTES_PANEL_H

#include <atomic>
#include <cstddef>
#include <cstdint>

namespace substitutes {

/** What goes wrong at a call. */
enum Fault : int32_t {
  kNone = 0,
  kErrorOnce = 1,   // the function's own error, one time
  kError = 2,       // from now on, at this function
  kTimeOut = 3,     // 30 ms late and then an error, one time
  kNotANumber = 4,  // what it gives is NaN, from now on
  kUnplugged = 5,   // from now on everything fails
  kHang = 6,        // does not return until the panel releases it
};

/** A function that was called, and how often. */
struct Called {
  char name[40];
  std::atomic<int32_t> times;
  int32_t unused;
};

/**
 * What a test and a substitute library share, through a file that both map: the test sets faults
 * and where the device is, the library notes what it was told. Offsets are used by Java tests too.
 */
struct Panel {
  char faultCall[40];                // 0: name of the function that fails
  std::atomic<int32_t> fault;        // 40
  std::atomic<int32_t> released;     // 44: lets hanging calls go on
  std::atomic<int32_t> unplugged;    // 48
  std::atomic<int32_t> inside;       // 52: threads in the library now
  std::atomic<int32_t> overlaps;     // 56: times that two were
  std::atomic<int32_t> struck;       // 60: times that the fault struck
  std::atomic<int32_t> ruleBreaks;   // 64: calls out of the documented order
  std::atomic<int32_t> openDevices;  // 68
  std::atomic<int32_t> noDevices;    // 72: 1 where none is plugged in
  std::atomic<int32_t> tickMicros;   // 76: of a scheduler; 0 means 1000
  double position[3];                // 80: of the probe, vendor's unit and frame
  std::atomic<double> force[3];      // 104: last one that reached the device
  std::atomic<double> torque[3];     // 128
  std::atomic<int64_t> forces;       // 152: how many did
  std::atomic<double> largest;       // 160: largest component so far
  std::atomic<int32_t> buttons;      // 168
  std::atomic<int32_t> notReady;     // 172: dead-man let go, or the force switched off
  std::atomic<int32_t> calledCount;  // 176
  int32_t unused;
  Called called[96];  // 184
};
static_assert(offsetof(Panel, fault) == 40 && offsetof(Panel, position) == 80 &&
                  offsetof(Panel, force) == 104 && offsetof(Panel, called) == 184,
              "layout is shared with FaultPanel.java");

/** The one that the environment variable PALPATE_PANEL names; a private one where it is not set. */
Panel& panel();

/** Stands at the top of every substitute function. */
class Call {
 public:
  /** Whether callers on several threads count as an overlap is the vendor's rule. */
  explicit Call(const char* name, bool oneThreadAtATime = true);
  ~Call();
  Call(const Call&) = delete;
  Call& operator=(const Call&) = delete;

  /** Whether this call has to fail. */
  bool fails() const { return fails_; }
  bool givesNaN() const { return givesNaN_; }

 private:
  bool counted_;
  bool fails_ = false;
  bool givesNaN_ = false;
};

/** Notes a force that reached the device. */
void noteForce(const double* force, const double* torque);

}  // namespace substitutes

#endif
