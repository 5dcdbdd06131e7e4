package org.palpate.imagej.session;

import org.palpate.realtime.RealtimeThread;
import org.palpate.realtime.WaitKind;
import org.palpate.realtime.os.RealtimeRequest;
import org.palpate.realtime.os.SchedulingClass;

/** What a haptic thread inside ImageJ asks of the system. */
public final class StackRealtime {
  private StackRealtime() {}

  /**
   * All that helps but locked memory: the heap is ImageJ's, as large as the user made it, and not
   * ours to keep from being swapped.
   */
  public static RealtimeThread thread() {
    RealtimeRequest wish = new RealtimeRequest(SchedulingClass.FIFO, true, false, true, true);
    return new RealtimeThread(wish, WaitKind.HYBRID);
  }
}
