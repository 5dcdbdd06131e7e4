package org.palpate.force;

import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.ToolContacts;

/**
 * Static and sliding friction of a rigid tool with two friction cones at each contact, as {@link
 * ConeFriction} has for a point.
 *
 * <p>Each contact has an anchor and a spring in its tangential plane. The springs of all contacts
 * together are as stiff as the coupling, and each takes the share of the pressing force that its
 * contact carries. The anchor stays where it is while the tool moves, until the spring leaves the
 * cone. If the tool passes from one sample point to another, the new contact takes over the stretch
 * of the nearest old one. Contacts that lie apart resist a twist of the tool.
 *
 * <p>Haptic thread; allocates nothing.
 */
final class ToolFriction {
  private final double stopMm;
  private double framePart = 1;
  private final double[] positionX = new double[ToolContacts.MOST];
  private final double[] positionY = new double[ToolContacts.MOST];
  private final double[] positionZ = new double[ToolContacts.MOST];
  private final Vec3[] stretch = new Vec3[ToolContacts.MOST];
  private final Vec3[] lastStretch = new Vec3[ToolContacts.MOST];
  private final boolean[] sliding = new boolean[ToolContacts.MOST];
  private final boolean[] wasSliding = new boolean[ToolContacts.MOST];
  private final Pose lastDevice = new Pose();
  private final Vec3 local = new Vec3();
  private final Vec3 position = new Vec3();
  private final Vec3 moved = new Vec3();
  private final Vec3 normal = new Vec3();
  private final Vec3 pull = new Vec3();
  private int lastCount;

  ToolFriction(double shortestEdgeMm) {
    stopMm = ConeFriction.STOP_EDGES * shortestEdgeMm;
    for (int n = 0; n < ToolContacts.MOST; n++) {
      stretch[n] = new Vec3();
      lastStretch[n] = new Vec3();
    }
  }

  /** Begins a frame. */
  void advance(long elapsedNanos) {
    framePart = FramePart.ofNanos(elapsedNanos);
  }

  /** Forgets all anchors; the next contacts begin with new ones. */
  void reset() {
    lastCount = 0;
  }

  /**
   * Adds friction to a coupling force and torque.
   *
   * @param from the tool pose at the beginning of the frame
   * @param to the tool pose at its end
   * @param forceNewton its length is the pressing force
   */
  void add(
      ToolContacts contacts,
      Pose from,
      Pose to,
      Pose device,
      MaterialTransition material,
      Vec3 forceNewton,
      Vec3 torqueNewtonMm) {
    double pressing = forceNewton.length();
    if (!(pressing > 0) || material.staticFriction() == 0 || contacts.count() == 0) {
      lastCount = 0;
    } else {
      stretchAnchors(contacts, from, to);
      for (int n = 0; n < contacts.count(); n++) {
        limitToCone(n, material, pressing);
        releasePush(contacts, n, device);
        stretch[n].mul(contacts.share(n) * material.stiffnessNewtonPerMm(), pull);
        forceNewton.add(pull, forceNewton);
        to.rotation.rotate(contacts.position(n, local), local);
        torqueNewtonMm.add(local.cross(pull, local), torqueNewtonMm);
      }
      remember(contacts, to);
    }
    lastDevice.set(device);
  }

  /** Writes the vector from each contact to its anchor, in the tangential plane, mm. */
  private void stretchAnchors(ToolContacts contacts, Pose from, Pose to) {
    for (int n = 0; n < contacts.count(); n++) {
      contacts.position(n, local);
      from.transform(local, position);
      to.transform(local, moved).sub(position, moved);
      int old = nearestOld();
      stretch[n].set(0, 0, 0);
      sliding[n] = old >= 0 && wasSliding[old] && moved.length() > framePart * stopMm;
      if (old >= 0) {
        lastStretch[old].sub(moved, stretch[n]);
        contacts.normal(n, normal);
        normal.mul(normal.dot(stretch[n]), normal);
        stretch[n].sub(normal, stretch[n]);
      }
    }
  }

  /** Returns the contact of the last frame that is nearest to {@link #position}, or -1. */
  private int nearestOld() {
    int nearest = -1;
    double least = Double.POSITIVE_INFINITY;
    for (int n = 0; n < lastCount; n++) {
      double x = positionX[n] - position.x;
      double y = positionY[n] - position.y;
      double z = positionZ[n] - position.z;
      double squared = x * x + y * y + z * z;
      if (squared < least) {
        least = squared;
        nearest = n;
      }
    }
    return nearest;
  }

  private void limitToCone(int contact, MaterialTransition material, double pressing) {
    double newton = material.stiffnessNewtonPerMm() * stretch[contact].length();
    double staticNewton = material.staticFriction() * pressing;
    sliding[contact] |= newton > staticNewton;
    double most = sliding[contact] ? material.slidingFriction() * pressing : staticNewton;
    if (newton > most) {
      stretch[contact].mul(most / newton, stretch[contact]);
    }
  }

  private void releasePush(ToolContacts contacts, int contact, Pose device) {
    contacts.position(contact, local);
    lastDevice.transform(local, position);
    device.transform(local, moved).sub(position, moved);
    ConeFriction.releasePush(moved, stretch[contact]);
  }

  private void remember(ToolContacts contacts, Pose to) {
    lastCount = contacts.count();
    for (int n = 0; n < lastCount; n++) {
      to.transform(contacts.position(n, local), position);
      positionX[n] = position.x;
      positionY[n] = position.y;
      positionZ[n] = position.z;
      lastStretch[n].set(stretch[n]);
      wasSliding[n] = sliding[n];
    }
  }
}
