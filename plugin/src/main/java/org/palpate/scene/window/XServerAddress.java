package org.palpate.scene.window;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.UnixDomainSocketAddress;
import java.nio.channels.SocketChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * The address of an X server, as DISPLAY names it. Immutable.
 *
 * @param host the machine; empty for this one
 * @param number the number of the display
 */
record XServerAddress(String host, int number) {
  private static final Pattern FORM = Pattern.compile("([^:]*):([0-9]{1,5})(\\.[0-9]+)?");
  private static final int FIRST_PORT = 6000;
  private static final int MAX_NUMBER = 65_535 - FIRST_PORT;
  private static final int CONNECT_MILLIS = 2000;
  private static final Path ABSTRACT_SOCKETS = Path.of("/proc/net/unix");

  /** Parses the value of DISPLAY; empty if it has another form. */
  static Optional<XServerAddress> parse(String display) {
    Matcher parts = FORM.matcher(display.strip());
    if (!parts.matches() || Integer.parseInt(parts.group(2)) > MAX_NUMBER) {
      return Optional.empty();
    }
    String host = parts.group(1).equals("unix") ? "" : parts.group(1);
    return Optional.of(new XServerAddress(host, Integer.parseInt(parts.group(2))));
  }

  /** Whether a server accepts connections there. It may still refuse this user. */
  boolean answers() {
    return host.isEmpty() ? answersHere() : answersByTcp();
  }

  private boolean answersHere() {
    Path socket = Path.of("/tmp/.X11-unix/X" + number);
    try (SocketChannel connection = SocketChannel.open(UnixDomainSocketAddress.of(socket))) {
      return connection.isConnected();
    } catch (IOException e) {
      return isAbstract("@" + socket); // such a socket has no file
    }
  }

  /** Whether a server listens at a socket without a file, which Linux calls abstract. */
  private static boolean isAbstract(String name) {
    try (Stream<String> lines = Files.lines(ABSTRACT_SOCKETS)) {
      return lines.anyMatch(line -> line.endsWith(" " + name));
    } catch (IOException e) {
      return false;
    }
  }

  private boolean answersByTcp() {
    try (Socket connection = new Socket()) {
      connection.connect(new InetSocketAddress(host, FIRST_PORT + number), CONNECT_MILLIS);
      return true;
    } catch (IOException e) {
      return false;
    }
  }
}
