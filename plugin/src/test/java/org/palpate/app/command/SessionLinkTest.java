package org.palpate.app.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.DataInputStream;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.palpate.device.SimulatedDevice;
import org.palpate.geometry.Vec3;
import org.palpate.host.ContactScene;
import org.palpate.host.ContactSettings;
import org.palpate.host.SessionSettings;
import org.palpate.host.TouchSession;
import org.palpate.igtl.ReceivedImage;
import org.palpate.loop.LoopSettings;
import org.palpate.scene.NamedPoint;
import org.palpate.scene.WorldAxes;
import org.palpate.volume.phantom.Phantom;

/** A client watches a session. */
@Timeout(60)
class SessionLinkTest {
  private static final int HEADER_BYTES = 58;
  private static final int BODY_SIZE = 42;
  private static final int MESSAGES = 100;

  private final StringWriter printed = new StringWriter();

  @Test
  void landmarksAreSentOnceAndInRas() throws IOException {
    ContactScene scene =
        new ContactScene(Phantom.parse("sphere:16").segments(), ContactSettings.standard());
    LoopSettings loop = LoopSettings.ofRate(1000);
    SimulatedDevice device = new SimulatedDevice(1, scene.handTarget(), loop.periodNanos());
    List<NamedPoint> landmarks = List.of(new NamedPoint("nasion", new Vec3(1, 2, 3)));
    try (TouchSession session =
            new TouchSession(scene, device, SessionSettings.standard().withLoop(loop));
        SessionLink link = newLink()) {
      link.stream(session, WorldAxes.LPS, () -> landmarks, () -> {});
      int points = 0;
      try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), port())) {
        DataInputStream in = new DataInputStream(socket.getInputStream());
        for (int n = 0; n < MESSAGES; n++) {
          byte[] header = in.readNBytes(HEADER_BYTES);
          byte[] body = in.readNBytes((int) ByteBuffer.wrap(header).getLong(BODY_SIZE));
          if (new String(header, 2, 5, StandardCharsets.US_ASCII).equals("POINT")) {
            points++;
            assertEquals(-1f, ByteBuffer.wrap(body).getFloat(100));
            assertEquals(-2f, ByteBuffer.wrap(body).getFloat(104));
            assertEquals(3f, ByteBuffer.wrap(body).getFloat(108));
          }
        }
      }
      assertEquals(1, points);
    }
  }

  @Test
  void anImageThatArrivesWhileAnotherLoadsIsTouchedNext() {
    ContactScene scene =
        new ContactScene(Phantom.parse("sphere:16").segments(), ContactSettings.standard());
    LoopSettings loop = LoopSettings.ofRate(1000);
    SimulatedDevice device = new SimulatedDevice(1, scene.handTarget(), loop.periodNanos());
    AtomicInteger stops = new AtomicInteger();
    try (TouchSession session =
            new TouchSession(scene, device, SessionSettings.standard().withLoop(loop));
        SessionLink link = newLink()) {
      assertEquals("", link.received(image("first")));
      assertEquals("image first", link.takeReceived().orElseThrow().sourceName());
      // The first one is loading now.
      assertEquals("", link.received(image("second")));
      assertEquals("", link.received(image("third")));
      assertTrue(printed.toString().contains("replaces the image second"), printed.toString());
      link.stream(session, WorldAxes.RAS, () -> List.of(), stops::incrementAndGet);
      assertEquals(1, stops.get());
      link.pause();
      assertEquals("image third", link.takeReceived().orElseThrow().sourceName());
      assertEquals(Optional.empty(), link.takeReceived());
    }
  }

  private static ReceivedImage image(String name) {
    return new ReceivedImage(
        name,
        2,
        2,
        2,
        new Vec3(1, 0, 0),
        new Vec3(0, 1, 0),
        new Vec3(0, 0, 1),
        new Vec3(),
        ReceivedImage.Type.UINT8,
        ByteBuffer.allocate(8));
  }

  private SessionLink newLink() {
    return new SessionLink(
        new InetSocketAddress(InetAddress.getLoopbackAddress(), 0),
        false,
        new PrintWriter(printed, true));
  }

  private int port() {
    return Integer.parseInt(printed.toString().replaceFirst("(?s).*port (\\d+) at .*", "$1"));
  }
}
