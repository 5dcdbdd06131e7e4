package org.palpate.display;

import com.sun.jna.Callback;
import com.sun.jna.Native;
import com.sun.jna.Pointer;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.locks.LockSupport;

/**
 * Lets a process live on whose X server went away. Xlib ends a process in which any thread meets a
 * broken connection, and with it the haptic thread, whose last force would stay on the device until
 * its own watchdog ends it. With this the threads that meet it are held for ever instead, and
 * whoever does not draw goes on.
 *
 * <p>For a process of our own alone, not inside another program.
 */
public final class DisplayLoss {
  /** Xlib's call, mapped directly; loaded where it is first asked for. */
  static final class X11Library {
    static {
      Native.register(X11Library.class, "X11");
    }

    private X11Library() {}

    /** Takes a handler that must not return, and answers with the last one. */
    static native Pointer XSetIOErrorHandler(LossHandler handler);
  }

  /** The C library's call that ends a process without cleaning up; loaded when it is first used. */
  static final class CLibrary {
    static {
      Native.register(CLibrary.class, "c");
    }

    private CLibrary() {}

    /** Ends the process at once: no shutdown hooks, no exit handlers. */
    static native void _exit(int code);
  }

  /** What Xlib calls in the thread that met a broken connection. */
  interface LossHandler extends Callback {
    int callback(Pointer display);
  }

  private static final AtomicBoolean HAPPENED = new AtomicBoolean();

  /** Kept, because Xlib has its address and nobody else holds it. */
  private static LossHandler installed;

  private DisplayLoss() {}

  /**
   * From now on a lost display holds the threads that use it, instead of ending the process. To be
   * called when the window's libraries are loaded, for they have such a handler of their own.
   *
   * @param told called once when it happens, in the thread that noticed, which is then held
   * @return whether there is an Xlib
   */
  public static synchronized boolean survive(Runnable told) {
    try {
      LossHandler handler = display -> hold(told);
      X11Library.XSetIOErrorHandler(handler);
      installed = handler;
      return true;
    } catch (LinkageError e) {
      return false; // no X here, so none to lose
    }
  }

  /**
   * Ends the process where the display was lost, and does nothing where it was not. The usual ways
   * out wait for the graphics driver, whose threads are held. All output must have been flushed.
   */
  public static void exitIfLost(int exitCode) {
    if (HAPPENED.get()) {
      CLibrary._exit(exitCode);
    }
  }

  private static int hold(Runnable told) {
    if (!HAPPENED.getAndSet(true)) {
      told.run();
    }
    while (installed != null) {
      LockSupport.park(DisplayLoss.class);
    }
    return 0;
  }
}
