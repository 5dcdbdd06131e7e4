package org.palpate.benchmarks.rigid;

import java.util.ArrayList;
import java.util.List;
import org.palpate.benchmarks.accuracy.AccuracyMeter;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;

/**
 * Measures direction and steadiness of the coupling force of a tool, as the solver gives it: before
 * the limit that spreads jumps over frames. Forces are measured as displacements, which are forces
 * divided by the stiffness. Torques are measured as rotations. One thread.
 */
final class ForceMeter {
  private final double rmsRadiusMm;
  private final Vec3 displacement = new Vec3();
  private final Vec3 rotation = new Vec3();
  private final Vec3 lastDisplacement = new Vec3();
  private final Vec3 lastRotation = new Vec3();
  private final Vec3 motion = new Vec3();
  private final Vec3 turn = new Vec3();
  private final Pose lastDevice = new Pose();
  private final Quaternion scratch = new Quaternion();
  private final List<Double> degrees = new ArrayList<>();
  private final List<Double> forceChanges = new ArrayList<>();
  private final List<Double> torqueChanges = new ArrayList<>();
  private boolean known;

  /**
   * Creates a meter.
   *
   * @param rmsRadiusMm the length that a rotation by one radian counts as, mm
   */
  ForceMeter(double rmsRadiusMm) {
    this.rmsRadiusMm = rmsRadiusMm;
  }

  /**
   * Takes note of a frame.
   *
   * @param normal the true direction of the force, unit
   */
  void count(Pose tool, Pose device, Vec3 normal) {
    device.differenceTo(tool, displacement, rotation, scratch);
    countDirection(displacement, normal);
    if (known) {
      lastDevice.differenceTo(device, motion, turn, scratch);
      double movedMm = Math.hypot(motion.length(), rmsRadiusMm * turn.length());
      lastDisplacement.sub(displacement, lastDisplacement);
      lastRotation.sub(rotation, lastRotation);
      forceChanges.add(lastDisplacement.length() / movedMm);
      torqueChanges.add(rmsRadiusMm * lastRotation.length() / movedMm);
    }
    lastDisplacement.set(displacement);
    lastRotation.set(rotation);
    lastDevice.set(device);
    known = true;
  }

  /**
   * Takes note of the direction of a force. A force of length 0 counts as an error of 180 degrees.
   */
  void countDirection(Vec3 force, Vec3 normal) {
    degrees.add(AccuracyMeter.angleDegrees(force, normal));
  }

  double rmsDegrees() {
    return Math.sqrt(degrees.stream().mapToDouble(d -> d * d).average().orElseThrow());
  }

  /**
   * Returns the 99th percentile of the change of force from frame to frame, divided by the
   * stiffness and by the motion of the device.
   */
  double forceChangeP99() {
    return p99(forceChanges);
  }

  /**
   * Returns the 99th percentile of the change of torque, likewise; a rotation counts as its path at
   * the rms radius.
   */
  double torqueChangeP99() {
    return p99(torqueChanges);
  }

  private static double p99(List<Double> values) {
    return Quantile.of(values.stream().mapToDouble(v -> v).toArray(), 0.99);
  }
}
