package org.palpate.imagej;

import org.palpate.realtime.RealtimeThread;
import org.palpate.realtime.RealtimeWish;
import org.palpate.realtime.SchedulingClass;
import org.palpate.realtime.WaitKind;

/** What a haptic thread inside ImageJ asks of the system. */
final class StackRealtime {
  private StackRealtime() {}

  /**
   * All that helps but locked memory: the heap is ImageJ's, as large as the user made it, and not
   * ours to keep from being swapped.
   */
  static RealtimeThread thread() {
    RealtimeWish wish = new RealtimeWish(SchedulingClass.FIFO, true, false, true, true);
    return new RealtimeThread(wish, WaitKind.HYBRID);
  }
}
