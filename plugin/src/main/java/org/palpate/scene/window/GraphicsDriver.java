package org.palpate.scene.window;

import com.jogamp.opengl.GLProfile;

/** Whether this machine can draw. */
public final class GraphicsDriver {
  private static final String PACKAGES =
      "libgl1 libglx-mesa0 libgl1-mesa-dri libx11-6 libxxf86vm1 libxrender1 libxrandr2 libxcursor1"
          + " libxi6";

  /** JOGL gives a lock up after five seconds, which a busy machine may need to load a driver. */
  private static final String LOCK_TIMEOUT = "jogamp.common.utils.locks.Lock.timeout";

  private static final String LOCK_TIMEOUT_MILLIS = "60000";

  /** Loads the driver, where that was begun early. */
  private static Thread preparing;

  static {
    if (System.getProperty(LOCK_TIMEOUT) == null) {
      System.setProperty(LOCK_TIMEOUT, LOCK_TIMEOUT_MILLIS);
    }
  }

  private GraphicsDriver() {}

  /** Whether a display is named here; always so where windows do not need one to be named. */
  public static boolean hasDisplay() {
    String system = System.getProperty("os.name", "");
    boolean isX11 = !system.startsWith("Windows") && !system.startsWith("Mac");
    String display = System.getenv("DISPLAY");
    return !isX11 || (display != null && !display.isBlank());
  }

  /**
   * Begins to load the driver in the background, so that a window opens sooner; what is wrong with
   * it is told where the window is opened.
   */
  public static synchronized void prepare() {
    preparing = new Thread(GraphicsDriver::load, "palpate-graphics");
    preparing.setDaemon(true);
    preparing.start();
  }

  private static void load() {
    try {
      loadProfile();
    } catch (GraphicsException e) {
      // Told when the window is opened, with what to do.
    }
  }

  /**
   * The profile to draw with, OpenGL 3.3 core or later.
   *
   * @throws GraphicsException where there is none, with the reason
   */
  static GLProfile profile() throws GraphicsException {
    awaitPreparation();
    return loadProfile();
  }

  private static void awaitPreparation() {
    Thread thread;
    synchronized (GraphicsDriver.class) {
      thread = preparing;
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
          "there is no display", "set DISPLAY, or install xvfb and start it by xvfb-run", null);
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

  /** What a driver's refusal means for a person. */
  static GraphicsException refused(Throwable cause) {
    String reason = cause.getMessage() == null ? cause.toString() : cause.getMessage();
    return new GraphicsException(
        "OpenGL cannot be used (" + reason.lines().findFirst().orElse("") + ")",
        "check DISPLAY and install " + PACKAGES,
        cause);
  }
}
