package org.palpate.display;

import com.sun.jna.Callback;
import com.sun.jna.Native;
import com.sun.jna.Pointer;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.locks.LockSupport;

/**
 * Keeps the process alive when its X server goes away.
 *
 * <p>Xlib ends a process in which any thread meets a broken connection. That would end the haptic
 * thread too, and its last force would stay on the device until the device's watchdog acts. The
 * handler installed here parks the thread that meets the broken connection for ever, so that all
 * other threads go on.
 *
 * <p>For a process that Palpate owns; another program's process must not be changed in this way.
 */
public final class DisplayLoss {
  /** Binds Xlib directly; JNA loads it on first use. */
  static final class X11Library {
    static {
      Native.register(X11Library.class, "X11");
    }

    private X11Library() {}

    /** Installs a handler that must not return, and returns the previous one. */
    static native Pointer XSetIOErrorHandler(LossHandler handler);
  }

  /** Binds the C library's call that ends a process without cleaning up; loaded on first use. */
  static final class CLibrary {
    static {
      Native.register(CLibrary.class, "c");
    }

    private CLibrary() {}

    /** Ends the process at once: no shutdown hooks, no exit handlers. */
    static native void _exit(int code);
  }

  /** The callback that Xlib runs in the thread that met a broken connection. */
  interface LossHandler extends Callback {
    int callback(Pointer display);
  }

  private static final AtomicBoolean HAPPENED = new AtomicBoolean();

  /** Referenced here because Xlib keeps only the address of the handler. */
  private static LossHandler installed;

  private DisplayLoss() {}

  /**
   * Installs the handler: from then on a lost display parks the threads that use it. Call it after
   * the window's libraries are loaded, because they install a handler of their own.
   *
   * @param onLoss called once, in the first thread that meets the broken connection
   * @return whether this process has an Xlib
   */
  public static synchronized boolean install(Runnable onLoss) {
    try {
      LossHandler handler = display -> park(onLoss);
      X11Library.XSetIOErrorHandler(handler);
      installed = handler;
      return true;
    } catch (LinkageError e) {
      return false; // without an Xlib there is no display to lose
    }
  }

  /**
   * Ends the process if the display was lost, and returns otherwise. An ordinary exit would wait
   * for the graphics driver, whose threads are parked. Flush all output before.
   */
  public static void exitIfLost(int exitCode) {
    if (HAPPENED.get()) {
      CLibrary._exit(exitCode);
    }
  }

  private static int park(Runnable onLoss) {
    if (!HAPPENED.getAndSet(true)) {
      onLoss.run();
    }
    while (installed != null) {
      LockSupport.park(DisplayLoss.class);
    }
    return 0;
  }
}
