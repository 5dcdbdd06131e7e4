package org.palpate.device.jni;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.locks.LockSupport;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Lets every call of every back end fail in every way inside a JVM, which must survive. The C++
 * tests check the outcome of each fault in more detail, with the same substitute libraries.
 */
class FaultTest {
  private static final int HANG = 6;
  private static final List<String> FAULTS =
      List.of("error once", "error", "time-out", "not a number", "unplugged", "hang");
  private static final int SHORT_MILLIS = 30;
  private static final int LONG_MILLIS = 5000;
  private static final int FRAMES = 30;

  /** Pause that gives another thread or process its turn. */
  private static final int WAIT_NANOS = 20_000;

  private static FaultPanel panel;
  private static Process fakeHid;

  @BeforeAll
  static void putTheSubstitutesInPlace() throws IOException {
    String file = System.getenv("PALPATE_PANEL");
    String fake = System.getProperty("palpate.fakeHid", "");
    boolean built = file != null && Files.isExecutable(Path.of(fake));
    Assumptions.assumeTrue(
        built && NativeLibrary.isLoaded(), "skipped: no substitute libraries: " + fake);
    panel = new FaultPanel(Path.of(file));
    String folder = System.getenv("PALPATE_FAKE_HID");
    Files.createDirectories(Path.of(folder));
    fakeHid = new ProcessBuilder(fake, folder, "SN0001", "120").inheritIO().start();
  }

  @AfterAll
  static void takeTheFakeAway() {
    if (fakeHid != null) {
      fakeHid.destroy();
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"hid", "openhaptics", "forcedimension", "virtuose"})
  void theJvmOutlivesEveryFault(String backend) {
    List<String> calls = cleanSession(backend);
    assertTrue(calls.size() > 5, "calls=" + calls);
    int injected = 0;
    for (String call : calls) {
      for (int fault = 1; fault <= FAULTS.size(); fault++) {
        failAt(backend, call, fault, true);
        failAt(backend, call, fault, false);
        injected += 2;
      }
    }
    List<String> after = cleanSession(backend);
    assertEquals(
        List.copyOf(calls).size(), after.size(), "after all faults a session is as before");
    System.out.println("native: " + backend + " in the JVM: " + injected + " faults survived");
  }

  /** Runs a session without a fault and returns the functions that it calls. */
  private static List<String> cleanSession(String backend) {
    panel.clear();
    String[] why = {""};
    long handle = openPatiently(backend, why);
    assertTrue(handle != 0, backend + ": " + why[0]);
    run(handle);
    assertEquals(NativeCalls.ZERO_SENT, NativeCalls.close(handle, LONG_MILLIS), backend);
    settle();
    return panel.called();
  }

  /** Opens repeatedly, because the substitute of {@code hid} needs a moment to appear. */
  private static long openPatiently(String backend, String[] why) {
    long handle = 0;
    for (int i = 0; handle == 0 && i < 1000; i++) {
      handle = NativeCalls.open(backend, "", LONG_MILLIS, why);
    }
    return handle;
  }

  private static void failAt(String backend, String call, int fault, boolean opening) {
    String where = backend + ", " + call + ", " + FAULTS.get(fault - 1) + ", opening=" + opening;
    panel.clear();
    if (opening) {
      panel.arm(call, fault);
    }
    String[] why = {""};
    boolean mayHang = opening && fault == HANG;
    long handle = NativeCalls.open(backend, "", mayHang ? SHORT_MILLIS : LONG_MILLIS, why);
    assertTrue(handle != 0 || opening, where + ": " + why[0]);
    assertTrue(handle != 0 || isOneLine(why[0]), where + ": " + why[0]);
    if (handle != 0) {
      if (!opening) {
        panel.arm(call, fault);
      }
      runAndClose(handle, fault, where);
    }
    panel.release();
    settle();
    assertEquals(0, panel.overlaps(), where);
    assertTrue(panel.force() == 0 || panel.isUnplugged(), where + ": force=" + panel.force());
  }

  private static void runAndClose(long handle, int fault, String where) {
    Thread haptic = new Thread(() -> run(handle));
    haptic.start();
    join(haptic, fault == HANG ? SHORT_MILLIS : LONG_MILLIS);
    int closed = NativeCalls.close(handle, fault == HANG ? SHORT_MILLIS : LONG_MILLIS);
    if (closed == NativeCalls.HUNG) {
      assertTrue(isOneLine(NativeCalls.ending(handle)), where + ": no line names the hang");
    }
    panel.release();
    join(haptic, LONG_MILLIS);
    assertFalse(haptic.isAlive(), where);
    while (NativeCalls.close(handle, SHORT_MILLIS) == NativeCalls.HUNG) {
      LockSupport.parkNanos(WAIT_NANOS);
    }
    assertEquals(2, NativeCalls.read(handle), where);
  }

  /** Runs frames until the device is gone or enough of them were fresh. */
  private static void run(long handle) {
    int fresh = 0;
    for (int i = 0; fresh < FRAMES && i < 10_000; i++) {
      int status = NativeCalls.read(handle);
      if (status == 2) {
        return;
      }
      fresh += status == 0 ? 1 : 0;
      if (status == 0) {
        NativeCalls.write(handle);
      } else {
        LockSupport.parkNanos(WAIT_NANOS);
      }
    }
  }

  private static boolean isOneLine(String text) {
    return !text.isEmpty() && text.indexOf('\n') < 0;
  }

  private static void join(Thread thread, long millis) {
    try {
      thread.join(millis);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Waits until no thread is inside a vendor's library. */
  private static void settle() {
    while (NativeCalls.underWay() > 0) {
      LockSupport.parkNanos(WAIT_NANOS);
    }
  }
}
