package org.palpate.realtime.os;

/**
 * What a haptic thread asks of its system.
 *
 * @param schedulingClass {@link SchedulingClass#NORMAL} asks for nothing
 * @param pin one processor of its own, where another is left for everything else
 * @param lockMemory the process stays in memory
 * @param raiseVm the JVM's own threads that stop and release all others compete the same way, one
 *     priority below, so that a pause does not wait for ordinary threads
 * @param sleepsEachFrame whether the thread sleeps in every frame; one that never does is refused a
 *     real-time class on a machine whose only processor it would keep
 */
public record RealtimeRequest(
    SchedulingClass schedulingClass,
    boolean pin,
    boolean lockMemory,
    boolean raiseVm,
    boolean sleepsEachFrame) {

  /** All that helps a loop that sleeps and then spins. */
  public static RealtimeRequest usual() {
    return new RealtimeRequest(SchedulingClass.FIFO, true, true, true, true);
  }

  /** Nothing: a thread as any other. */
  public static RealtimeRequest none() {
    return new RealtimeRequest(SchedulingClass.NORMAL, false, false, false, true);
  }
}
