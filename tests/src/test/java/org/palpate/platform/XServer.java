package org.palpate.platform;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Assumptions;

/** An X server for a test, on a free display number; {@link #close} ends it. */
public final class XServer implements AutoCloseable {
  private final Process process;
  private final String display;

  private XServer(Process process, String display) {
    this.process = process;
    this.display = display;
  }

  /** Starts a server, or skips the test if there is no Xvfb. */
  public static XServer start() throws IOException {
    Process process = null;
    try {
      process =
          new ProcessBuilder(
                  "Xvfb",
                  "-displayfd",
                  "1",
                  "-screen",
                  "0",
                  "1600x1000x24",
                  "+extension",
                  "GLX",
                  "-nolisten",
                  "tcp")
              .redirectError(ProcessBuilder.Redirect.DISCARD)
              .start();
    } catch (IOException e) {
      Assumptions.assumeTrue(false, "skipped: there is no Xvfb");
    }
    BufferedReader reader =
        new BufferedReader(
            new InputStreamReader(process.getInputStream(), StandardCharsets.US_ASCII));
    String number = reader.readLine();
    if (number == null) {
      throw new IOException("Xvfb ended without naming a display");
    }
    return new XServer(process, ":" + number.strip());
  }

  /** Returns the display, such as {@code :5}. */
  public String display() {
    return display;
  }

  @Override
  public void close() {
    process.destroy();
  }
}
