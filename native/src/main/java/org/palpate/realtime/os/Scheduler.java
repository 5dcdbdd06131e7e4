package org.palpate.realtime.os;

import java.util.BitSet;

/**
 * What an operating system can do for the calling thread, where no other is named. Every answer is
 * empty where it was done, else the system's name of the error.
 */
interface Scheduler {
  /**
   * Sets how a thread of this process competes.
   *
   * @param tid its number, 0 for the calling thread
   * @param priority from 1, the lowest real-time one, to 99
   */
  String setRealtime(int tid, SchedulingClass schedulingClass, int priority);

  /** Keeps the thread on these processors. */
  String setAffinity(BitSet cpus);

  /** Keeps the whole process in memory, now and later. */
  String lockMemory();

  /** Lets the kernel delay a wake-up by no more than this. */
  String setTimerSlack(long nanos);
}
