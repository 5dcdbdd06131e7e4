package org.palpate.igtl;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;

class Crc64Test {
  @Test
  void agreesWithTheCheckValueOfTheCatalogue() {
    assertEquals(0x6c40df5f0b497347L, Crc64.of("123456789".getBytes(StandardCharsets.US_ASCII)));
  }

  @Test
  void ofNothingIsZero() {
    assertEquals(0, Crc64.of(new byte[0]));
  }
}
