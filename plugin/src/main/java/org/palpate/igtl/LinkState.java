package org.palpate.igtl;

import java.util.List;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;

/**
 * The state of a session as clients see it. A {@link LinkSource} fills it; one thread uses it.
 *
 * <p>Positions are in mm, forces in N, torques in N mm; all along the patient's axes right,
 * anterior, superior.
 */
public final class LinkState {
  /**
   * A named position.
   *
   * @param name the name
   * @param position RAS, mm
   */
  public record Landmark(String name, Vec3 position) {}

  /**
   * The pose of a body.
   *
   * @param name the name of the body; clients get its first 20 characters
   * @param pose from rest to present, RAS, mm
   */
  public record NamedPose(String name, RigidTransform pose) {}

  /** The pose of the device, from its frame to RAS; its vectors are written. */
  public final RigidTransform device = RigidTransform.identity();

  /** The pose of the tool: of the interaction point, or of the tool's reference point. */
  public final RigidTransform tool = RigidTransform.identity();

  /** The poses of the bodies that can move. */
  public List<NamedPose> bodies = List.of();

  /** The force on the hand, N. */
  public final Vec3 force = new Vec3();

  /** The torque on the hand, N mm. */
  public final Vec3 torque = new Vec3();

  /** Whether the tool is in contact. */
  public boolean contact;

  /**
   * The landmarks. A source never changes a list, but replaces it when a landmark changes. The
   * server sends the landmarks again only if the list no longer equals the last one.
   */
  public List<Landmark> landmarks = List.of();
}
