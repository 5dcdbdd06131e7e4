#ifndef PALPATE_HAND_H
#define PALPATE_HAND_H

#include "palpate_device.h"

/** Moves a fake device like a hand: at rest for a second, then to and fro by 40 mm in 4 s. */
void moveHand(palpate_pose& pose, double seconds);

/** Statistics of the forces that a fake device received, which it prints at its end. */
class Felt {
 public:
  /** Adds one report interval: the order of the motors, and the number of reports received. */
  void note(const palpate_motors& motors, int reports);

  /** Prints one line on standard error. */
  void say(const char* name, const palpate_device& firmware, const palpate_motors& last) const;

 private:
  long intervals_ = 0;
  long reports_ = 0;
  long silent_ = 0;
  long pushing_ = 0;
  int largestMn_ = 0;
};

/** Sleeps until the next whole millisecond after `startNanos`, and returns its number. */
long nextMillisecond(long startNanos);

/** Returns nanoseconds on the system's steady clock. */
long nowNanos();

#endif
