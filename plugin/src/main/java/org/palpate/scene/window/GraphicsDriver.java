package org.palpate.scene.window;

import com.jogamp.opengl.GLProfile;
import java.util.Optional;
import org.palpate.display.DisplayConnection;

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

  /** The reason why there is no display; the environment of a process does not change. */
  private static final Optional<String> MISSING_DISPLAY = findMissingDisplay();

  /** The thread that loads the driver, if it was started. */
  private static Thread loading;

  static {
    if (System.getProperty(LOCK_TIMEOUT) == null) {
      System.setProperty(LOCK_TIMEOUT, LOCK_TIMEOUT_MILLIS);
    }
  }

  private GraphicsDriver() {}

  /**
   * Whether there is a display: the environment names one, and a server answers there. Always true
   * on systems that do not need one.
   */
  public static boolean hasDisplay() {
    return missingDisplay().isEmpty();
  }

  /** Returns the reason why there is no display, for the user; empty if there is one. */
  public static Optional<String> missingDisplay() {
    return MISSING_DISPLAY;
  }

  private static Optional<String> findMissingDisplay() {
    String system = System.getProperty("os.name", "");
    if (system.startsWith("Windows") || system.startsWith("Mac")) {
      return Optional.empty();
    }
    String display = System.getenv("DISPLAY");
    if (display == null || display.isBlank()) {
      return Optional.of("there is no display");
    }
    boolean answers = XServerAddress.parse(display).map(XServerAddress::answers).orElse(false);
    return answers ? Optional.empty() : Optional.of("no display answers at DISPLAY=" + display);
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
          MISSING_DISPLAY.get(), "set DISPLAY, or install xvfb and use xvfb-run", null);
    }
    DisplayConnection.hold();
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
