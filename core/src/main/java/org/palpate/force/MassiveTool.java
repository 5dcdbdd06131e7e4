package org.palpate.force;

import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.RigidCoupling;
import org.palpate.rigid.ToolMotion;
import org.palpate.rigid.tool.KineticMetric;
import org.palpate.rigid.tool.RigidTool;

/**
 * A rigid tool with mass and inertia on the spring of the coupling. It proposes where the tool goes
 * if nothing is in the way; the solver then moves the tool there as far as solids allow. The way
 * that the tool has gone is its speed, so a solid takes the speed into it, and nothing bounces.
 *
 * <p>Each frame takes a step of the implicit Euler method under the springs of the coupling, drag
 * and gravity. Such a step never raises the energy by more than the hand puts in. In contact,
 * friction takes speed, to zero at most. An {@link EnergyObserver} takes what surplus the solids
 * make. Gyroscopic moments are left out, as is usual at the speed of a hand.
 *
 * <p>If device and tool rest, and two steps in a row are shorter than {@link MassSettings#REST_MM},
 * the tool rests too, bit for bit.
 *
 * <p>References: Colgate, Stanley and Brown 1995 (virtual coupling); Moreau 1988 (time stepping
 * with inelastic contact). World mm, mm/s, rad/s and N. Haptic thread; allocates nothing.
 */
public final class MassiveTool implements ToolProposal {
  private final MassSettings held;
  private final double mass;
  private final Vec3 weightNewton;
  private final double stiffness;
  private final double turnStiffness;
  private final double friction;
  private final double radiusMm;
  private final KineticMetric inertia;
  private final EnergyObserver observer = new EnergyObserver();

  private final Pose proposed = new Pose();
  private final Pose lastTool = new Pose();
  private final Pose lastDevice = new Pose();
  private final Pose formerDevice = new Pose();
  private final Vec3 velocity = new Vec3();
  private final Vec3 spin = new Vec3();
  private final Vec3 step = new Vec3();
  private final Vec3 turn = new Vec3();
  private final Vec3 force = new Vec3();
  private final Vec3 torque = new Vec3();
  private final Vec3 scratch = new Vec3();
  private final Quaternion rotation = new Quaternion();
  private double lastSeconds;
  private double lastStepMm;
  private boolean begun;

  /**
   * Creates the body of a session.
   *
   * @param tool its matter gives the inertia, and the radius that weighs rotations
   * @param coupling the springs between device and tool
   * @param friction the coefficient of sliding friction
   * @param held the mass, with gravity along the world's axes
   */
  public MassiveTool(RigidTool tool, RigidCoupling coupling, double friction, MassSettings held) {
    this.held = held;
    mass = held.newtonSecond2PerMm();
    weightNewton = held.weightNewton();
    stiffness = coupling.stiffnessNewtonPerMm();
    turnStiffness = coupling.rotationalStiffness();
    this.friction = friction;
    radiusMm = tool.rmsRadiusMm();
    inertia = tool.metric();
  }

  @Override
  public void reset(Pose tool) {
    begun = false;
  }

  @Override
  public boolean jumps() {
    return false;
  }

  @Override
  public Pose propose(Pose device, ToolMotion motion, long elapsedNanos) {
    Pose tool = motion.pose();
    double seconds = MassSettings.stepSeconds(elapsedNanos);
    if (!begun) {
      begin(tool, device);
    } else if (lastSeconds > 0) {
      measureSpeed(tool);
      account(tool);
    }
    proposed.set(tool);
    if (seconds > 0) {
      slowByFriction(motion.contact(), seconds);
      computeStep(tool, device, seconds);
      boolean rests = isShort() && tool.sameBits(lastTool) && device.sameBits(lastDevice);
      if (!rests && step.isFinite() && turn.isFinite()) {
        tool.displace(step, turn, 1, rotation, proposed);
        proposed.rotation.normalize();
      }
    }
    remember(tool, device, seconds);
    return proposed;
  }

