package org.palpate.scene;

import java.io.IOException;
import java.net.StandardProtocolFamily;
import java.net.UnixDomainSocketAddress;
import java.nio.channels.SocketChannel;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Assumptions;

/**
 * A display for tests: the one that is there, or Xvfb on the number that the build put into the
 * environment, started by the first test that needs it.
 */
final class TestDisplay {
  private static final long PATIENCE_NANOS = TimeUnit.SECONDS.toNanos(20);

  private static Process server;

  private TestDisplay() {}

  /** Skips the test where there is no display and no Xvfb. */
  static synchronized void require() {
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
    try {
      server =
          new ProcessBuilder(
                  "Xvfb",
                  display,
                  "-screen",
                  "0",
                  "1280x1024x24",
                  "+extension",
                  "GLX",
                  "-nolisten",
                  "tcp")
              .redirectErrorStream(true)
              .redirectOutput(ProcessBuilder.Redirect.DISCARD)
              .start();
      Runtime.getRuntime().addShutdownHook(new Thread(server::destroy));
      return true;
    } catch (IOException e) {
      return false;
    }
  }
}
