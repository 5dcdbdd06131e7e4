package org.palpate.rigid;

import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.tool.RigidTool;

/**
 * The virtual coupling between a device and a rigid tool: a spring for the displacement of the
 * reference point and one for the rotation about it. Both pull the hand towards the tool.
 *
 * <p>Reference: Colgate, Stanley and Brown, Issues in the haptic display of tool use, 1995. Keeps
 * scratch: one thread.
 */
public final class RigidCoupling {
  private final double stiffnessNewtonPerMm;
  private final double rotationalStiffness;
  private final Quaternion scratch = new Quaternion();

  /**
   * Creates a coupling.
   *
   * @param stiffnessNewtonPerMm of the displacement, N/mm
   * @param rotationalStiffness of the rotation, N mm/rad
   * @throws IllegalArgumentException if a stiffness is negative
   */
  public RigidCoupling(double stiffnessNewtonPerMm, double rotationalStiffness) {
    if (!(stiffnessNewtonPerMm >= 0) || !(rotationalStiffness >= 0)) {
      throw new IllegalArgumentException(
          "stiffness must not be negative: "
              + stiffnessNewtonPerMm
              + " N/mm, "
              + rotationalStiffness
              + " N mm/rad");
    }
    this.stiffnessNewtonPerMm = stiffnessNewtonPerMm;
    this.rotationalStiffness = rotationalStiffness;
  }

  /**
   * Returns the coupling of a tool with the stiffness times its squared rms radius as rotational
   * stiffness. Then a rotation costs as much energy as the displacement of the tool's matter.
   */
  public static RigidCoupling of(RigidTool tool, double stiffnessNewtonPerMm) {
    double radiusMm = tool.rmsRadiusMm();
    return new RigidCoupling(stiffnessNewtonPerMm, stiffnessNewtonPerMm * radiusMm * radiusMm);
  }

  /** Returns the stiffness of the displacement, N/mm. */
  public double stiffnessNewtonPerMm() {
    return stiffnessNewtonPerMm;
  }

  /** Returns the stiffness of the rotation, N mm/rad. */
  public double rotationalStiffness() {
    return rotationalStiffness;
  }

  /**
   * Writes force and torque on the hand about the reference point, world axes.
   *
   * @param tool the tool pose
   * @param device the device pose, a pose with a quaternion of norm 1
   * @param forceNewton written, N
   * @param torqueNewtonMm written, N mm
   */
  public void compute(Pose tool, Pose device, Vec3 forceNewton, Vec3 torqueNewtonMm) {
    device.differenceTo(tool, forceNewton, torqueNewtonMm, scratch);
    scale(forceNewton, torqueNewtonMm);
  }

  /**
   * Turns a displacement, mm, and a rotation vector, rad, from the device to the tool into force,
   * N, and torque, N mm; see {@link CouplingRateLimit}.
   */
  public void scale(Vec3 forceNewton, Vec3 torqueNewtonMm) {
    forceNewton.mul(stiffnessNewtonPerMm, forceNewton);
    torqueNewtonMm.mul(rotationalStiffness, torqueNewtonMm);
  }
}
