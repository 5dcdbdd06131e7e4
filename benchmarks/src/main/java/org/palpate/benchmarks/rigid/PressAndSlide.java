package org.palpate.benchmarks.rigid;

import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;

/**
 * A device that lowers a tool onto a surface, presses it in by a depth, and then slides it to and
 * fro while it turns. The fastest motion is about 0.5 mm in a frame. One thread.
 */
final class PressAndSlide {
  private static final double LOWERED_MM_PER_FRAME = 0.3;
  private static final double DEPTH_MM = 5;

  /** The tool is in contact once it is this far behind the device, mm. */
  private static final double CONTACT_MM = 0.2;

  /** Frames in which the slide begins to move. */
  private static final double STARTING_FRAMES = 200;

  /** The turn of a face that lies flat, as a part of the turn of other tools. */
  private static final double FLAT_TURN = 0.1;

  private final Vec3 base = new Vec3();
  private final Vec3 normal = new Vec3();
  private final Vec3 sideways = new Vec3();
  private final Vec3 along = new Vec3();
  private final Vec3 flat = new Vec3();
  private final Vec3 offset = new Vec3();
  private final Vec3 turn = new Vec3();
  private final Quaternion scratch = new Quaternion();
  private final Pose start = new Pose();
  private final double turnScale;
  private final double farMm;
  private double heightMm;

  /**
   * Creates a device.
   *
   * @param isFlat whether the tool's face z lies flat on the surface
   */
  PressAndSlide(SurfaceScene scene, boolean isFlat) {
    scene.landing(base, normal);
    farMm = 1.5 * scene.edgeMm();
    sideways.set(normal.z, 0, -normal.x);
    sideways.mul(1 / sideways.length(), sideways);
    normal.cross(sideways, along);
    turnScale = isFlat ? FLAT_TURN : 1;
    flat.set(0.05, -0.03, 0.02);
    if (isFlat) {
      double across = Math.hypot(normal.x, normal.y);
      double tilt = Math.acos(normal.z);
      flat.set(-normal.y / across * tilt, normal.x / across * tilt, 0);
    }
    start.rotation.setRotationVector(flat);
  }

  /** Lowers the tool from free space until the device is the depth below the first contact. */
  void press(ToolRun run) {
    Pose device = new Pose();
    heightMm = farMm;
    run.start(at(device));
    double contactMm = Double.NaN;
    while (Double.isNaN(contactMm) || heightMm > contactMm - DEPTH_MM) {
      heightMm -= LOWERED_MM_PER_FRAME;
      run.follow(at(device));
      if (Double.isNaN(contactMm) && run.behindMm(device) > CONTACT_MM) {
        contactMm = heightMm;
      }
    }
  }

  private Pose at(Pose dest) {
    dest.set(start);
    normal.mul(heightMm, dest.translation).add(base, dest.translation);
    return dest;
  }

  /** Writes the device pose of a frame of the slide, from 0. */
  Pose device(int frame, Pose dest) {
    double ramp = Math.min(1, frame / STARTING_FRAMES);
    sideways.mul(20 * ramp * Math.sin(frame * 2 * Math.PI / 420), offset);
    offset.add(along.mul(14 * ramp * Math.sin(frame * 2 * Math.PI / 611), turn), offset);
    double angle = turnScale * 0.17 * ramp * Math.sin(frame * 2 * Math.PI / 530);
    turn.set(0.5 * angle, -0.6 * angle, angle);
    return at(dest).displace(offset, turn, 1, scratch, dest);
  }
}
