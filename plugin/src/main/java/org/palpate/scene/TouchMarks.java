package org.palpate.scene;

import java.util.List;
import java.util.Optional;
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
 * @param tool the rigid tool whose reference point is {@code point}; empty if a point touches
 */
public record TouchMarks(
    Vec3 device,
    Vec3 point,
    Vec3 forceNewton,
    boolean contact,
    List<Vec3> trail,
    Optional<ToolMarks> tool) {

  /** Creates the marks of a point. */
  public TouchMarks(Vec3 device, Vec3 point, Vec3 forceNewton, boolean contact, List<Vec3> trail) {
    this(device, point, forceNewton, contact, trail, Optional.empty());
  }

  /** Copies the trail. */
  public TouchMarks {
    trail = List.copyOf(trail);
  }
}
