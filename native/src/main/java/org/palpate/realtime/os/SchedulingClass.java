package org.palpate.realtime.os;

/** How a thread competes with others. */
public enum SchedulingClass {
  /** As every thread does. */
  NORMAL,
  /** Before every ordinary thread, until it sleeps. */
  FIFO,
  /** As {@link #FIFO}, in turns with others of the same priority. */
  ROUND_ROBIN
}
