package org.palpate.igtl;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.time.Instant;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.locks.LockSupport;

/**
 * An OpenIGTLink server that streams a session and accepts images and poses of bodies.
 *
 * <p>Sent up to 60 times a second, with the header of version 1:
 *
 * <ul>
 *   <li>TRANSFORM {@code PalpateTool} and {@code PalpateDevice}: the poses of tool and device.
 *   <li>TRANSFORM with the name of a body: its pose, for each body that can move.
 *   <li>SENSOR {@code PalpateForce} (N), {@code PalpateTorque} (N mm) and {@code PalpateContact} (0
 *       or 1).
 *   <li>POINT {@code PalpateLandmarks}: all landmarks, to each client once and after each change.
 * </ul>
 *
 * <p>Accepted, with headers of version 1 to 3: IMAGE and TRANSFORM, which the listener gets, and
 * GET_STATUS. Other types are read and ignored. A message with a fault is answered by a STATUS.
 *
 * <p>The server runs on threads of its own and shares nothing with the haptic thread but what its
 * {@link LinkSource} reads. A slow client loses updates. Any thread may close the server.
 *
 * <p>Reference: Tokuda et al. 2009, OpenIGTLink, and the protocol's version 3 specification.
 */
public final class LinkServer implements AutoCloseable {
  /** The rate of the updates, Hz. */
  public static final double RATE_HZ = 60;

  /** The device name of messages that belong to no device. */
  static final String DEVICE_NAME = "Palpate";

  private static final long PERIOD_NANOS = Math.round(1e9 / RATE_HZ);

  /** The most clients at a time; a further one is disconnected at once. */
  private static final int MAX_CLIENTS = 8;

  /** The largest image is this fraction of the heap, because it is copied while it is read. */
  private static final int HEAP_FRACTION = 8;

  private static final long JOIN_MILLIS = 1000;

  private final ServerSocket socket;
  private final LinkSource source;
  private final LinkListener listener;
  private final List<LinkClient> clients = new CopyOnWriteArrayList<>();

  // The sender's thread alone uses these.
  private final MessageWriter writer = new MessageWriter();
  private List<LinkState.Landmark> landmarks = List.of();
  private byte[] landmarkMessage = new byte[0];
  private long landmarksVersion;

  private final Thread acceptor;
  private final Thread sender;
  private volatile boolean closed;

  /**
   * Binds the server to an address. {@link #start} lets clients in.
   *
   * @param address the address to listen on; the loopback address keeps other machines out
   * @param port the port, or 0 for any free one
   * @throws IOException if the port cannot be bound
   */
  public LinkServer(InetAddress address, int port, LinkSource source, LinkListener listener)
      throws IOException {
    this.source = source;
    this.listener = listener;
    socket = new ServerSocket();
    socket.setReuseAddress(true);
    try {
      socket.bind(new InetSocketAddress(address, port));
    } catch (IOException e) {
      socket.close();
      throw e;
    }
    acceptor = new Thread(this::acceptAll, "palpate-igtl-accept");
    sender = new Thread(this::sendAll, "palpate-igtl-send");
    acceptor.setDaemon(true);
    sender.setDaemon(true);
  }

  /** Starts the server's threads. Call it once. */
  public void start() {
    acceptor.start();
    sender.start();
  }

  /** Returns the port that the server listens on. */
  public int port() {
    return socket.getLocalPort();
  }

  /** Returns the number of clients. */
  public int clients() {
    return clients.size();
  }

  private void acceptAll() {
    while (!closed) {
      try {
        accept(socket.accept());
      } catch (IOException e) {
        if (!closed) {
          listener.print("OpenIGTLink: a client could not connect: " + e.getMessage());
        }
      }
    }
  }

  private void accept(Socket connection) throws IOException {
    if (clients.size() >= MAX_CLIENTS) {
      listener.print("OpenIGTLink: more than " + MAX_CLIENTS + " clients; one was disconnected");
      connection.close();
      return;
    }
    connection.setTcpNoDelay(true);
    long maxImageBytes = Runtime.getRuntime().maxMemory() / HEAP_FRACTION;
    LinkClient client = new LinkClient(connection, listener, maxImageBytes, clients::remove);
    clients.add(client);
    client.start();
    if (closed) {
      client.close();
    }
  }

  /** Sends updates at fixed times. A late update is not followed by extra ones. */
  private void sendAll() {
    LinkState state = new LinkState();
    long due = System.nanoTime();
    while (!closed) {
      due = Math.max(due + PERIOD_NANOS, System.nanoTime() - PERIOD_NANOS);
      awaitTime(due);
      source.read(state);
      LinkClient.Update update = update(state);
      clients.forEach(client -> client.offer(update));
    }
  }

  private void awaitTime(long nanos) {
    long remaining = nanos - System.nanoTime();
    while (remaining > 0 && !closed) {
      LockSupport.parkNanos(this, remaining);
      remaining = nanos - System.nanoTime();
    }
  }

  private LinkClient.Update update(LinkState state) {
    writer.setTime(Instant.now());
    if (!state.landmarks.equals(landmarks)) {
      landmarks = state.landmarks;
      landmarksVersion++;
      writer.points("PalpateLandmarks", landmarks);
      landmarkMessage = writer.take();
    }
    return new LinkClient.Update(encode(state), landmarkMessage, landmarksVersion);
  }

  private byte[] encode(LinkState state) {
    writer.transform("PalpateTool", state.tool);
    writer.transform("PalpateDevice", state.device);
    for (LinkState.NamedPose body : state.bodies) {
      writer.transform(body.name(), body.pose());
    }
    writer.sensor(
        "PalpateForce", MessageWriter.UNIT_NEWTON, state.force.x, state.force.y, state.force.z);
    writer.sensor(
        "PalpateTorque",
        MessageWriter.UNIT_NEWTON_MM,
        state.torque.x,
        state.torque.y,
        state.torque.z);
    writer.sensor("PalpateContact", MessageWriter.UNIT_NONE, state.contact ? 1 : 0);
    return writer.take();
  }

  /** Closes all connections and ends the threads. Any number of times. */
  @Override
  public void close() {
    closed = true;
    try {
      socket.close();
    } catch (IOException e) {
      listener.print("OpenIGTLink: the port did not close: " + e.getMessage());
    }
    clients.forEach(LinkClient::close);
    LockSupport.unpark(sender);
    join(acceptor);
    join(sender);
  }

  private static void join(Thread thread) {
    try {
      if (thread != Thread.currentThread()) {
        thread.join(JOIN_MILLIS);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
