package org.palpate.rigid;

import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.tool.RigidTool;

/**
 * Spreads jumps of the tool over some frames before the hand feels them. It limits the displacement
 * and the rotation that the coupling turns into force and torque. In a frame they change by no more
 * than the device moves, or by a least amount if it hardly moves. A rotation counts as its angle
 * times the rms radius of the tool, mm.
 *
 * <p>The tool pose itself stays as the solver says. Keeps state: haptic thread only.
 */
public final class CouplingRateLimit {
  private final double squaredRadiusMm2;
  private final double leastMm;
  private final Quaternion scratch = new Quaternion();
  private final Vec3 displacement = new Vec3();
  private final Vec3 rotation = new Vec3();
  private final Vec3 motion = new Vec3();
  private final Vec3 turn = new Vec3();
  private final Pose lastDevice = new Pose();
  private boolean known;

  /**
   * Creates a limit for a tool.
   *
   * @param tool its rms radius weighs rotations
   * @param leastMm the change that is always allowed in a frame of a millisecond, mm
   */
  public CouplingRateLimit(RigidTool tool, double leastMm) {
    squaredRadiusMm2 = tool.rmsRadiusMm() * tool.rmsRadiusMm();
    this.leastMm = leastMm;
  }

  /** Forgets what the hand feels. The next frame starts with the true displacement. */
  public void reset() {
    known = false;
  }

  /**
   * Writes the displacement and rotation from the device to the tool that the hand is to feel.
   *
   * @param tool the tool pose, world mm
   * @param device the device pose, world mm
   * @param framePart the part of the least change that the frame gets, in (0, 1], or infinity for
   *     no bound
   * @param displacementMm written, world mm
   * @param rotationVector written, world axes, rad
   * @return the length, mm, by which the hand is behind; a rotation counts as above
   */
  public double limit(
      Pose tool, Pose device, double framePart, Vec3 displacementMm, Vec3 rotationVector) {
    device.differenceTo(tool, displacementMm, rotationVector, scratch);
    double lateMm = 0;
    if (known) {
      lastDevice.differenceTo(device, motion, turn, scratch);
      double mostMm = Math.max(framePart * leastMm, lengthMm(motion, turn));
      lateMm = approach(displacementMm, rotationVector, mostMm);
    }
    displacement.set(displacementMm);
    rotation.set(rotationVector);
    lastDevice.set(device);
    known = true;
    return lateMm;
  }

  /**
   * Moves from what the hand felt last towards the true displacement, by at most {@code mostMm}.
   */
  private double approach(Vec3 displacementMm, Vec3 rotationVector, double mostMm) {
    displacementMm.sub(displacement, motion);
    rotationVector.sub(rotation, turn);
    double changeMm = lengthMm(motion, turn);
    if (changeMm <= mostMm) {
      return 0;
    }
    double fraction = mostMm / changeMm;
    motion.mul(fraction, motion).add(displacement, displacementMm);
    turn.mul(fraction, turn).add(rotation, rotationVector);
    return changeMm - mostMm;
  }

  /**
   * {@return the length of a displacement and a rotation together, mm}
   *
   * @param displacementMm the displacement, mm
   * @param rotationVector the rotation, rad; it counts as its angle times the rms radius
   */
  public double lengthMm(Vec3 displacementMm, Vec3 rotationVector) {
    return Math.sqrt(
        displacementMm.dot(displacementMm) + squaredRadiusMm2 * rotationVector.dot(rotationVector));
  }
}
