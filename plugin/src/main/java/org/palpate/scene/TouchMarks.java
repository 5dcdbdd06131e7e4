package org.palpate.scene;

import java.util.List;
import org.palpate.geometry.Vec3;

/**
 * Device, interaction point, force and trail of one frame as they are drawn. Scene frame, mm and
 * newtons. Immutable by convention.
 *
 * @param device device position
 * @param point interaction point
 * @param forceNewton force on the hand
 * @param contact whether the interaction point is in contact
 * @param trail earlier positions of the interaction point during this contact, the oldest first
 */
public record TouchMarks(
    Vec3 device, Vec3 point, Vec3 forceNewton, boolean contact, List<Vec3> trail) {
  /** Copies the trail. */
  public TouchMarks {
    trail = List.copyOf(trail);
  }
}
