package org.palpate.display;

import com.sun.jna.Native;
import com.sun.jna.Platform;
import com.sun.jna.Pointer;

/**
 * Keeps one connection to the X server open for as long as the process lives.
 *
 * <p>An X server that has lost its last client resets itself: it closes its sockets and opens them
 * again, and refuses whoever connects in between. A graphics driver opens and closes connections
 * while it looks for what the server offers. On a server with no other client, such as one started
 * by xvfb-run, it could therefore be refused by the reset that it caused.
 */
public final class DisplayConnection {
  /** Binds Xlib directly; JNA loads it on first use. */
  private static final class X11Library {
    static {
      Native.register(X11Library.class, "X11");
    }

    private X11Library() {}

    /** Prepares Xlib for several threads. It must be the first call of a process to Xlib. */
    static native int XInitThreads();

    /** Connects to a display; {@code null} is the display that the environment names. */
    static native Pointer XOpenDisplay(String name);
  }

  private static Pointer held;

  private DisplayConnection() {}

  /**
   * Connects to the display that the environment names, unless this was done before. Call it before
   * the graphics driver is loaded. Any thread.
   *
   * @return whether a connection is held; {@code false} on Windows and macOS, without an Xlib or
   *     JNA, or if the server refuses
   */
  public static synchronized boolean hold() {
    if (held == null) {
      held = connect();
    }
    return held != null;
  }

  private static Pointer connect() {
    try {
      if (!Platform.isX11()) {
        return null; // the graphics driver needs no X server; macOS would start one for the call
      }
      X11Library.XInitThreads();
      return X11Library.XOpenDisplay(null);
    } catch (LinkageError e) {
      return null; // without an Xlib there is no display
    }
  }
}
