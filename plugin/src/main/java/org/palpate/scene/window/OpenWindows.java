package org.palpate.scene.window;

import com.jogamp.nativewindow.NativeWindowFactory;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;

/**
 * Closes the windows that are open when the process ends. The toolkit ends in a shutdown hook of
 * its own, beside the one that ends the session. If it finds a window then, it takes the window
 * away while its owner closes it, and prints the connections that are left open. Windows inside
 * another program's window are not closed here, because that program may wait in its own end. Any
 * thread.
 */
final class OpenWindows {
  private static final Set<SceneWindow> OPEN = ConcurrentHashMap.newKeySet();

  static {
    NativeWindowFactory.addCustomShutdownHook(true, () -> OPEN.forEach(SceneWindow::closeAtEnd));
  }

  private OpenWindows() {}

  /** Notes that a window is shown. */
  static void add(SceneWindow window) {
    OPEN.add(window);
  }

  /** Notes that a window was closed. */
  static void remove(SceneWindow window) {
    OPEN.remove(window);
  }
}
