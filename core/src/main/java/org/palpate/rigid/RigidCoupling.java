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
   * {@return the coupling of a tool with the stiffness times its squared rms radius as rotational
   * stiffness} Then a rotation costs as much energy as the displacement of the tool's matter.
   *
   * @param tool its rms radius is the lever of rotations
   * @param stiffnessNewtonPerMm the stiffness of the displacement, N/mm
   */
  public static RigidCoupling of(RigidTool tool, double stiffnessNewtonPerMm) {
    double radiusMm = tool.rmsRadiusMm();
    return new RigidCoupling(stiffnessNewtonPerMm, stiffnessNewtonPerMm * radiusMm * radiusMm);
  }

  /** {@return the stiffness of the displacement, N/mm} */
  public double stiffnessNewtonPerMm() {
    return stiffnessNewtonPerMm;
  }

  /** {@return the stiffness of the rotation, N mm/rad} */
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
   * Turns the stretch of the coupling into force and torque; see {@link CouplingRateLimit}.
   *
   * @param forceNewton the displacement from the device to the tool, mm; replaced by the force, N
   * @param torqueNewtonMm the rotation vector, rad; replaced by the torque, N mm
   */
  public void scale(Vec3 forceNewton, Vec3 torqueNewtonMm) {
    forceNewton.mul(stiffnessNewtonPerMm, forceNewton);
    torqueNewtonMm.mul(rotationalStiffness, torqueNewtonMm);
  }
}
