package org.palpate.force;

import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.rigid.CouplingRateLimit;
import org.palpate.rigid.RigidCoupling;
import org.palpate.rigid.ToolContacts;
import org.palpate.rigid.ToolMotion;
import org.palpate.rigid.tool.RigidTool;

/**
 * Computes force and torque on the hand that holds a rigid tool: virtual coupling, damping and
 * friction.
 *
 * <p>Stiffness, friction and damping are those of the body that carries most of the pressing force,
 * see {@link MaterialTransition}, and the general ones without contact. Damping acts along the
 * coupling force and, times the squared rms radius of the tool, along the coupling torque. Friction
 * acts at the contacts, see {@link ToolFriction}. Haptic thread; allocates nothing.
 */
public final class ToolForce {
  private static final GridMetric WORLD = new GridMetric(1, 1, 1);

  /**
   * The depth below the isosurface at which grey values are read, edges. Over flat faces the
   * isosurface is half an edge high, so the position is as deep in the voxels as that of a point.
   */
  private static final double GREY_DEPTH_EDGES = 1.5;

  private final RigidCoupling coupling;
  private final double squaredRadiusMm2;
  private final CouplingRateLimit rateLimit;
  private final MaterialTransition material;
  private final ContactDamping damping = new ContactDamping(WORLD);
  private final ContactDamping spinDamping = new ContactDamping(WORLD);
  private final ToolFriction friction;
  private final Pose lastDevice = new Pose();
  private final Vec3 motion = new Vec3();
  private final Vec3 turn = new Vec3();
  private final Vec3 turned = new Vec3();
  private final Vec3 dampingForce = new Vec3();
  private final Vec3 dampingTorque = new Vec3();
  private final Quaternion scratch = new Quaternion();
  private final Vec3 under = new Vec3();
  private final Vec3 normal = new Vec3();
  private final double greyDepthMm;
  private ForceSettings settings;

  /** Null if materials do not follow from grey values. */
  private GreyMaterials greys;

  private boolean known;
  private boolean limitsRate = true;
  private long frictionSkipped;

  /**
   * Makes the force of a session.
   *
   * @param tool its points give the lever of torques
   * @param shortestEdgeMm the shortest voxel edge of the scene, mm
   * @param coupling has the stiffness of the general material of {@code settings}
   * @param settings materials, friction and damping at the start
   */
  public ToolForce(
      RigidTool tool, double shortestEdgeMm, RigidCoupling coupling, ForceSettings settings) {
    this.coupling = coupling;
    this.settings = settings;
    squaredRadiusMm2 = tool.rmsRadiusMm() * tool.rmsRadiusMm();
    rateLimit = new CouplingRateLimit(tool, ChangeBound.MIN_MOTION_EDGES * shortestEdgeMm);
    material = new MaterialTransition(shortestEdgeMm, settings.general());
    friction = new ToolFriction(shortestEdgeMm);
    greyDepthMm = GREY_DEPTH_EDGES * shortestEdgeMm;
  }

  /**
   * Changes materials and friction from the next frame on.
   *
   * @param newSettings the new materials and the form of friction
   */
  public void change(ForceSettings newSettings) {
    settings = newSettings;
  }

  /**
   * Takes materials from grey values instead of the settings; before the first frame. The values
   * are those of bodies at rest.
   *
   * @param materials belong to the bodies at rest
   */
  public void use(GreyMaterials materials) {
    greys = materials;
  }

  /**
   * Chooses whether the change of the coupling force is bounded; it is at first.
   *
   * @param limits whether the change of the coupling force is bounded
   */
  public void limitRate(boolean limits) {
    limitsRate = limits;
  }

  /** Forgets what the hand feels, after the tool was placed anew. */
  public void reset() {
    rateLimit.reset();
    friction.reset();
    material.reset();
  }

  /** Forgets the hand as well, which held something else meanwhile. */
  public void takeOver() {
    reset();
    damping.reset();
    spinDamping.reset();
    known = false;
  }

