package org.palpate.scene;

import java.util.Locale;

/** Modes of stereo. */
public enum Stereo {
  /** One picture for both eyes. */
  OFF,
  /** Left eye in red, right eye in cyan, for coloured glasses. */
  ANAGLYPH,
  /** Two pictures side by side, the left one for the left eye. */
  SIDE_BY_SIDE,
  /** Two back buffers, if the driver has them. */
  QUAD_BUFFER;

  /** Returns the name on the command line. */
  @Override
  public String toString() {
    return name().toLowerCase(Locale.ROOT).replace('_', '-');
  }
}
