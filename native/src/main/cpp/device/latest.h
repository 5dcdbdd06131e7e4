#ifndef PALPATE_DEVICE_LATEST_H
#define PALPATE_DEVICE_LATEST_H

#include <atomic>

namespace palpate {

/**
 * The newest value handed from one thread to one other, neither of which ever waits. Three places:
 * one being written, one being read, one between, which change hands by an atomic exchange.
 */
template <typename T>
class Latest {
 public:
  /** Writer's thread. */
  void publish(const T& value) {
    values_[writing_] = value;
    writing_ = between_.exchange(writing_ | kNew, std::memory_order_acq_rel) & kPlace;
  }

  /** Reader's thread: whether something newer than last time was copied into `dest`. */
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
