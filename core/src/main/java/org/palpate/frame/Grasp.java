package org.palpate.frame;

import java.util.ArrayList;
import java.util.List;
import org.palpate.body.BodyScene;
import org.palpate.edit.PlacementLog;
import org.palpate.force.ForceSettings;
import org.palpate.force.GreyMaterials;
import org.palpate.force.ToolForce;
import org.palpate.force.ToolProposal;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.ReferencePose;
import org.palpate.rigid.RigidCoupling;
import org.palpate.rigid.RigidSolver;
import org.palpate.rigid.ToolContacts;
import org.palpate.rigid.ToolMotion;

/**
 * Holds either the tool or a movable body that the tool touched. Bodies may move along with it as
 * if glued to it. A body that is taken stays where it is, bit for bit, and so does one that is let
 * go.
 *
 * <p>A body is attached to the device by a fixed pose. It is chosen such that the coupling gives
 * the force and torque that the hand felt when it took the body. The tool returns where the body
 * has carried it, so its coupling is stretched about as far as that of the body was. The limiter of
 * the frame spreads what difference is left. Haptic thread only; allocates nothing after it was
 * made.
 */
final class Grasp {
  /** The index of a body that does not exist. */
  static final int NO_BODY = -1;

  /** The largest rotation between device and what is held at the moment of taking, rad. */
  private static final double LARGEST_TURN = 1;

  private final BodyScene bodies;
  private final Grip tool;
  private final Grip[] ofBody;
  private final PlacementLog placements;
  private final Pose attachment = new Pose();
  private final Pose toolInBody = new Pose();

  /** The pose of each body when the hand took hold, or when the body began to move along. */
  private final List<Pose> starts = new ArrayList<>();

  private final Pose target = new Pose();
  private final Vec3 lever = new Vec3();
  private final Vec3 moment = new Vec3();
  private final Quaternion turn = new Quaternion();
  private Grip grip;

  /** Null if the tool follows the device itself. */
  private ToolProposal proposal;

  private int held = NO_BODY;

  /** For each body whether it is held or moves along with the one that is. */
  private final boolean[] moves;

  /** The solver, the coupling and the force of something that the hand can hold. */
  private record Grip(RigidSolver solver, RigidCoupling coupling, ToolForce force) {}

  /**
   * Makes a grasp that holds the tool.
   *
   * @param placements notes where bodies are put
   */
  Grasp(
      BodyScene bodies,
      RigidSolver solver,
      RigidCoupling coupling,
      ForceSettings settings,
      PlacementLog placements) {
    this.bodies = bodies;
    this.placements = placements;
    tool = newGrip(solver, coupling, settings);
    grip = tool;
    ofBody = new Grip[bodies.count()];
    moves = new boolean[ofBody.length];
    for (int n = 0; n < ofBody.length; n++) {
      starts.add(new Pose());
      if (solver.canMove(n)) {
        RigidSolver holding = solver.ofBody(n);
        RigidCoupling spring = RigidCoupling.of(holding.shape(), coupling.stiffnessNewtonPerMm());
        ofBody[n] = newGrip(holding, spring, settings);
      }
    }
  }

  private Grip newGrip(RigidSolver solver, RigidCoupling coupling, ForceSettings settings) {
    ToolForce force = new ToolForce(solver.shape(), bodies.shortestEdgeMm(), coupling, settings);
    return new Grip(solver, coupling, force);
  }

  /** Takes materials of everything that is held from grey values. */
  void use(GreyMaterials materials) {
    tool.force.use(materials);
    for (Grip each : ofBody) {
      if (each != null) {
        each.force.use(materials);
      }
    }
  }

  RigidSolver solver() {
    return grip.solver;
  }

  ToolForce force() {
    return grip.force;
  }

  /** Returns the index of the body that is held, or {@link #NO_BODY}. */
  int held() {
    return held;
  }

  /** Returns the pose of the held body's reference point relative to the device. */
  Pose inHand() {
    return attachment;
  }

  /** Lets something propose where the tool goes; before the first frame. */
  void use(ToolProposal newProposal) {
    proposal = newProposal;
    tool.force.limitRate(newProposal.jumps());
  }

  /** Begins anew with what is held, because it was placed without a path. */
  void restart(ToolMotion motion) {
    grip.force.reset();
    if (proposal != null) {
      proposal.reset(motion.pose());
    }
  }

  /** Returns the pose to which the coupling holds what is held, in a frame that has followed. */
  Pose coupled(Pose device) {
    return held == NO_BODY && proposal != null ? device : grip.solver.target();
  }

