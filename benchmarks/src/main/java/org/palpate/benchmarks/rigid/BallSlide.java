package org.palpate.benchmarks.rigid;

import org.palpate.benchmarks.accuracy.SlideTrajectory;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;

/** The poses of a hand that presses a ball into an analytic surface, wanders along it and turns. */
final class BallSlide {
  private static final double DEPTH_MM = 5;
  private static final double SPEED_MM_PER_FRAME = 0.3;
  private static final double TURN_RAD = 0.17;
  private static final double TURN_FRAMES = 530;

  private final SlideTrajectory slide;
  private final Vec3 turn = new Vec3();

  /**
   * Computes the poses of all frames.
   *
   * @param radiusMm the radius of the ball
   * @param frames the number of measured frames
   */
  BallSlide(SurfaceScene scene, double radiusMm, int frames, long seed) {
    slide =
        new SlideTrajectory(
            new OffsetSurface(scene.truth(), radiusMm),
            scene.edgeMm(),
            DEPTH_MM,
            SPEED_MM_PER_FRAME,
            frames,
            seed);
  }

  int frames() {
    return slide.frames();
  }

  /** Returns the first measured frame. */
  int begin() {
    return slide.slideStart();
  }

  /** Writes the device pose of a frame. */
  Pose device(int frame, Pose dest) {
    slide.device(frame, dest.translation);
    double angle = TURN_RAD * Math.sin(frame * 2 * Math.PI / TURN_FRAMES);
    dest.rotation.setRotationVector(turn.set(0.5 * angle, -0.6 * angle, angle));
    return dest;
  }

  /** Writes the true direction of the force. */
  Vec3 normal(int frame, Vec3 dest) {
    return slide.normal(frame, dest);
  }
}
