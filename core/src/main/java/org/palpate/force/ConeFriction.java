package org.palpate.force;

import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;

/**
 * Static and sliding friction with one friction cone each.
 *
 * <p>The interaction point sticks to an anchor on the surface. A spring pulls it back to the anchor
 * while the pull lies inside the static cone around the pressing force. Beyond that cone the point
 * slides and drags the anchor along the narrower sliding cone, until it stops. The two cones are a
 * hysteresis that keeps the force from chattering.
 *
 * <p>Friction never pushes in the direction in which the hand already moves. If the hand turns
 * back, that part of the pull is released at once, and the anchor moves with it.
 *
 * <p>References: Salisbury and Tarr 1997; friction cones, Melder and Harwin 2004. Haptic thread;
 * allocates nothing.
 */
final class ConeFriction {
  /** Sliding friction divided by static friction, if a user gives only one of them. */
  static final double SLIDING_FRACTION = 0.75;

  /**
   * A sliding point that moves less than this in a frame of a millisecond sticks; in shortest voxel
   * edges, see {@link FramePart}.
   */
  static final double STOP_EDGES = 1e-4;

  private final GridMetric metric;
  private final double stopMm;
  private double framePart = 1;
  private final Vec3 anchor = new Vec3();
  private final Vec3 lastDevice = new Vec3();
  private final Vec3 lastPoint = new Vec3();
  private final Vec3 pull = new Vec3();
  private final Vec3 handMotion = new Vec3();
  private boolean anchored;
  private boolean sliding;

  ConeFriction(GridMetric metric) {
    this.metric = metric;
    stopMm = STOP_EDGES * metric.shortestEdgeMm();
  }

  /** Begins a frame. */
  void advance(long elapsedNanos) {
    framePart = FramePart.ofNanos(elapsedNanos);
  }

  /** Whether the point slides instead of sticking to its anchor. */
  boolean isSliding() {
    return sliding;
  }

  /**
   * Adds friction to the coupling force in {@code force}. Without contact or pressing force there
   * is no friction, and the next contact begins with a new anchor.
   */
  void add(InteractionPoint point, Vec3 device, MaterialTransition material, Vec3 force) {
    double pressing = force.length();
    if (!(pressing > 0) || material.staticFriction() == 0 || !point.contact) {
      anchored = false;
    } else if (!anchored) {
      stickAt(point.position);
    } else {
      addPull(point.position, device, material, pressing, force);
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
      Vec3 position, Vec3 device, MaterialTransition material, double pressing, Vec3 force) {
    stretchToAnchor(position);
    removeComponentAlong(force, pressing);
    pull.mul(material.stiffnessNewtonPerMm(), pull);
    limitToCone(position, material, pressing);
    releasePush(measureMotion(device), pull);
    force.add(pull, force);
    moveAnchor(position, material.stiffnessNewtonPerMm());
  }

  /** Writes the vector from the point to its anchor into {@link #pull}, mm. */
  private void stretchToAnchor(Vec3 position) {
    anchor.sub(position, pull);
    pull.set(pull.x * metric.spacingX(), pull.y * metric.spacingY(), pull.z * metric.spacingZ());
  }

  /** Reduces {@link #pull} to its component at right angles to the pressing force. */
  private void removeComponentAlong(Vec3 force, double length) {
    double fraction = pull.dot(force) / (length * length);
    pull.set(pull.x - fraction * force.x, pull.y - fraction * force.y, pull.z - fraction * force.z);
  }

  private void limitToCone(Vec3 position, MaterialTransition material, double pressing) {
    double newton = pull.length();
    double staticNewton = material.staticFriction() * pressing;
    double movedMm =
        metric.distance(lastPoint.x, lastPoint.y, lastPoint.z, position.x, position.y, position.z);
    sliding = newton > staticNewton || (sliding && movedMm > framePart * stopMm);
    double maxNewton = sliding ? material.slidingFriction() * pressing : staticNewton;
    if (newton > maxNewton) {
      pull.mul(maxNewton / newton, pull);
    }
  }

  private Vec3 measureMotion(Vec3 device) {
    return handMotion.set(
        (device.x - lastDevice.x) * metric.spacingX(),
        (device.y - lastDevice.y) * metric.spacingY(),
        (device.z - lastDevice.z) * metric.spacingZ());
  }

  /**
   * Removes from a pull the component along the motion of the hand, if it is positive.
   *
   * @param motion of the hand since the last frame; overwritten
   * @param pull a force or a stretch; changed in place
   */
  static void releasePush(Vec3 motion, Vec3 pull) {
    double along = pull.dot(motion);
    if (along > 0) {
      pull.sub(motion.mul(along / motion.dot(motion), motion), pull);
    }
  }

  /** Moves the anchor to the position at which the spring pulls with the present force. */
  private void moveAnchor(Vec3 position, double stiffness) {
    anchor.set(
        position.x + pull.x / (stiffness * metric.spacingX()),
        position.y + pull.y / (stiffness * metric.spacingY()),
        position.z + pull.z / (stiffness * metric.spacingZ()));
  }
}
