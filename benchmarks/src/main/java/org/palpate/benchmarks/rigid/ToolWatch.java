package org.palpate.benchmarks.rigid;

import java.util.List;
import java.util.SplittableRandom;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;

/**
 * Watches tools that a moving device holds. A frame is stuck if the tool did not move although the
 * device is away. A random search then looks for a small rigid step that leads nearer. One thread.
 */
final class ToolWatch {
  /** The tool is stuck if it is farther behind than this, voxels. */
  private static final double AWAY = 0.5;

  /** A step that leads nearer by more than this is a way out, voxels. */
  private static final double WAY_OUT = 0.1;

  private static final int STEPS = 1_500;

  /** One stuck frame in this many is searched. */
  private static final int SEARCHED_DIVISOR = 5;

  private final SplittableRandom random;
  private final Vec3 shift = new Vec3();
  private final Vec3 turn = new Vec3();
  private final Vec3 towards = new Vec3();
  private final Vec3 turnTowards = new Vec3();
  private final Quaternion scratch = new Quaternion();
  private final Pose trial = new Pose();
  private int frames;
  private int stuck;
  private int searched;
  private int waysOut;
  private int mostFramesToRest;

  ToolWatch(long seed) {
    random = new SplittableRandom(seed);
  }

  /** Takes note of a frame in which the device moved. */
  void watch(ToolRun run, KeepOut keepOut, Pose device) {
    frames++;
    if (run.motion.steps() == 0 && run.behindMm(device) > AWAY) {
      if (stuck++ % SEARCHED_DIVISOR == 0) {
        searched++;
        waysOut += hasWayOut(run, keepOut, device) ? 1 : 0;
      }
    }
  }

  /** Holds the device and takes note of the frames until the tool rests. */
  void rest(ToolRun run, Pose device) {
    mostFramesToRest = Math.max(mostFramesToRest, run.framesToRest(device));
  }

  private boolean hasWayOut(ToolRun run, KeepOut keepOut, Pose device) {
    Pose pose = run.motion.pose();
    double behindMm = run.behindMm(device);
    pose.differenceTo(device, towards, turnTowards, scratch);
    double radiusMm = Math.max(1e-9, run.tool.rmsRadiusMm());
    for (int step = 0; step < STEPS; step++) {
      double bias = random.nextDouble() / behindMm;
      double lengthMm = Math.pow(10, -1.5 * random.nextDouble());
      randomPart(towards, 3 * bias, 1, shift);
      randomPart(turnTowards, 3 * bias, 1 / radiusMm, turn);
      double scale = lengthMm / Math.hypot(shift.length(), radiusMm * turn.length());
      pose.displace(shift, turn, scale, scratch, trial);
      boolean isNearer = run.tool.metric().distance(trial, device) < behindMm - WAY_OUT;
      if (isNearer && keepOut.isFree(pose, trial)) {
        return true;
      }
    }
    return false;
  }

  private void randomPart(Vec3 wanted, double weight, double spread, Vec3 dest) {
    for (int axis = 0; axis < 3; axis++) {
      dest.set(axis, weight * wanted.get(axis) + spread * random.nextGaussian());
    }
  }

  /** Returns what was seen. */
  List<RigidFigure> figures(String condition) {
    double all = Math.max(1, frames);
    return List.of(
        RigidFigure.of("stuck", condition, "stuck frames", 100.0 * stuck / all, "%"),
        RigidFigure.of("stuck", condition, "stuck frames searched", searched, ""),
        new RigidFigure(
            "stuck",
            condition,
            "searched frames with a way out",
            100.0 * waysOut / Math.max(1, searched),
            "%",
            5),
        new RigidFigure("rest", condition, "frames to rest, most", mostFramesToRest, "", 50));
  }
}
