package org.palpate.igtl;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.palpate.app.PalpateCommandLine;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;

/** A live session that a client watches, and to which it sends another scan. */
@Timeout(120)
class LinkedSessionTest {
  private static final int EDGE = 24;
  private static final int IMAGE_HEADER_BYTES = 72;

  private final ByteArrayOutputStream out = new ByteArrayOutputStream();

  private CompletableFuture<Integer> start(int port) {
    return start(port, "sphere:48");
  }

  private CompletableFuture<Integer> start(int port, String phantom) {
    PrintStream stream = new PrintStream(out, true, StandardCharsets.UTF_8);
    return CompletableFuture.supplyAsync(
        () ->
            new PalpateCommandLine(stream, stream)
                .run(
                    "touch",
                    "--phantom",
                    phantom,
                    "--headless",
                    "--seconds",
                    "4",
                    "--igtl",
                    Integer.toString(port)));
  }

  private static int freePort() throws IOException {
    try (ServerSocket socket = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      return socket.getLocalPort();
    }
  }

  private static Socket connect(int port) {
    Socket socket = null;
    while (socket == null) {
      try {
        socket = new Socket(InetAddress.getLoopbackAddress(), port);
      } catch (IOException e) {
        Thread.onSpinWait(); // the server is not there yet
      }
    }
    return socket;
  }

  private static Vec3 nextTool(MessageReader in) throws IOException {
    return nextPosition(in, "PalpateTool");
  }

  private static Vec3 nextPosition(MessageReader in, String name) throws IOException {
    Message message = in.read();
    while (!message.header().deviceName().equals(name)) {
      message = in.read();
    }
    ByteBuffer content = message.content();
    return new Vec3(content.getFloat(36), content.getFloat(40), content.getFloat(44));
  }

  /** Returns a label image of a cube that fills the middle of its volume, far from the origin. */
  private static byte[] image() {
    ByteBuffer body = ByteBuffer.allocate(IMAGE_HEADER_BYTES + EDGE * EDGE * EDGE);
    body.putShort((short) 1).put((byte) 1).put((byte) 3).put((byte) 1).put((byte) 1);
    for (int axis = 0; axis < 3; axis++) {
      body.putShort((short) EDGE);
    }
    float[] geometry = {1, 0, 0, 0, 1, 0, 0, 0, 1, 1000, 2000, 3000};
    for (float each : geometry) {
      body.putFloat(each);
    }
    body.putShort((short) 0).putShort((short) 0).putShort((short) 0);
    for (int axis = 0; axis < 3; axis++) {
      body.putShort((short) EDGE);
    }
    for (int voxel = 0; voxel < EDGE * EDGE * EDGE; voxel++) {
      int x = voxel % EDGE;
      int y = voxel / EDGE % EDGE;
      int z = voxel / (EDGE * EDGE);
      boolean solid = Math.min(x, Math.min(y, z)) > 6 && Math.max(x, Math.max(y, z)) < 17;
      body.put((byte) (solid ? 1 : 0));
    }
    ByteBuffer message = ByteBuffer.allocate(MessageHeader.BYTES + body.capacity());
    new MessageHeader(1, "IMAGE", "cube", 0, body.capacity(), Crc64.of(body.array()))
        .write(message);
    return message.put(body.array()).array();
  }

  @Test
  void streamsTheToolAndTouchesTheImageThatIsSent() throws Exception {
    int port = freePort();
    CompletableFuture<Integer> session = start(port);
    try (Socket socket = connect(port)) {
      MessageReader in = new MessageReader(socket.getInputStream(), 1 << 20);
      Vec3 tool = nextTool(in);
      while (tool.length() == 0) { // no frame yet
        tool = nextTool(in);
      }
      assertTrue(tool.length() < 200, tool::toString);

      socket.getOutputStream().write(image());
      while (tool.length() < 1000) {
        tool = nextTool(in);
      }
      Vec3 fromCentre = tool.sub(new Vec3(1000, 2000, 3000), new Vec3());
      assertTrue(fromCentre.length() < 100, tool::toString);
    }
    assertEquals(0, session.get(), () -> out.toString(StandardCharsets.UTF_8));
    String printed = out.toString(StandardCharsets.UTF_8);
    assertTrue(printed.contains("the image cube of 24x24x24 voxels was received"), printed);
    assertTrue(printed.contains("image cube, device simulated"), printed);
  }

  @Test
  void aTransformMovesTheFragmentOfItsName() throws Exception {
    int port = freePort();
    CompletableFuture<Integer> session = start(port, "fracture:64:3");
    try (Socket socket = connect(port)) {
      MessageReader in = new MessageReader(socket.getInputStream(), 1 << 20);
      String name = "fragment3";
      Vec3 start = nextPosition(in, name);
      RigidTransform goal = RigidTransform.identity();
      goal.origin().set(start.x + 40, start.y - 30, start.z + 200);
      MessageWriter message = new MessageWriter();
      message.transform("nobody", goal);
      message.transform(name, goal);
      socket.getOutputStream().write(message.take());
      double left = Double.POSITIVE_INFINITY;
      while (left > 1e-3) {
        left = goal.origin().sub(nextPosition(in, name), new Vec3()).length();
      }
    }
    assertEquals(0, session.get(), () -> out.toString(StandardCharsets.UTF_8));
  }

  @Test
  void aPortThatIsTakenIsOneLine() throws IOException {
    try (ServerSocket taken = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      int exitCode = start(taken.getLocalPort()).join();
      String line = out.toString(StandardCharsets.UTF_8).strip();
      assertEquals(1, exitCode, line);
      assertTrue(line.matches("palpate: the port cannot be opened .*: choose another port"), line);
    }
  }

  @Test
  void aWrongPortIsOneLine() {
    PrintStream stream = new PrintStream(out, true, StandardCharsets.UTF_8);
    int exitCode = new PalpateCommandLine(stream, stream).run("touch", "--igtl", "70000");
    assertEquals(2, exitCode);
    assertEquals(
        "palpate: a port is a number from 0 to 65535: --igtl 70000: try --igtl 18944",
        out.toString(StandardCharsets.UTF_8).strip());
  }
}
