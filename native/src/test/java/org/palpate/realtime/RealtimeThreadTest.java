package org.palpate.realtime;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.Test;
import org.palpate.loop.ThreadSetup.Granted;
import org.palpate.realtime.os.RealtimeRequest;
import org.palpate.realtime.os.SchedulingClass;

class RealtimeThreadTest {
  private static final long MILLISECOND = 1_000_000;

  @Test
  void reportsDefaultsIfNothingWasRequested() throws InterruptedException {
    Granted granted = setUp(new RealtimeThread(RealtimeRequest.none(), WaitKind.PARK, MILLISECOND));
    assertEquals("default", granted.schedulingClass());
    assertEquals("any", granted.affinity());
    assertFalse(granted.memoryLocked());
  }

  @Test
  void reportsTheClassEitherAsGrantedOrAsDenied() throws InterruptedException {
    RealtimeRequest request = new RealtimeRequest(SchedulingClass.FIFO, false, false, false, true);
    Granted granted = setUp(new RealtimeThread(request, WaitKind.HYBRID, MILLISECOND));
    boolean refused = granted.refusals().stream().anyMatch(line -> line.startsWith("class:"));
    assertEquals(refused, granted.schedulingClass().equals("default"), granted.toString());
  }

  @Test
  void everyKindOfWaitEndsAfterTheDeadline() throws InterruptedException {
    for (WaitKind kind : WaitKind.values()) {
      try (DeadlineWait wait = kind.create(MILLISECOND)) {
        long deadline = System.nanoTime() + 2_000_000;
        wait.awaitUntil(deadline);
        assertTrue(System.nanoTime() >= deadline, kind.toString());
      }
    }
  }

  private static Granted setUp(RealtimeThread thread) throws InterruptedException {
    AtomicReference<Granted> granted = new AtomicReference<>();
    Thread runner = new Thread(() -> granted.set(thread.setUp()));
    runner.start();
    runner.join();
    thread.close();
    return granted.get();
  }
}
