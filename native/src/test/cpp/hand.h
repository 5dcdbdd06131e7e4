#ifndef PALPATE_HAND_H
#define PALPATE_HAND_H

#include "palpate_device.h"

/** Moves a fake device as a hand does: still for a second, then to and fro, 40 mm in 4 s. */
void moveHand(palpate_pose& pose, double seconds);

/** What a fake device notes of the forces that it was sent, and says at its end. */
class Felt {
 public:
  /** One report interval: what the motors do, and how many reports came in it. */
  void note(const palpate_motors& motors, int reports);

  /** One line on standard error. */
  void say(const char* name, const palpate_device& firmware, const palpate_motors& last) const;

 private:
  long intervals_ = 0;
  long reports_ = 0;
  long silent_ = 0;
  long pushing_ = 0;
  int largestMn_ = 0;
};

/** Sleeps until the next whole millisecond after `startNanos`; the number of it. */
long nextMillisecond(long startNanos);

/** Nanoseconds on the system's steady clock. */
long nowNanos();

#endif
