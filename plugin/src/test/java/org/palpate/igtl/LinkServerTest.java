package org.palpate.igtl;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;

/** A server with clients made of plain sockets. */
@Timeout(60)
class LinkServerTest {
  private static final long MAX_IMAGE_BYTES = 1 << 20;
  private static final int PATIENCE_S = 30;

  private final BlockingQueue<ReceivedImage> images = new LinkedBlockingQueue<>();
  private final BlockingQueue<ReceivedTransform> transforms = new LinkedBlockingQueue<>();
  private final List<String> lines = Collections.synchronizedList(new ArrayList<>());
  private final AtomicLong reads = new AtomicLong();
  private volatile List<LinkState.Landmark> landmarks = List.of();
  private volatile String answer = "";
  private LinkServer server;

  @BeforeEach
  void start() throws IOException {
    LinkListener listener =
        new LinkListener() {
          @Override
          public String received(ReceivedImage image) {
            images.add(image);
            return answer;
          }

          @Override
          public String received(ReceivedTransform transform) {
            transforms.add(transform);
            return answer;
          }

          @Override
          public void print(String line) {
            lines.add(line);
          }
        };
    server = new LinkServer(InetAddress.getLoopbackAddress(), 0, this::fill, listener);
    server.start();
  }

  private void fill(LinkState state) {
    long n = reads.incrementAndGet();
    state.tool.origin().set(1, 2, (double) n);
    state.device.origin().set(4, 5, 6);
    state.force.set(0.5, -0.25, 8);
    state.contact = true;
    RigidTransform pose = RigidTransform.identity();
    pose.origin().set(7, 8, 9);
    state.bodies = List.of(new LinkState.NamedPose("fragment 2", pose));
    state.landmarks = landmarks;
  }

  @AfterEach
  void stop() {
    server.close();
  }

  private Socket connect() throws IOException {
    return new Socket(InetAddress.getLoopbackAddress(), server.port());
  }

  private static MessageReader reader(Socket socket) throws IOException {
    return new MessageReader(socket.getInputStream(), MAX_IMAGE_BYTES);
  }

  private static Message next(MessageReader in, String deviceName) throws IOException {
    Message message = in.read();
    while (!message.header().deviceName().equals(deviceName)) {
      message = in.read();
    }
    return message;
  }

  private static Message status(MessageReader in) throws IOException {
    Message message = in.read();
    while (!message.header().type().equals("STATUS")) {
      message = in.read();
    }
    return message;
  }

  @Test
  void streamsPosesForceAndContact() throws IOException {
    try (Socket socket = connect()) {
      MessageReader in = reader(socket);
      Message tool = next(in, "PalpateTool");
      assertEquals("TRANSFORM", tool.header().type());
      assertEquals(1f, tool.content().getFloat(0)); // the identity's first element
      assertEquals(1f, tool.content().getFloat(36));
      assertEquals(2f, tool.content().getFloat(40));
      assertEquals(5f, next(in, "PalpateDevice").content().getFloat(40));
      assertEquals(9f, next(in, "fragment 2").content().getFloat(44));
      Message force = next(in, "PalpateForce");
      assertEquals(3, force.content().get(0));
      assertEquals(0x02c4_0000_0000_0000L, force.content().getLong(2));
      assertEquals(-0.25, force.content().getDouble(18));
      assertEquals(1.0, next(in, "PalpateContact").content().getDouble(10));
    }
  }

  @Test
  void eachClientGetsTheLandmarksOnceAndAfterEachChange() throws IOException {
    landmarks = List.of(new LinkState.Landmark("nasion", new Vec3(1, 2, 3)));
    try (Socket socket = connect()) {
      MessageReader in = reader(socket);
      Message first = next(in, "PalpateLandmarks");
      assertEquals(136, first.content().remaining());
      assertEquals("nasion", MessageHeader.text(first.content().slice(), 64));
      assertEquals(2f, first.content().getFloat(104));
      for (int n = 0; n < 20; n++) {
        assertFalse(in.read().header().deviceName().equals("PalpateLandmarks"));
      }
      landmarks = List.of();
      assertEquals(0, next(in, "PalpateLandmarks").content().remaining());
    }
  }

  @Test
  void noPointsAreSentAsLongAsThereIsNoLandmark() throws IOException {
    try (Socket socket = connect()) {
      MessageReader in = reader(socket);
      for (int n = 0; n < 20; n++) {
        assertFalse(in.read().header().type().equals("POINT"));
      }
    }
  }

