package org.palpate.scene;

import java.util.Locale;

/** How two eyes are served. */
public enum Stereo {
  OFF,
  /** Left through red, right through cyan glasses. */
  ANAGLYPH,
  /** Two pictures beside each other, left for the left eye. */
  SIDE_BY_SIDE,
  /** Two back buffers, where the driver has them. */
  QUAD_BUFFER;

  /** As a person types it. */
  @Override
  public String toString() {
    return name().toLowerCase(Locale.ROOT).replace('_', '-');
  }
}