  /** {@return the number of frames that skipped friction because it is zero} */
  public long frictionSkipped() {
    return frictionSkipped;
  }

  /**
   * Computes force and torque of a frame, without the limits of the device.
   *
   * @param tool the tool's motion in this frame
   * @param device the device pose, with a quaternion of norm 1
   * @param elapsedNanos time since the last computed frame; 0 keeps the last speed for damping
   * @param forceNewton written, N, world axes
   * @param torqueNewtonMm written, N mm about the reference point, world axes
   */
  public void compute(
      ToolMotion tool, Pose device, long elapsedNanos, Vec3 forceNewton, Vec3 torqueNewtonMm) {
    measureMotion(device);
    material.advance(elapsedNanos);
    friction.advance(elapsedNanos);
    double framePart = limitsRate ? FramePart.ofNanos(elapsedNanos) : Double.POSITIVE_INFINITY;
    rateLimit.limit(tool.pose(), device, framePart, forceNewton, torqueNewtonMm);
    updateMaterial(tool, forceNewton.length());
    double general = coupling.stiffnessNewtonPerMm();
    double factor = general > 0 ? material.stiffnessNewtonPerMm() / general : 1;
    coupling.scale(forceNewton, torqueNewtonMm);
    forceNewton.mul(factor, forceNewton);
    torqueNewtonMm.mul(factor, torqueNewtonMm);
    computeDamping(device, elapsedNanos, forceNewton, torqueNewtonMm);
    if (settings.skipsFriction() && material.staticFriction() == 0) {
      frictionSkipped++;
      friction.reset();
    } else {
      friction.add(
          tool.contacts(),
          tool.pathPose(0),
          tool.pose(),
          device,
          material,
          forceNewton,
          torqueNewtonMm);
    }
    forceNewton.add(dampingForce, forceNewton);
    torqueNewtonMm.add(dampingTorque, torqueNewtonMm);
  }

  private void measureMotion(Pose device) {
    motion.set(0, 0, 0);
    turn.set(0, 0, 0);
    if (known) {
      lastDevice.differenceTo(device, motion, turn, scratch);
    }
    turned.add(turn, turned);
    lastDevice.set(device);
    known = true;
  }

  private void updateMaterial(ToolMotion tool, double stretchMm) {
    int most = mostPressed(tool.contacts());
    double motionMm = rateLimit.lengthMm(motion, turn);
    if (!tool.contact()) {
      material.release(settings, stretchMm, motionMm);
      return;
    }
    if (greys != null) {
      boolean touches = most >= 0;
      double grey = touches ? greyUnder(tool, most) : 0;
      material.follow(settings, greys, grey, touches, stretchMm, motionMm);
      return;
    }
    int body = most < 0 ? InteractionPoint.NO_OBJECT : tool.contacts().body(most);
    material.follow(settings, body, true, stretchMm, motionMm);
  }

  /** Returns the contact that carries the largest share, or -1. */
  private static int mostPressed(ToolContacts contacts) {
    int most = contacts.count() == 0 ? -1 : 0;
    for (int n = 1; n < contacts.count(); n++) {
      most = contacts.share(n) > contacts.share(most) ? n : most;
    }
    return most;
  }

  /** Returns the grey value at a contact, below the surface of the body. */
  private double greyUnder(ToolMotion tool, int contact) {
    double belowPointMm = tool.contacts().heightMm(contact) + greyDepthMm;
    tool.contactMm(contact, under);
    tool.contacts().normal(contact, normal).mul(belowPointMm, normal);
    greys.grid().worldToGrid(under.sub(normal, under), under);
    return greys.greyAt(under);
  }

  private void computeDamping(Pose device, long elapsedNanos, Vec3 force, Vec3 torque) {
    damping.update(device.translation, elapsedNanos);
    spinDamping.update(turned, elapsedNanos);
    double newtonSecondPerMm = material.dampingNewtonSecondPerMm();
    damping.compute(force, newtonSecondPerMm, dampingForce);
    spinDamping.compute(torque, squaredRadiusMm2 * newtonSecondPerMm, dampingTorque);
  }
}
