package org.palpate.scene.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class XServerAddressTest {
  @Test
  void hostAndNumberAreThoseOfDisplay() {
    assertEquals(Optional.of(new XServerAddress("", 7)), XServerAddress.parse(":7"));
    assertEquals(Optional.of(new XServerAddress("", 0)), XServerAddress.parse("unix:0.0"));
    assertEquals(
        Optional.of(new XServerAddress("localhost", 10)), XServerAddress.parse("localhost:10.0"));
  }

  @Test
  void otherFormsAndNumbersWithoutAPortHaveNoAddress() {
    for (String display : new String[] {"", "7", "host", ":x", ":123456", "host:59536", ":-1"}) {
      assertEquals(Optional.empty(), XServerAddress.parse(display), display);
    }
  }

  @Test
  void aServerThatListensAnswersAndOneThatDoesNotDoesNot() throws IOException {
    InetAddress here = InetAddress.getLoopbackAddress();
    XServerAddress address;
    try (ServerSocket server = new ServerSocket(0, 1, here)) {
      address = new XServerAddress(here.getHostAddress(), server.getLocalPort() - 6000);
      assertTrue(address.answers());
    }
    assertFalse(address.answers());
    assertFalse(new XServerAddress("", 59_535).answers());
  }
}
