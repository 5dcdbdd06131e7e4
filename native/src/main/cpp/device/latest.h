#ifndef PALPATE_DEVICE_LATEST_H
#define PALPATE_DEVICE_LATEST_H

#include <atomic>

namespace palpate {

/**
 * A triple buffer: passes the newest value from one thread to another, and neither ever waits. One
 * copy is written, one is read, and the third lies between them. An atomic exchange swaps it with
 * either of the others.
 */
template <typename T>
class Latest {
 public:
  /** Publishes a value. Writer's thread. */
  void publish(const T& value) {
    values_[writing_] = value;
    writing_ = between_.exchange(writing_ | kNew, std::memory_order_acq_rel) & kPlace;
  }

  /**
   * Copies the newest value into `dest`. Returns false if there is none since the last call.
   * Reader's thread.
   */
  bool take(T& dest) {
    if ((between_.load(std::memory_order_relaxed) & kNew) == 0) {
      return false;
    }
    reading_ = between_.exchange(reading_, std::memory_order_acq_rel) & kPlace;
    dest = values_[reading_];
    return true;
  }

 private:
  static constexpr unsigned kNew = 4;
  static constexpr unsigned kPlace = 3;

  T values_[3];
  unsigned writing_ = 0;
  unsigned reading_ = 1;
  std::atomic<unsigned> between_{2};
};

}  // namespace palpate

#endif