  private void begin(Pose tool, Pose device) {
    begun = true;
    velocity.set(0, 0, 0);
    spin.set(0, 0, 0);
    lastTool.set(tool);
    lastDevice.set(device);
    formerDevice.set(device);
    lastSeconds = 0;
    lastStepMm = Double.POSITIVE_INFINITY;
    observer.begin(potential(tool, device));
  }

  private void remember(Pose tool, Pose device, double seconds) {
    lastTool.set(tool);
    formerDevice.set(lastDevice);
    lastDevice.set(device);
    lastSeconds = seconds;
  }

  /** Writes the speeds with which the tool went from its last pose to the present one. */
  private void measureSpeed(Pose tool) {
    lastTool.differenceTo(tool, velocity, spin, rotation);
    velocity.mul(1 / lastSeconds, velocity);
    spin.mul(1 / lastSeconds, spin);
  }

  /** Writes force and torque of the coupling on the tool, and returns the potential energy. */
  private double potential(Pose tool, Pose device) {
    tool.differenceTo(device, force, torque, rotation);
    double energy =
        0.5 * stiffness * force.dot(force)
            + 0.5 * turnStiffness * torque.dot(torque)
            - weightNewton.dot(tool.translation);
    force.mul(stiffness, force);
    torque.mul(turnStiffness, torque);
    return energy;
  }

  private double kinetic(Pose tool) {
    tool.rotation.inverseRotate(spin, scratch);
    return 0.5 * mass * (velocity.dot(velocity) + inertia.squaredSpin(scratch));
  }

  /** Lets the energy grow in a frame by no more than the work of the hand. */
  private void account(Pose tool) {
    double kinetic = kinetic(tool);
    double energy = kinetic + potential(tool, lastDevice);
    formerDevice.differenceTo(lastDevice, step, turn, rotation);
    double work = force.dot(step) + torque.dot(turn);
    if (Double.isFinite(energy - work)) {
      double kept = observer.account(kinetic, energy, work);
      velocity.mul(kept, velocity);
      spin.mul(kept, spin);
    } else {
      velocity.set(0, 0, 0);
      spin.set(0, 0, 0);
      observer.begin(potential(tool, lastDevice));
    }
  }

  private void slowByFriction(boolean contact, double seconds) {
    double pressing = force.length();
    double lost = friction * pressing * seconds / mass;
    double speed = velocity.length() + radiusMm * spin.length();
    if (contact && lost > 0 && speed > 0) {
      double kept = Math.max(0, 1 - lost / speed);
      velocity.mul(kept, velocity);
      spin.mul(kept, spin);
    }
  }

  /** Writes the step that the implicit Euler method takes, mm and rad. */
  private void computeStep(Pose tool, Pose device, double seconds) {
    potential(tool, device);
    double heavy = mass / (seconds * seconds);
    double drag = held.dragNewtonSecondPerMm(stiffness) / seconds;
    velocity.mul(heavy * seconds, step);
    step.add(force, step).add(weightNewton, step).mul(1 / (heavy + drag + stiffness), step);
    double turnDrag = drag * radiusMm * radiusMm;
    tool.rotation.inverseRotate(spin, scratch);
    inertia.inertiaTimes(scratch, scratch).mul(heavy * seconds, scratch);
    tool.rotation.inverseRotate(torque, turn);
    turn.add(scratch, turn);
    inertia.solve(heavy, turnDrag + turnStiffness, turn, turn);
    tool.rotation.rotate(turn, turn);
  }

  private boolean isShort() {
    double stepMm = step.length() + radiusMm * turn.length();
    boolean isShort = stepMm < MassSettings.REST_MM && lastStepMm < MassSettings.REST_MM;
    lastStepMm = stepMm;
    return isShort;
  }

  /** {@return the mass, kg} */
  public double kg() {
    return held.kg();
  }

  /** {@return the surplus of energy that no motion has paid yet, mJ} */
  public double debtMillijoule() {
    return observer.debt();
  }

  /** {@return the surplus of energy that was taken from the motion of the tool so far, mJ} */
  public double takenMillijoule() {
    return observer.taken();
  }
}
