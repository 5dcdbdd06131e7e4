package org.palpate.recording;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;

class WordRingTest {
  private final WordRing ring = new WordRing(3, 8);

  @Test
  void entriesAreReadInTheOrderInWhichTheyWereWritten() {
    long written = 0;
    long read = 0;
    for (int round = 0; round < 20; round++) {
      for (int n = 0; n < 1 + round % 3; n++) {
        write(written++);
      }
      assertEquals(written - read, ring.available());
      while (ring.available() > 0) {
        assertEquals(read, ring.get(ring.oldest()));
        assertEquals(-read, ring.get(ring.oldest() + 7));
        read++;
        ring.release();
      }
    }
    assertEquals(0, ring.overflows());
  }

  @Test
  void anEntryIsNotReadBeforeItIsPublished() {
    assertNotEquals(WordRing.FULL, ring.claim());
    assertEquals(0, ring.available());
    ring.publish();
    assertEquals(1, ring.available());
  }

  @Test
  void aFullBufferDropsTheNewestEntriesAndCountsThem() {
    for (int n = 0; n < 3; n++) {
      write(n);
    }
    assertEquals(WordRing.FULL, ring.claim());
    assertEquals(WordRing.FULL, ring.claim());
    assertEquals(2, ring.overflows());
    assertEquals(3, ring.available());
    assertEquals(0, ring.get(ring.oldest()));
    ring.release();
    write(9);
    ring.release();
    ring.release();
    assertEquals(9, ring.get(ring.oldest()));
  }

  @Test
  void posesAndVectorsKeepTheirBits() {
    Vec3 position = new Vec3(-0.0, Double.NaN, 1e-310);
    Quaternion orientation = new Quaternion().set(0.1, -0.2, 0.3, -0.4);
    int at = ring.claim();
    ring.set(at + 1, position, orientation);
    ring.publish();
    Vec3 readPosition = new Vec3();
    Quaternion readOrientation = new Quaternion();
    ring.get(ring.oldest() + 1, readPosition, readOrientation);
    assertTrue(position.sameBits(readPosition));
    assertTrue(orientation.sameBits(readOrientation));
  }

  @Test
  void moreWordsThanAnArrayHoldsAreRefused() {
    assertThrows(ArithmeticException.class, () -> new WordRing(1 << 30, 8));
  }

  private void write(long value) {
    int at = ring.claim();
    ring.set(at, value);
    ring.set(at + 7, -value);
    ring.publish();
  }
}
