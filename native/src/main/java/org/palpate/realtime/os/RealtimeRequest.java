package org.palpate.realtime.os;

/**
 * The requests of a haptic thread to its operating system.
 *
 * @param schedulingClass the class; {@link SchedulingClass#NORMAL} requests nothing
 * @param pin whether to give the thread a processor of its own, if another one remains
 * @param lockMemory whether to keep the process in memory
 * @param raiseVmThreads whether to raise the JVM's own threads that stop and release all others to
 *     one priority below, so that a pause does not wait for ordinary threads
 * @param sleepsEachFrame whether the thread sleeps in every frame; a thread that never sleeps is
 *     denied a real-time class on a machine whose only processor it would occupy
 */
public record RealtimeRequest(
    SchedulingClass schedulingClass,
    boolean pin,
    boolean lockMemory,
    boolean raiseVmThreads,
    boolean sleepsEachFrame) {

  /** Returns all requests that help a loop which sleeps and then spins. */
  public static RealtimeRequest recommended() {
    return new RealtimeRequest(SchedulingClass.FIFO, true, true, true, true);
  }

  /** Returns a request for an ordinary thread. */
  public static RealtimeRequest none() {
    return new RealtimeRequest(SchedulingClass.NORMAL, false, false, false, true);
  }
}
