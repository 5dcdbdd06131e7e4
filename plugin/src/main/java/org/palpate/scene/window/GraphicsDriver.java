package org.palpate.scene.window;

import com.jogamp.opengl.GLProfile;

/** Finds and loads the graphics driver. Any thread. */
public final class GraphicsDriver {
  private static final String PACKAGES =
      "libgl1 libglx-mesa0 libgl1-mesa-dri libx11-6 libxxf86vm1 libxrender1 libxrandr2 libxcursor1"
          + " libxi6";

  /**
   * JOGL's locks time out after five seconds by default; a busy machine may need longer to load a
   * driver.
   */
  private static final String LOCK_TIMEOUT = "jogamp.common.utils.locks.Lock.timeout";

  private static final String LOCK_TIMEOUT_MILLIS = "60000";

  /** The thread that loads the driver, if it was started. */
  private static Thread loading;

  static {
    if (System.getProperty(LOCK_TIMEOUT) == null) {
      System.setProperty(LOCK_TIMEOUT, LOCK_TIMEOUT_MILLIS);
    }
  }

  private GraphicsDriver() {}

  /** Whether the environment names a display; always true on systems that do not need one. */
  public static boolean hasDisplay() {
    String system = System.getProperty("os.name", "");
    boolean isX11 = !system.startsWith("Windows") && !system.startsWith("Mac");
    String display = System.getenv("DISPLAY");
    return !isX11 || (display != null && !display.isBlank());
  }

  /**
   * Starts to load the driver in the background, so that a window opens sooner. A failure is
   * reported when the window is opened.
   */
  public static synchronized void prepare() {
    loading = new Thread(GraphicsDriver::load, "palpate-graphics");
    loading.setDaemon(true);
    loading.start();
  }

  private static void load() {
    try {
      loadProfile();
    } catch (GraphicsException e) {
      // Opening the window reports it, with the remedy.
    }
  }

  /**
   * Returns the profile, OpenGL 3.3 core or later.
   *
   * @throws GraphicsException if there is none, with the reason
   */
  static GLProfile profile() throws GraphicsException {
    awaitLoading();
    return loadProfile();
  }

  private static void awaitLoading() {
    Thread thread;
    synchronized (GraphicsDriver.class) {
      thread = loading;
    }
    if (thread != null) {
      try {
        thread.join();
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      }
    }
  }

  private static GLProfile loadProfile() throws GraphicsException {
    if (!hasDisplay()) {
      throw new GraphicsException(
          "there is no display", "set DISPLAY, or install xvfb and use xvfb-run", null);
    }
    try {
      if (!GLProfile.isAvailable(GLProfile.GL3)) {
        throw new GraphicsException(
            "the graphics driver has no OpenGL 3.3",
            "install a newer driver, or " + PACKAGES,
            null);
      }
      return GLProfile.get(GLProfile.GL3);
    } catch (RuntimeException | LinkageError e) {
      // JOGL wraps a missing or dead X server in bare RuntimeExceptions.
      throw refused(e);
    }
  }

  /** Returns the error for a refusal of the driver, in words for the user. */
  static GraphicsException refused(Throwable cause) {
    String reason = cause.getMessage() == null ? cause.toString() : cause.getMessage();
    return new GraphicsException(
        "OpenGL cannot be used (" + reason.lines().findFirst().orElse("") + ")",
        "check DISPLAY and install " + PACKAGES,
        cause);
  }
}
