package org.palpate.scene;

/**
 * Colours, 0xRRGGBB, that people with any colour vision can distinguish.
 *
 * <p>Source: Okabe and Ito, Color universal design (2008), for all except the spring.
 */
public final class Palette {
  public static final int SKY_BLUE = 0x56b4e9;
  public static final int ORANGE = 0xe69f00;
  public static final int BLUISH_GREEN = 0x009e73;
  public static final int REDDISH_PURPLE = 0xcc79a7;
  public static final int YELLOW = 0xf0e442;
  public static final int BLUE = 0x0072b2;
  public static final int VERMILION = 0xd55e00;

  public static final int DEVICE = SKY_BLUE;
  public static final int POINT = ORANGE;
  public static final int FORCE = VERMILION;
  public static final int TORQUE = VERMILION;
  public static final int TOOL = BLUISH_GREEN;
  public static final int CONTACT = YELLOW;
  public static final int TRAIL = YELLOW;
  public static final int LANDMARK = REDDISH_PURPLE;
  public static final int SPRING = 0x9fb4c8;

  private Palette() {}
}
