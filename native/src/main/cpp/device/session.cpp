#include "device/session.h"

#include <array>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>

#include "device/clock.h"
#include "device/governor.h"

namespace palpate {
namespace {

/**
 * The low bits of Slot::state. The other bits are the generation, so an old handle never matches.
 */
enum Phase : uint64_t { kFree = 0, kClaimed = 1, kIdle = 2, kBusy = 3, kClosing = 4, kLeaving = 5 };
constexpr uint64_t kPhaseBits = 3;
constexpr uint64_t kSlotBits = 8;

uint64_t stateOf(uint64_t generation, Phase phase) { return generation << kPhaseBits | phase; }

struct Slot {
  Frame frame;
  std::atomic<uint64_t> state{0};
  std::unique_ptr<Device> device;
  std::optional<Governor> governor;
  Wrench limited;
  std::atomic<bool> zeroSent{false};
  std::mutex about;  // guards the members below; no frame locks it
  Specification specification;
  std::shared_ptr<Trace> trace;
};

std::array<Slot, Session::kMaxOpen>& slots() {
  static auto* all = new std::array<Slot, Session::kMaxOpen>();  // outlives a thread that hangs
  return *all;
}

Slot& slotOf(int64_t handle) {
  return slots()[static_cast<uint64_t>(handle) & (Session::kMaxOpen - 1)];
}

uint64_t generationOf(int64_t handle) { return static_cast<uint64_t>(handle) >> kSlotBits; }

bool isCurrent(int64_t handle) {
  return generationOf(handle) > 0 &&
         slotOf(handle).state.load() >> kPhaseBits == generationOf(handle);
}

bool move(Slot& slot, uint64_t generation, Phase from, Phase to) {
  uint64_t expected = stateOf(generation, from);
  return slot.state.compare_exchange_strong(expected, stateOf(generation, to),
                                            std::memory_order_acq_rel);
}

/** Sends zero force and releases the device. For the one thread that owns it now. */
void letGo(Slot& slot, uint64_t generation) {
  slot.zeroSent.store(slot.device->close());
  slot.device.reset();
  slot.state.store(stateOf(generation, kFree), std::memory_order_release);
}

/**
 * Ends a call of the haptic thread. Closes the device if another thread requested that meanwhile.
 */
void leave(Slot& slot, uint64_t generation) {
  if (!move(slot, generation, kBusy, kIdle)) {
    letGo(slot, generation);
  }
}

ReadStatus readInto(Slot& slot) {
  Sample& sample = slot.frame.sample;
  const ReadStatus status = slot.device->read(sample);
  if (slot.governor) {
    slot.governor->sampled(status == ReadStatus::kFresh, sample, steadyNanos());
    if (slot.governor->isWaitingForHand()) {
      sample.flags |= kWaitingForHand;
    } else {
      sample.flags &= ~kWaitingForHand;
    }
  }
  return status;
}

bool writeFrom(Slot& slot) {
  if (!slot.governor) {
    return slot.device->write(slot.frame.wrench);
  }
  slot.governor->limit(slot.frame.wrench, steadyNanos(), slot.limited);
  return slot.device->write(slot.limited);
}

std::atomic<int> threadsUnderWay{0};

/** Runs `work` on a new thread, which counts as under way until `work` returns. */
template <typename Work>
void runDetached(Work work) {
  threadsUnderWay++;
  std::thread([work] {
    work();
    threadsUnderWay--;
  }).detach();
}

/** The state that a helper thread shares with the thread that waits for its result. */
template <typename R>
struct Errand {
  std::mutex lock;
  std::condition_variable done;
  bool isDone = false;
  bool isAbandoned = false;
  R result{};
  std::string why;
  std::shared_ptr<Trace> trace = std::make_shared<Trace>();
};

/**
 * Runs `work` on a helper thread and waits. Returns false if it takes longer than `waitNanos`;
 * `late` then receives the result when it comes.
 */
template <typename R, typename Work, typename Late>
bool runBeside(const std::shared_ptr<Errand<R>>& errand, int64_t waitNanos, Work work, Late late) {
  runDetached([errand, work, late] {
    R result{};
    try {
      result = work(*errand);
    } catch (const std::exception& e) {
      errand->why = e.what();
    }
    std::unique_lock<std::mutex> guard(errand->lock);
    if (errand->isAbandoned) {
      guard.unlock();
      late(result);
      return;
    }
    errand->result = std::move(result);
    errand->isDone = true;
    errand->done.notify_all();
  });
  std::unique_lock<std::mutex> guard(errand->lock);
  errand->done.wait_for(guard, std::chrono::nanoseconds(waitNanos), [&] { return errand->isDone; });
  errand->isAbandoned = !errand->isDone;
  return errand->isDone;
}

std::string hangLine(const Trace& trace, int64_t waitNanos) {
  const char* call = trace.call();
  return std::string(call != nullptr ? call : "the vendor's library") + " did not answer within " +
         std::to_string(waitNanos / kNanosPerMilli) + " ms: switch the device off and on";
}

std::string hungFor(const Trace& trace, const Specification& specification) {
  const char* call = trace.call();
  return std::string(call != nullptr ? call : "a vendor's call") +
         " does not return: the force is left to " + specification.watchdog;
}

int64_t settle(size_t index, uint64_t generation, std::unique_ptr<Device> device,
               std::shared_ptr<Trace> trace) {
  Slot& slot = slots()[index];
  slot.frame = Frame();
  slot.device = std::move(device);
  slot.device->countInto(&slot.frame.counters);
  const Specification& specification = slot.device->specification();
  slot.governor.reset();
  if (specification.maxForceNewton > 0 && std::isfinite(specification.maxForceNewton)) {
    slot.governor.emplace(specification);
  }
  {
    const std::lock_guard<std::mutex> guard(slot.about);
    slot.specification = specification;
    slot.trace = std::move(trace);
  }
  slot.state.store(stateOf(generation, kIdle), std::memory_order_release);
  return static_cast<int64_t>(generation << kSlotBits | index);
}

}  // namespace

int64_t Session::open(Backend& backend, const std::string& id, int64_t waitNanos,
                      std::string& why) {
  using Opened = std::unique_ptr<Device>;
  auto errand = std::make_shared<Errand<Opened>>();
  const bool answered = runBeside<Opened>(
      errand, waitNanos,
      [&backend, id](Errand<Opened>& self) { return backend.open(id, self.trace, self.why); },
      [](Opened& late) {
        if (late) {
          late->close();
        }
      });
  if (!answered || !errand->result) {
    why = answered ? errand->why : hangLine(*errand->trace, waitNanos);
    return 0;
  }
  for (size_t index = 0; index < slots().size(); index++) {
    const uint64_t state = slots()[index].state.load();
    const uint64_t generation = state >> kPhaseBits;
    uint64_t expected = stateOf(generation, kFree);
    if (slots()[index].state.compare_exchange_strong(expected, stateOf(generation + 1, kClaimed))) {
      return settle(index, generation + 1, std::move(errand->result), errand->trace);
    }
  }
  errand->result->close();
  why = std::to_string(kMaxOpen) + " devices are open already: close one";
  return 0;
}

Finding Session::probe(Backend& backend, int64_t waitNanos) {
  auto errand = std::make_shared<Errand<Finding>>();
  const bool answered = runBeside<Finding>(
      errand, waitNanos, [&backend](Errand<Finding>& self) { return backend.probe(*self.trace); },
      [](Finding&) {});
  if (answered) {
    return errand->result;
  }
  Finding hung;
  hung.why = hangLine(*errand->trace, waitNanos);
  return hung;
}

std::string Session::capture(Backend& backend, const std::string& id, int64_t waitNanos,
                             std::string& why) {
  auto errand = std::make_shared<Errand<std::string>>();
  const bool answered = runBeside<std::string>(
      errand, waitNanos,
      [&backend, id](Errand<std::string>& self) {
        return backend.capture(id, *self.trace, self.why);
      },
      [](std::string&) {});
  why = answered ? errand->why : hangLine(*errand->trace, waitNanos);
  return answered ? errand->result : std::string();
}

ReadStatus Session::read(int64_t handle) noexcept {
  Slot& slot = slotOf(handle);
  const uint64_t generation = generationOf(handle);
  if (!move(slot, generation, kIdle, kBusy)) {
    return ReadStatus::kDisconnected;
  }
  const ReadStatus status = readInto(slot);
  leave(slot, generation);
  return status;
}

bool Session::write(int64_t handle) noexcept {
  Slot& slot = slotOf(handle);
  const uint64_t generation = generationOf(handle);
  if (!move(slot, generation, kIdle, kBusy)) {
    return false;
  }
  const bool reached = writeFrom(slot);
  leave(slot, generation);
  return reached;
}

Session::Closed Session::close(int64_t handle, int64_t waitNanos) noexcept {
  Slot& slot = slotOf(handle);
  const uint64_t generation = generationOf(handle);
  if (!isCurrent(handle) || slot.state.load() == stateOf(generation, kFree)) {
    return Closed::kAlready;
  }
  const Deadline deadline(waitNanos);
  while (slot.state.load() != stateOf(generation, kFree)) {
    if (move(slot, generation, kIdle, kClosing)) {
      runDetached([&slot, generation] { letGo(slot, generation); });
    }
    move(slot, generation, kBusy, kLeaving);
    if (deadline.isOver()) {
      slot.trace->end(hungFor(*slot.trace, slot.specification));
      return Closed::kHung;
    }
    std::this_thread::sleep_for(std::chrono::microseconds(100));
  }
  return slot.zeroSent.load() ? Closed::kZeroSent : Closed::kUnreachable;
}

Frame* Session::frame(int64_t handle) {
  return isCurrent(handle) ? &slotOf(handle).frame : nullptr;
}

Specification Session::specification(int64_t handle) {
  Slot& slot = slotOf(handle);
  const std::lock_guard<std::mutex> guard(slot.about);
  return isCurrent(handle) ? slot.specification : Specification();
}

int Session::underWay() { return threadsUnderWay.load(); }

std::string Session::ending(int64_t handle) {
  Slot& slot = slotOf(handle);
  const std::lock_guard<std::mutex> guard(slot.about);
  return isCurrent(handle) && slot.trace ? slot.trace->why() : std::string();
}

}  // namespace palpate
