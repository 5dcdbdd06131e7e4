package org.palpate.realtime.os;

import java.util.BitSet;

/**
 * The calls of an operating system that affect scheduling, for the calling thread unless another
 * one is named. Each returns an empty text on success and otherwise the system's name of the error.
 */
interface Scheduler {
  /**
   * Sets the scheduling class and the priority of a thread of this process.
   *
   * @param tid the thread's number; 0 for the calling thread
   * @param priority from 1, the lowest real-time priority, to 99
   */
  String setRealtime(int tid, SchedulingClass schedulingClass, int priority);

  /** Restricts the thread to these processors. */
  String setAffinity(BitSet cpus);

  /** Locks all present and future pages of the process in memory. */
  String lockMemory();

  /** Limits the delay that the kernel may add to a wake-up. */
  String setTimerSlack(long nanos);
}
