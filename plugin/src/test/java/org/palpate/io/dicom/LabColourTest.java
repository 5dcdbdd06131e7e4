package org.palpate.io.dicom;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class LabColourTest {
  @Test
  void whiteAndBlackHaveTheEndsOfLightness() {
    assertArrayEquals(new int[] {65535, 32896, 32896}, LabColour.ofRgb(0xFFFFFF));
    assertArrayEquals(new int[] {0, 32896, 32896}, LabColour.ofRgb(0));
  }

  @Test
  void everyGreyAndTheCornersOfTheCubeComeBack() {
    for (int grey = 0; grey < 256; grey++) {
      int rgb = grey << 16 | grey << 8 | grey;
      assertEquals(
          Integer.toHexString(rgb), Integer.toHexString(LabColour.toRgb(LabColour.ofRgb(rgb))));
    }
    for (int corner : new int[] {0xFF0000, 0x00FF00, 0x0000FF, 0xFFFF00, 0xFF00FF, 0x00FFFF}) {
      assertEquals(corner, LabColour.toRgb(LabColour.ofRgb(corner)));
    }
  }
}
