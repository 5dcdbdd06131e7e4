package org.palpate.scene;

import java.util.List;
import org.palpate.geometry.Vec3;

/**
 * What is drawn of the hand, of one frame. Scene frame, mm and newtons. Immutable by convention.
 *
 * @param device where the device is
 * @param point where the interaction point is
 * @param forceNewton on the hand
 * @param contact whether something is touched
 * @param trail places of the interaction point while there was contact, the oldest first
 */
public record TouchMarks(
    Vec3 device, Vec3 point, Vec3 forceNewton, boolean contact, List<Vec3> trail) {
  /** Copies the trail. */
  public TouchMarks {
    trail = List.copyOf(trail);
  }
}
