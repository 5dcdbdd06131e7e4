package org.palpate.realtime.os;

/** Scheduling classes of a thread. */
public enum SchedulingClass {
  /** The class of ordinary threads. */
  NORMAL,
  /** Runs before every ordinary thread until it sleeps. */
  FIFO,
  /** As {@link #FIFO}, but threads of the same priority take turns. */
  ROUND_ROBIN
}
