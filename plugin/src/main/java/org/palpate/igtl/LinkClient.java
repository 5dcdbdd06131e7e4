package org.palpate.igtl;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.net.Socket;
import java.time.Instant;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;

/**
 * One connection: a thread that reads the client's messages and one that writes to it.
 *
 * <p>The newest update replaces an older one that a slow client has not taken yet, so that memory
 * and delay stay bounded. {@link #offer} never waits.
 */
final class LinkClient {
  private static final int MAX_REPLIES = 16;
  private static final long POLL_MILLIS = 100;

  /** The longest time that the last reply to a client that is disconnected may take. */
  private static final long LAST_REPLY_MILLIS = 1000;

  /** One update of the state; not changed once made. */
  static final class Update {
    private final byte[] state;
    private final byte[] landmarks;
    private final long landmarksVersion;

    /**
     * Creates an update that keeps the arrays.
     *
     * @param state messages that a later update makes obsolete
     * @param landmarks messages that are sent if the client does not have this version yet
     * @param landmarksVersion the version of the landmarks, from 1; 0 if there were none so far, so
     *     that nothing is sent
     */
    Update(byte[] state, byte[] landmarks, long landmarksVersion) {
      this.state = state;
      this.landmarks = landmarks;
      this.landmarksVersion = landmarksVersion;
    }
  }

  private final Socket socket;
  private final LinkListener listener;
  private final long maxImageBytes;
  private final Consumer<LinkClient> onClose;
  private final AtomicReference<Update> newest = new AtomicReference<>();
  private final BlockingQueue<byte[]> replies = new ArrayBlockingQueue<>(MAX_REPLIES);
  private final Thread reader;
  private final Thread writer;

  /** Signals that there is something to write; it holds at most one signal. */
  private final BlockingQueue<Boolean> signal = new ArrayBlockingQueue<>(1);

  /** Whether the writer ends after the replies that wait. */
  private volatile boolean ending;

  private volatile boolean closed;

  LinkClient(
      Socket socket, LinkListener listener, long maxImageBytes, Consumer<LinkClient> onClose) {
    this.socket = socket;
    this.listener = listener;
    this.maxImageBytes = maxImageBytes;
    this.onClose = onClose;
    reader = new Thread(this::readAll, "palpate-igtl-read");
    writer = new Thread(this::writeAll, "palpate-igtl-write");
    reader.setDaemon(true);
    writer.setDaemon(true);
  }

  void start() {
    reader.start();
    writer.start();
  }

  /** Replaces the update that is to be written next. Server thread; never waits. */
  void offer(Update update) {
    newest.set(update);
    signal.offer(Boolean.TRUE);
  }

  private void writeAll() {
    long landmarksSent = 0;
    try {
      OutputStream out = socket.getOutputStream();
      while (!closed) {
        signal.poll(POLL_MILLIS, TimeUnit.MILLISECONDS);
        for (byte[] reply = replies.poll(); reply != null; reply = replies.poll()) {
          out.write(reply);
        }
        Update update = newest.getAndSet(null);
        if (update != null) {
          if (update.landmarksVersion != landmarksSent) {
            out.write(update.landmarks);
            landmarksSent = update.landmarksVersion;
          }
          out.write(update.state);
        }
        if (ending && replies.isEmpty()) {
          return;
        }
      }
    } catch (IOException e) {
      close(); // the client is gone; the reader says so
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      close();
    }
  }

  private void readAll() {
    String reason = "";
    try {
      MessageReader in =
          new MessageReader(new BufferedInputStream(socket.getInputStream()), maxImageBytes);
      for (Message message = in.read(); message != null && !closed; message = in.read()) {
        answer(message);
      }
    } catch (LinkProtocolException e) {
      reason = ": " + e.getMessage();
      reply(MessageWriter.STATUS_ILLEGAL, e.getMessage());
      awaitLastReply();
    } catch (IOException e) {
      reason = closed ? "" : ": " + e.getMessage();
    }
    if (!closed) {
      listener.print("OpenIGTLink: a client disconnected" + reason);
    }
    close();
  }

  private void answer(Message message) {
    switch (message.header().type()) {
      case ReceivedImage.TYPE -> receiveImage(message);
      case ReceivedTransform.TYPE -> receiveTransform(message);
      case "GET_STATUS" -> reply(MessageWriter.STATUS_OK, "");
      default -> {} // other messages have no effect here
    }
  }

  /** Receives an image. A fault of its content costs that image, not the connection. */
  private void receiveImage(Message message) {
    String fault;
    try {
      fault = listener.received(ReceivedImage.parse(message));
    } catch (LinkProtocolException e) {
      fault = e.getMessage();
    }
    if (fault.isEmpty()) {
      reply(MessageWriter.STATUS_OK, "");
    } else {
      listener.print("OpenIGTLink: an image was not taken: " + fault);
      reply(MessageWriter.STATUS_ILLEGAL, fault);
    }
  }

  /**
   * Receives a transform. Only one that is not accepted is answered, because a client may send many
   * a second.
   */
  private void receiveTransform(Message message) {
    String fault;
    try {
      fault = listener.received(ReceivedTransform.parse(message));
    } catch (LinkProtocolException e) {
      fault = e.getMessage();
    }
    if (!fault.isEmpty()) {
      reply(MessageWriter.STATUS_ILLEGAL, fault);
    }
  }

  private void reply(int code, String text) {
    MessageWriter message = new MessageWriter();
    message.setTime(Instant.now());
    message.status(LinkServer.DEVICE_NAME, code, text.isEmpty() ? "" : "InvalidMessage", text);
    replies.offer(message.take()); // a client that reads no replies loses them
    signal.offer(Boolean.TRUE);
  }

  /** Lets the writer send the last reply before the connection is closed. */
  private void awaitLastReply() {
    ending = true;
    signal.offer(Boolean.TRUE);
    try {
      writer.join(LAST_REPLY_MILLIS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Closes the connection. Any thread, any number of times. */
  void close() {
    if (!closed) {
      closed = true;
      try {
        socket.close();
      } catch (IOException e) {
        listener.print("OpenIGTLink: a connection did not close: " + e.getMessage());
      }
      onClose.accept(this);
    }
  }
}
