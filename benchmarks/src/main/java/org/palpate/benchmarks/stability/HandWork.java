package org.palpate.benchmarks.stability;

import org.palpate.frame.FramePublisher;
import org.palpate.frame.ToolFramePublisher;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.ToolMotion;

/**
 * Adds up the work of the forces on a hand over a motion that ends where it began. Each force is
 * multiplied by the mean of the steps before and after it, so that sampling and delay add no
 * energy. A passive effect gives none.
 */
final class HandWork implements FramePublisher, ToolFramePublisher {
  private final double unitMm;
  private final Pose last = new Pose();
  private final Pose present = new Pose();
  private final Vec3 lastForce = new Vec3();
  private final Vec3 lastTorque = new Vec3();
  private final Vec3 lastStep = new Vec3();
  private final Vec3 lastTurn = new Vec3();
  private final Vec3 step = new Vec3();
  private final Vec3 turn = new Vec3();
  private final Vec3 noTorque = new Vec3();
  private final Quaternion scratch = new Quaternion();
  private double millijoule;

  /**
   * Begins without work.
   *
   * @param unitMm the unit of the positions, mm
   */
  HandWork(double unitMm) {
    this.unitMm = unitMm;
  }

  /** Returns the energy that the hand has got so far, mJ; negative if it gave some. */
  double millijoule() {
    return millijoule;
  }

  @Override
  public void publish(Vec3 at, Vec3 point, Vec3 forceNewton, boolean contact, long frame) {
    at.mul(unitMm, present.translation);
    add(forceNewton, noTorque, frame);
  }

  @Override
  public void publish(Pose at, ToolMotion motion, Vec3 forceNewton, Vec3 torque, long frame) {
    present.set(at);
    present.translation.mul(unitMm, present.translation);
    add(forceNewton, torque, frame);
  }

  private void add(Vec3 forceNewton, Vec3 torqueNewtonMm, long frame) {
    if (frame == 0) {
      last.set(present);
    }
    last.differenceTo(present, step, turn, scratch);
    millijoule += 0.5 * lastForce.dot(lastStep.add(step, lastStep));
    millijoule += 0.5 * lastTorque.dot(lastTurn.add(turn, lastTurn));
    lastStep.set(step);
    lastTurn.set(turn);
    last.set(present);
    lastForce.set(forceNewton);
    lastTorque.set(torqueNewtonMm);
  }
}
