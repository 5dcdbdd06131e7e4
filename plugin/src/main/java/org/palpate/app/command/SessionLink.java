package org.palpate.app.command;

import java.io.IOException;
import java.io.PrintWriter;
import java.net.InetSocketAddress;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.palpate.app.process.PalpateException;
import org.palpate.geometry.Pose;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.host.SessionReader;
import org.palpate.host.TouchSession;
import org.palpate.igtl.LinkListener;
import org.palpate.igtl.LinkServer;
import org.palpate.igtl.LinkState;
import org.palpate.igtl.ReceivedImage;
import org.palpate.igtl.ReceivedTransform;
import org.palpate.scene.NamedPoint;
import org.palpate.scene.WorldAxes;

/**
 * Connects sessions with an OpenIGTLink server: streams each one, and takes the images and poses
 * that clients send. The server outlives a session, so that a client stays connected when the scan
 * changes.
 *
 * <p>Any thread.
 */
final class SessionLink implements LinkListener, AutoCloseable {
  /** The session that the server streams at present. */
  private record Streamed(
      TouchSession session,
      SessionReader reader,
      WorldAxes axes,
      Supplier<List<NamedPoint>> landmarks,
      Runnable stop) {}

  private final LinkServer server;
  private final boolean recorded;
  private final PrintWriter out;
  private volatile Streamed streamed;
  private ReceivedVolume received;

  // The server's thread alone uses these.
  private List<NamedPoint> convertedFrom = List.of();
  private List<LinkState.Landmark> converted = List.of();

  /**
   * Binds the server and lets clients in.
   *
   * @param recorded whether the session is recorded, so that its scan has to stay
   * @throws PalpateException exit code 1, if the port cannot be bound
   */
  SessionLink(InetSocketAddress address, boolean recorded, PrintWriter out) {
    this.recorded = recorded;
    this.out = out;
    try {
      server = new LinkServer(address.getAddress(), address.getPort(), this::read, this);
    } catch (IOException e) {
      throw PalpateException.failed(
          "the port cannot be opened (" + e.getMessage() + ")",
          "--igtl " + address.getPort(),
          "choose another port",
          e);
    }
    server.start();
    print("OpenIGTLink: port " + server.port() + " at " + address.getAddress().getHostAddress());
  }

  /**
   * Streams a session from now on. If an image was received while its scan was loading, the session
   * ends at once, so that the image is touched next.
   *
   * @param session a session that has not started
   * @param axes the orientation of the session's world axes
   * @param landmarks the landmarks in world mm
   * @param stop ends the session when another scan was received
   */
  void stream(
      TouchSession session, WorldAxes axes, Supplier<List<NamedPoint>> landmarks, Runnable stop) {
    synchronized (this) {
      streamed = new Streamed(session, session.secondReader(), axes, landmarks, stop);
      if (received != null) {
        stop.run();
      }
    }
  }

  /** Streams nothing, until the next session. */
  void pause() {
    streamed = null;
  }

  /** Fills in the present state. The server's thread. */
  private void read(LinkState dest) {
    Streamed now = streamed;
    if (now != null) {
      now.reader().take();
      now.reader().tool(dest.tool);
      now.reader().device(dest.device);
      now.reader().force(dest.force);
      now.reader().torque(dest.torque);
      dest.contact = now.reader().contact();
      dest.bodies =
          now.reader().bodies().stream()
              .map(body -> new LinkState.NamedPose(body.name(), body.restToPresent()))
              .toList();
      dest.landmarks = landmarks(now);
      toRas(now.axes(), dest);
    }
  }

  /** Returns the landmarks in RAS. The list stays the same object until a landmark changes. */
  private List<LinkState.Landmark> landmarks(Streamed now) {
    List<NamedPoint> present = now.landmarks().get();
    if (!present.equals(convertedFrom)) {
      convertedFrom = present;
      converted =
          present.stream()
              .map(mark -> new LinkState.Landmark(mark.name(), toRas(now.axes(), mark.position())))
              .toList();
    }
    return converted;
  }

  private static void toRas(WorldAxes axes, LinkState state) {
    toRas(axes, state.tool);
    toRas(axes, state.device);
    state.bodies.forEach(body -> toRas(axes, body.pose()));
    flip(axes, state.force);
    // A torque is an axial vector: a reflection of the axes also changes its sign.
    flip(axes, state.torque);
    double determinant = sign(axes, 0) * sign(axes, 1);
    state.torque.mul(determinant, state.torque);
  }

  /** Turns a pose into RAS on both sides, so that the identity stays the identity. */
  private static void toRas(WorldAxes axes, RigidTransform pose) {
    scaled(axes, pose.axisX(), sign(axes, 0));
    scaled(axes, pose.axisY(), sign(axes, 1));
    scaled(axes, pose.axisZ(), 1);
    flip(axes, pose.origin());
  }

  private static void scaled(WorldAxes axes, Vec3 axis, double factor) {
    flip(axes, axis);
    axis.mul(factor, axis);
  }

  private static Vec3 toRas(WorldAxes axes, Vec3 world) {
    Vec3 ras = new Vec3().set(world);
    flip(axes, ras);
    return ras;
  }

  /** Changes a vector from world axes to right, anterior, superior. */
  private static void flip(WorldAxes axes, Vec3 vector) {
    vector.set(sign(axes, 0) * vector.x, sign(axes, 1) * vector.y, vector.z);
  }

  /** Returns 1 if the world's axis is that of RAS, and -1 if it is opposite. */
  private static double sign(WorldAxes axes, int axis) {
    Vec3 scene = axes.toSceneOrBack(new Vec3(1, 1, 1), new Vec3());
    return -(axis == 0 ? scene.x : scene.y); // the scene's x points left and its y to the back
  }

  /**
   * Keeps an image until the present session has ended, or its scan has been loaded. Of several
   * that arrive meanwhile the newest is touched.
   */
  @Override
  public String received(ReceivedImage image) {
    if (recorded) {
      return "the session is being recorded, and a recording is of one scan";
    }
    Optional<ReceivedVolume> volume = ReceivedVolume.of(image);
    if (volume.isEmpty()) {
      return "the axes of the image are not at right angles; resample it";
    }
    print(
        "OpenIGTLink: the image "
            + image.name()
            + " of "
            + image.sizeX()
            + "x"
            + image.sizeY()
            + "x"
            + image.sizeZ()
            + " voxels was received");
    keep(volume.get());
    return "";
  }

  /** Moves the body of the transform's name towards its pose. */
  @Override
  public String received(ReceivedTransform transform) {
    Streamed now = streamed;
    if (now != null) {
      toRas(now.axes(), transform.pose()); // the same change of axes leads back
      now.session().moveBody(transform.name(), new Pose().set(transform.pose()));
    }
    return "";
  }

  private synchronized void keep(ReceivedVolume next) {
    if (received != null) {
      print("OpenIGTLink: it replaces the " + received.sourceName() + ", which was not touched");
    }
    received = next;
    if (streamed != null) {
      streamed.stop().run();
    }
  }

  /** Takes the newest image that was received, if there is one. */
  synchronized Optional<ReceivedVolume> takeReceived() {
    Optional<ReceivedVolume> taken = Optional.ofNullable(received);
    received = null;
    return taken;
  }

  @Override
  public void print(String line) {
    synchronized (out) {
      out.println(line);
      out.flush();
    }
  }

  @Override
  public void close() {
    server.close();
  }
}
