package org.palpate.force;

import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;

/**
 * Static and sliding friction: the point sticks to an anchor on the surface, pulled back by a
 * spring, while the pull stays inside a cone around the pressing force; beyond it slides and drags
 * the anchor along a narrower cone, until it comes to a stop. The two cones are the hysteresis that
 * keeps it from chattering.
 *
 * <p>Never pushes the way the hand already moves: what of the spring would, when the hand turns
 * back, is let go at once, and the anchor with it.
 *
 * <p>References: Salisbury and Tarr 1997; friction cones, Melder and Harwin 2004. Haptic thread;
 * allocates nothing.
 */
final class ConeFriction {
  /** The cone of sliding, as a share of that of sticking, where only one is given. */
  static final double SLIDING_SHARE = 0.75;

  /** Below this share of an edge a frame, a sliding point stops and sticks. */
  private static final double STOP_EDGES = 1e-4;

  private final GridMetric metric;
  private final double stopMm;
  private final Vec3 anchor = new Vec3();
  private final Vec3 lastDevice = new Vec3();
  private final Vec3 lastPoint = new Vec3();
  private final Vec3 pull = new Vec3();
  private boolean anchored;
  private boolean sliding;

  ConeFriction(GridMetric metric) {
    this.metric = metric;
    stopMm = STOP_EDGES * metric.shortestEdgeMm();
  }

  boolean isSliding() {
    return sliding;
  }

  /** Adds friction to the coupling force in {@code force}; lets go where nothing presses. */
  void add(InteractionPoint point, Vec3 device, MaterialTransition felt, Vec3 force) {
    double pressing = force.length();
    if (!(pressing > 0) || felt.stickingFriction() == 0 || !point.contact) {
      anchored = false;
    } else if (!anchored) {
      stickAt(point.position);
    } else {
      addPull(point.position, device, felt, pressing, force);
    }
    lastDevice.set(device);
    lastPoint.set(point.position);
  }

  private void stickAt(Vec3 position) {
    anchor.set(position);
    anchored = true;
    sliding = false;
  }

  private void addPull(
      Vec3 position, Vec3 device, MaterialTransition felt, double pressing, Vec3 force) {
    toMm(position, anchor, pull);
    takeOffAlong(force, pressing, pull);
    pull.mul(felt.stiffnessNewtonPerMm(), pull);
    stayInCone(position, felt, pressing);
    letGoOfPush(device);
    force.add(pull, force);
    followAnchor(position, felt.stiffnessNewtonPerMm());
  }

  /** Keeps of {@code vector} what is at right angles to the pressing force. */
  private static void takeOffAlong(Vec3 force, double length, Vec3 vector) {
    double share = vector.dot(force) / (length * length);
    vector.set(vector.x - share * force.x, vector.y - share * force.y, vector.z - share * force.z);
  }

  private void stayInCone(Vec3 position, MaterialTransition felt, double pressing) {
    double newton = pull.length();
    double stickingNewton = felt.stickingFriction() * pressing;
    double movedMm =
        metric.distance(lastPoint.x, lastPoint.y, lastPoint.z, position.x, position.y, position.z);
    sliding = newton > stickingNewton || (sliding && movedMm > stopMm);
    double most = sliding ? felt.slidingFriction() * pressing : stickingNewton;
    if (newton > most) {
      pull.mul(most / newton, pull);
    }
  }

  private void letGoOfPush(Vec3 device) {
    double x = (device.x - lastDevice.x) * metric.spacingX();
    double y = (device.y - lastDevice.y) * metric.spacingY();
    double z = (device.z - lastDevice.z) * metric.spacingZ();
    double along = pull.x * x + pull.y * y + pull.z * z;
    if (along > 0) {
      double share = along / (x * x + y * y + z * z);
      pull.set(pull.x - share * x, pull.y - share * y, pull.z - share * z);
    }
  }

  /** Puts the anchor where the spring pulls as hard as it now does. */
  private void followAnchor(Vec3 position, double stiffness) {
    anchor.set(
        position.x + pull.x / (stiffness * metric.spacingX()),
        position.y + pull.y / (stiffness * metric.spacingY()),
        position.z + pull.z / (stiffness * metric.spacingZ()));
  }

  private void toMm(Vec3 from, Vec3 to, Vec3 dest) {
    to.sub(from, dest);
    dest.set(dest.x * metric.spacingX(), dest.y * metric.spacingY(), dest.z * metric.spacingZ());
  }
}
