package org.palpate.scene;

/**
 * Colours, 0xRRGGBB, that people with any colour sight tell apart. Source: Okabe and Ito, Color
 * universal design (2008), for all but bone.
 */
public final class Palette {
  public static final int BONE = 0xe9dcc0;
  public static final int DEVICE = 0x56b4e9;
  public static final int POINT = 0xe69f00;
  public static final int FORCE = 0xd55e00;
  public static final int TRAIL = 0xf0e442;
  public static final int LANDMARK = 0xcc79a7;
  public static final int SPRING = 0x9fb4c8;

  private static final int[] SEGMENTS = {
    BONE, 0x56b4e9, 0xe69f00, 0x009e73, 0xcc79a7, 0xf0e442, 0x0072b2
  };

  private Palette() {}

  /** A colour for the segment with a number, from 0; they come round. */
  public static int segment(int number) {
    return SEGMENTS[number % SEGMENTS.length];
  }
}