  @Test
  void anImageIsReceivedAndAnswered() throws IOException, InterruptedException {
    try (Socket socket = connect()) {
      socket.getOutputStream().write(Recorded.IMAGE);
      ReceivedImage image = images.poll(PATIENCE_S, TimeUnit.SECONDS);
      assertEquals(24, image.voxels());
      assertEquals(1, status(reader(socket)).content().getShort(0));
    }
  }

  @Test
  void anImageThatIsNotTakenCostsNoConnection() throws IOException {
    answer = "the scan has other sizes";
    try (Socket socket = connect()) {
      socket.getOutputStream().write(Recorded.IMAGE);
      MessageReader in = reader(socket);
      Message status = status(in);
      assertEquals(12, status.content().getShort(0));
      byte[] text = new byte[answer.length()];
      status.content().get(30, text);
      assertArrayEquals(answer.getBytes(StandardCharsets.US_ASCII), text);
      assertEquals("TRANSFORM", next(in, "PalpateTool").header().type());
    }
  }

  @Test
  void aTransformIsReceivedAndAnsweredOnlyIfItIsNotAccepted() throws Exception {
    try (Socket socket = connect()) {
      RigidTransform pose =
          new RigidTransform(
              new Vec3(0, 1, 0), new Vec3(-1, 0, 0), new Vec3(0, 0, 1), new Vec3(10, -20, 30.5));
      MessageWriter out = new MessageWriter();
      out.transform("fragment 1", pose);
      socket.getOutputStream().write(out.take());
      ReceivedTransform received = transforms.poll(PATIENCE_S, TimeUnit.SECONDS);
      assertEquals("fragment 1", received.name());
      assertTrue(received.pose().sameBits(pose));

      pose.axisX().set(0, 1.01, 0);
      out.transform("scaled", pose);
      pose.axisX().set(0, -1, 0);
      out.transform("mirrored", pose);
      pose.axisX().set(0, 1, 0);
      pose.origin().x = Double.NaN;
      out.transform("nowhere", pose);
      socket.getOutputStream().write(out.take());
      MessageReader in = reader(socket);
      for (int n = 0; n < 3; n++) {
        assertEquals(12, status(in).content().getShort(0));
      }
      pose.origin().x = 0;
      answer = "it is held";
      out.transform("fragment 3", pose);
      socket.getOutputStream().write(out.take());
      assertEquals(12, status(in).content().getShort(0));
      assertEquals("fragment 3", transforms.poll(PATIENCE_S, TimeUnit.SECONDS).name());
    }
  }

  @Test
  void garbageCostsItsSenderAlone() throws IOException {
    try (Socket good = connect();
        Socket bad = connect()) {
      byte[] garbage = new byte[200];
      Arrays.fill(garbage, (byte) 0x5a);
      bad.getOutputStream().write(garbage);
      MessageReader in = reader(bad);
      assertEquals(12, status(in).content().getShort(0));
      while (readOrEnd(in)) {
        assertTrue(true); // what was on its way
      }
      assertEquals("TRANSFORM", next(reader(good), "PalpateTool").header().type());
    }
  }

  private static boolean readOrEnd(MessageReader in) {
    try {
      return in.read() != null;
    } catch (IOException e) {
      return false;
    }
  }

  @Test
  void aClientThatReadsNothingLosesUpdatesAndCostsTheOthersNone() throws IOException {
    try (Socket stalled = connect();
        Socket good = connect()) {
      assertTrue(stalled.isConnected());
      MessageReader in = reader(good);
      Set<Float> seen = new HashSet<>();
      for (int n = 0; n < 120; n++) {
        seen.add(next(in, "PalpateTool").content().getFloat(44));
      }
      assertEquals(120, seen.size());
    }
  }

  @Test
  void closingEndsEveryThreadAndConnection() throws IOException {
    try (Socket socket = connect()) {
      MessageReader in = reader(socket);
      next(in, "PalpateTool");
      server.close();
      while (readOrEnd(in)) {
        assertTrue(true); // what was on its way
      }
      long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_S);
      while (!threads().isEmpty() && System.nanoTime() < end) {
        Thread.onSpinWait();
      }
      assertEquals(List.of(), threads());
      assertEquals(0, server.clients());
    }
  }

  private static List<String> threads() {
    return Thread.getAllStackTraces().keySet().stream()
        .map(Thread::getName)
        .filter(name -> name.startsWith("palpate-igtl"))
        .toList();
  }
}
