package org.palpate.force.guide;

import org.palpate.geometry.Vec3;

/** A set of positions that a guide allows, in millimetres of the frame. Immutable; any thread. */
public interface GuideShape {
  /**
   * Writes the position of the set that is nearest to a position; any one of several.
   *
   * @param position any position, in mm of the frame
   * @param dest may be {@code position}
   */
  void nearest(Vec3 position, Vec3 dest);
}
