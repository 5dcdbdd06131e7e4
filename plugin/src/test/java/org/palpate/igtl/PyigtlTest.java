package org.palpate.igtl;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.URISyntaxException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.palpate.geometry.Vec3;

/**
 * A client that others wrote: pyigtl from PyPI, run by the Python that {@code -Dpalpate.python}
 * names, else by {@code python3}. Skipped if there is no such Python or it has no pyigtl. {@code
 * -Dpalpate.igtlSeconds} sets how long poses are received.
 */
@Timeout(200)
class PyigtlTest {
  private static final String PYTHON = System.getProperty("palpate.python", "python3");
  private static final String SECONDS = System.getProperty("palpate.igtlSeconds", "2");
  private static final int WITHOUT_PYIGTL = 3;

  private final BlockingQueue<ReceivedImage> images = new LinkedBlockingQueue<>();
  private final BlockingQueue<ReceivedTransform> transforms = new LinkedBlockingQueue<>();
  private final AtomicLong updates = new AtomicLong();

  private void fill(LinkState state) {
    state.tool.origin().set(1.5, 2, (double) updates.incrementAndGet());
    state.landmarks = List.of(new LinkState.Landmark("nasion", new Vec3(1, 2, 3)));
  }

  private LinkServer server() throws IOException {
    LinkListener listener =
        new LinkListener() {
          @Override
          public String received(ReceivedImage image) {
            images.add(image);
            return "";
          }

          @Override
          public String received(ReceivedTransform transform) {
            transforms.add(transform);
            return "";
          }

          @Override
          public void print(String line) {
            // a client that disconnects at its end is no fault
          }
        };
    return new LinkServer(InetAddress.getLoopbackAddress(), 0, this::fill, listener);
  }

  @Test
  void receivesRisingPosesAndSendsLabels() throws Exception {
    try (LinkServer server = server()) {
      server.start();
      Map<String, String> facts = runClient(server.port());
      System.out.println("pyigtl: " + facts.get("rate") + " poses a second");
      assertTrue(Integer.parseInt(facts.get("poses")) > 1, facts::toString);
      assertEquals("1", facts.get("rising"), facts::toString);
      assertEquals("1.5", facts.get("x"));
      for (int version = 1; version <= 2; version++) {
        ReceivedImage image = images.poll(20, TimeUnit.SECONDS);
        assertEquals("labels", image.name());
        assertEquals(23, image.value(23));
        assertEquals(-0.75, image.stepY().y);
      }
      ReceivedTransform moved = transforms.poll(20, TimeUnit.SECONDS);
      assertEquals("fragment 2", moved.name());
      assertEquals(1, moved.pose().axisX().y);
      assertEquals(30, moved.pose().origin().z);
    }
  }

  private static Map<String, String> runClient(int port)
      throws IOException, InterruptedException, URISyntaxException {
    Path script = Path.of(PyigtlTest.class.getResource("client.py").toURI());
    Process process = start(script, port);
    String output = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    int exit = process.waitFor();
    Assumptions.assumeTrue(exit != WITHOUT_PYIGTL, "pyigtl is not installed");
    assertEquals(0, exit, output);
    Map<String, String> facts = new HashMap<>();
    output.lines().map(line -> line.split(" ", 2)).forEach(fact -> facts.put(fact[0], fact[1]));
    return facts;
  }

  private static Process start(Path script, int port) {
    try {
      return new ProcessBuilder(PYTHON, script.toString(), Integer.toString(port), SECONDS)
          .redirectErrorStream(true)
          .start();
    } catch (IOException e) {
      Assumptions.abort("there is no " + PYTHON);
      throw new AssertionError(e);
    }
  }
}