  /**
   * Returns the pose that what is held is to reach for a device pose.
   *
   * @param elapsedNanos time since the last frame that followed
   */
  Pose target(Pose device, ToolMotion motion, long elapsedNanos) {
    if (held == NO_BODY) {
      return proposal == null ? device : proposal.propose(device, motion, elapsedNanos);
    }
    device.multiply(attachment, target);
    target.rotation.normalize();
    return target;
  }

  /** Turns a torque about the reference point of what is held into one about the device's point. */
  void moveTorque(Pose holding, Pose device, Vec3 forceNewton, Vec3 torqueNewtonMm) {
    if (held != NO_BODY) {
      holding.translation.sub(device.translation, lever);
      torqueNewtonMm.add(lever.cross(forceNewton, moment), torqueNewtonMm);
    }
  }

  /** Returns the movable body that the tool presses most, or {@link #NO_BODY}. */
  int touched(ToolMotion motion) {
    ToolContacts contacts = motion.contacts();
    int most = NO_BODY;
    double share = -1;
    for (int n = 0; motion.contact() && n < contacts.count(); n++) {
      int body = contacts.body(n);
      if (body < ofBody.length && ofBody[body] != null && contacts.share(n) > share) {
        most = body;
        share = contacts.share(n);
      }
    }
    return most;
  }

  /**
   * Takes hold of a movable body. The tool leaves the scene.
   *
   * @param forceNewton the last force on the hand
   * @param torqueNewtonMm the last torque on the hand
   */
  void take(int body, Pose device, Vec3 forceNewton, Vec3 torqueNewtonMm, ToolMotion motion) {
    take(body, motion);
    attach(motion.pose(), device, forceNewton, torqueNewtonMm);
  }

  /**
   * Takes hold of a movable body as a recorded session did.
   *
   * @param bodyInHand what {@link #inHand} was then
   */
  void takeAgain(int body, Pose bodyInHand, ToolMotion motion) {
    take(body, motion);
    attachment.set(bodyInHand);
  }

  private void take(int body, ToolMotion motion) {
    target.set(motion.pose());
    held = body;
    grip = ofBody[body];
    for (int n = 0; n < starts.size(); n++) {
      starts.get(n).set(bodies.body(n).pose());
    }
    moves[body] = true;
    grip.solver.takeOver(motion);
    grip.force.takeOver();
    motion.pose().inverseMultiply(target, toolInBody);
  }

  /** Lets a movable body move along with the one that is held; before the next frame follows. */
  void join(int body) {
    starts.get(body).set(bodies.body(body).pose());
    moves[body] = true;
    grip.solver.carry(body);
  }

  /** Whether a body is held or moves along with the one that is. */
  boolean moves(int body) {
    return moves[body];
  }

  /**
   * Lets go of the body that is held. The tool returns to the scene where the body has carried it.
   *
   * @return whether the tool is free there; if not, it was set free elsewhere
   */
  boolean letGo(ToolMotion motion) {
    motion.pose().multiply(toolInBody, target);
    target.rotation.normalize();
    notePlacements();
    grip.solver.carryNone();
    held = NO_BODY;
    grip = tool;
    tool.force.takeOver();
    boolean isFree = tool.solver.place(target, motion);
    restart(motion);
    return isFree;
  }

  private void notePlacements() {
    placements.separate();
    for (int n = 0; n < moves.length; n++) {
      if (moves[n] && !bodies.body(n).pose().sameBits(starts.get(n))) {
        placements.note(n, starts);
      }
      moves[n] = false;
    }
    placements.separate();
  }

  /** Attaches a body to the device such that the coupling gives this force and torque. */
  private void attach(Pose holding, Pose device, Vec3 forceNewton, Vec3 torqueNewtonMm) {
    double newtonPerMm = grip.coupling.stiffnessNewtonPerMm();
    forceNewton.mul(newtonPerMm > 0 ? -1 / newtonPerMm : 0, target.translation);
    target.translation.add(holding.translation, target.translation);
    double stiffness = grip.coupling.rotationalStiffness();
    torqueNewtonMm.mul(stiffness > 0 ? -1 / stiffness : 0, moment);
    double angle = moment.length();
    moment.mul(angle > LARGEST_TURN ? LARGEST_TURN / angle : 1, moment);
    turn.setRotationVector(moment).multiply(holding.rotation, target.rotation);
    ReferencePose.relative(device, target, attachment);
  }
}
