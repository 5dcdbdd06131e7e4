package org.palpate.scene.window;

import java.io.File;
import java.io.IOException;
import java.net.StandardProtocolFamily;
import java.net.UnixDomainSocketAddress;
import java.nio.channels.SocketChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Assumptions;

/**
 * A display for tests: the present one, or Xvfb on the number that the build sets in the
 * environment. The first test that needs Xvfb starts it.
 */
public final class TestDisplay {
  private static final long PATIENCE_NANOS = TimeUnit.SECONDS.toNanos(20);

  /**
   * A shell ends the server after this process has ended. An earlier end would kill this process,
   * which is its client.
   */
  private static final String SERVE =
      "Xvfb \"$1\" -screen 0 1280x1024x24 +extension GLX -nolisten tcp & server=$!;"
          + " while kill -0 \"$2\" 2>/dev/null && kill -0 $server 2>/dev/null; do sleep 1; done;"
          + " kill $server";

  private TestDisplay() {}

  /** Skips the test if there is no display and no Xvfb. */
  public static synchronized void require() {
    String display = System.getenv("DISPLAY");
    Assumptions.assumeTrue(
        display != null && display.startsWith(":"),
        "skipped: there is no display, DISPLAY is unset");
    String number = display.substring(1).split("\\.", 2)[0];
    if (!answers(number)) {
      Assumptions.assumeTrue(start(display), "skipped: there is no display and no Xvfb");
      long end = System.nanoTime() + PATIENCE_NANOS;
      while (!answers(number) && System.nanoTime() < end) {
        Thread.onSpinWait();
      }
      Assumptions.assumeTrue(answers(number), "skipped: Xvfb does not answer on " + display);
    }
  }

  private static boolean answers(String number) {
    Path socket = Path.of("/tmp/.X11-unix/X" + number);
    try (SocketChannel channel = SocketChannel.open(StandardProtocolFamily.UNIX)) {
      return channel.connect(UnixDomainSocketAddress.of(socket));
    } catch (IOException e) {
      return false;
    }
  }

  private static boolean start(String display) {
    if (!isInstalled()) {
      return false;
    }
    String process = Long.toString(ProcessHandle.current().pid());
    try {
      new ProcessBuilder("sh", "-c", SERVE, "serve", display, process)
          .redirectErrorStream(true)
          .redirectOutput(ProcessBuilder.Redirect.DISCARD)
          .start();
      return true;
    } catch (IOException e) {
      return false;
    }
  }

  private static boolean isInstalled() {
    return Arrays.stream(System.getenv("PATH").split(File.pathSeparator))
        .anyMatch(folder -> Files.isExecutable(Path.of(folder, "Xvfb")));
  }
}
