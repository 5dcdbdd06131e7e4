package org.palpate.imagej.session;

import org.palpate.loop.LoopSettings;
import org.palpate.realtime.RealtimeThread;
import org.palpate.realtime.WaitKind;
import org.palpate.realtime.os.RealtimeRequest;
import org.palpate.realtime.os.SchedulingClass;

/** The real-time settings of a haptic thread inside ImageJ. */
public final class StackRealtime {
  private StackRealtime() {}

  /**
   * Returns every recommended request except locked memory: the user chose the size of ImageJ's
   * heap, which may be too large to lock.
   */
  public static RealtimeThread thread() {
    RealtimeRequest request = new RealtimeRequest(SchedulingClass.FIFO, true, false, true, true);
    return new RealtimeThread(request, WaitKind.HYBRID, LoopSettings.DEFAULT_PERIOD_NANOS);
  }
}
