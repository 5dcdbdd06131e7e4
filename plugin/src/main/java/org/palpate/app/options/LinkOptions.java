package org.palpate.app.options;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.UnknownHostException;
import java.util.Optional;
import org.palpate.app.process.PalpateException;
import picocli.CommandLine.Option;

/** The option that serves a session over OpenIGTLink. */
public final class LinkOptions {
  private static final int MAX_PORT = 65_535;
  private static final String NAME = "--igtl";
  private static final String PORT_RANGE = "a port is a number from 0 to 65535";

  @Option(
      names = NAME,
      paramLabel = "[ADDRESS:]PORT",
      description = {
        "Serves the session over OpenIGTLink at this port (18944 is usual): poses, force, contact"
            + " and landmarks. Only this machine can connect, unless an address of this machine is"
            + " given; 0.0.0.0 stands for all."
      })
  private String text;

  /**
   * Returns the address to serve at; empty without the option.
   *
   * @throws PalpateException exit code 2, if it is no address
   */
  public Optional<InetSocketAddress> address() {
    if (text == null) {
      return Optional.empty();
    }
    int colon = text.lastIndexOf(':');
    return Optional.of(
        new InetSocketAddress(host(text.substring(0, Math.max(0, colon))), port(colon)));
  }

  private InetAddress host(String name) {
    try {
      return name.isEmpty() ? InetAddress.getLoopbackAddress() : InetAddress.getByName(name);
    } catch (UnknownHostException e) {
      throw wrong("there is no address " + name);
    }
  }

  private int port(int colon) {
    String digits = text.substring(colon + 1);
    int port = digits.matches("[0-9]{1,5}") ? Integer.parseInt(digits) : -1;
    if (port < 0 || port > MAX_PORT) {
      throw wrong(PORT_RANGE);
    }
    return port;
  }

  private PalpateException wrong(String what) {
    return PalpateException.wrongUse(what, NAME + " " + text, "try " + NAME + " 18944");
  }
}
