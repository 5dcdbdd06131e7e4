package org.palpate.app.options;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.InetSocketAddress;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class LinkOptionsTest {
  private static Optional<InetSocketAddress> address(String... arguments) {
    return Given.options(new LinkOptions(), arguments).address();
  }

  @Test
  void withoutTheOptionNothingIsServed() {
    assertEquals(Optional.empty(), address());
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 18944, 65535})
  void aPortAloneIsServedOnThisMachineOnly(int port) {
    InetSocketAddress served = address("--igtl=" + port).orElseThrow();
    assertEquals(port, served.getPort());
    assertTrue(served.getAddress().isLoopbackAddress());
    assertEquals(served, address("--igtl=:" + port).orElseThrow());
  }

  @Test
  void anAddressIsServedAsItWasWritten() throws Exception {
    InetSocketAddress all = address("--igtl=0.0.0.0:18944").orElseThrow();
    assertTrue(all.getAddress().isAnyLocalAddress());
    assertEquals(18944, all.getPort());
    InetSocketAddress six = address("--igtl=::1:500").orElseThrow();
    assertArrayEquals(
        new byte[] {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1}, six.getAddress().getAddress());
    assertEquals(500, six.getPort());
  }

  @ParameterizedTest
  @ValueSource(strings = {"65536", "-1", "", "localhost:", "1.5", "port", "123456", "127.0.0.1"})
  void anotherPortIsRefused(String text) {
    Given.refuses(
        "a port is a number from 0 to 65535: --igtl " + text + ": try --igtl 18944",
        () -> address("--igtl=" + text));
  }

  @Test
  void aHostThatNobodyHasIsRefused() {
    Given.refuses(
        "there is no address no.such.host.invalid: --igtl no.such.host.invalid:18944: try --igtl"
            + " 18944",
        () -> address("--igtl=no.such.host.invalid:18944"));
  }
}
