package org.palpate.benchmarks.rigid;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import org.palpate.body.BodyScene;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.RodShape;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.volume.BitCube;

/** Puts a round peg into round holes that are tilted in the grid, with an unsteady hand. */
final class PegStudy {
  private static final double RADIUS_MM = 6;
  private static final double LENGTH_MM = 36;
  private static final int EDGE = 80;
  private static final int MARGIN = 4;
  private static final double BLOCK_DEPTH_MM = 44;

  /** The depth of the peg's tip below the mouth of the hole in the end, mm. */
  private static final double INSERTED_MM = 30;

  private static final double STARTING_GAP_MM = 6;
  private static final double LOWERED_MM_PER_FRAME = 0.15;

  /** The hand is off by this beside the axis, mm, and tilted by this, rad. */
  private static final double OFF_MM = 1.5;

  private static final double OFF_RAD = Math.toRadians(3);

  /** An insertion may end this far above the hand, voxels. */
  private static final double SHORT_OF_DEPTH = 0.5;

  private static final double HOLE_STEP_MM = 0.1;
  private static final Vec3 MOUTH = new Vec3(40.3, 39.6, 58);
  private static final double[] PLAYS = {0.5, 0.75, 1, 1.5};
  private static final double[] TILTS_DEGREES = {0, 10, 20};

  private final int hands;
  private final long seed;
  private final ToolWatch watch;
  private final Vec3 axis = new Vec3();
  private final Vec3 tilt = new Vec3();
  private final Vec3 shift = new Vec3();
  private final Vec3 turn = new Vec3();
  private final Quaternion scratch = new Quaternion();

  /**
   * Creates a study.
   *
   * @param hands the number of insertions for each hole
   */
  PegStudy(int hands, long seed) {
    this.hands = hands;
    this.seed = seed;
    watch = new ToolWatch(seed);
  }

  List<RigidFigure> figures() {
    List<RigidFigure> figures = new ArrayList<>();
    RigidTool peg =
        ToolSampler.ofShape(RodShape.cylinder(RADIUS_MM, LENGTH_MM), MeasuredTools.COVER_MM);
    for (ToolClearance clearance : ToolClearance.values()) {
      for (double tiltDegrees : TILTS_DEGREES) {
        aim(tiltDegrees);
        for (double play : PLAYS) {
          figures.addAll(insertions(peg, clearance, tiltDegrees, play));
        }
      }
    }
    figures.addAll(watch.figures("peg in hole"));
    return figures;
  }

  private void aim(double tiltDegrees) {
    double tiltRad = Math.toRadians(tiltDegrees);
    axis.set(0.8 * Math.sin(tiltRad), 0.6 * Math.sin(tiltRad), Math.cos(tiltRad));
    tilt.set(-0.6 * tiltRad, 0.8 * tiltRad, 0);
  }

  private List<RigidFigure> insertions(
      RigidTool peg, ToolClearance clearance, double tiltDegrees, double play) {
    BodyScene block = block(peg, clearance, play);
    KeepOut keepOut = new KeepOut(block, peg, clearance.clearance(block, peg));
    int failed = 0;
    double mostMissingMm = 0;
    for (int hand = 0; hand < hands; hand++) {
      ToolRun run = new ToolRun(block, peg, clearance);
      double missingMm = insert(run, keepOut, new SplittableRandom(seed + hand));
      failed += missingMm > SHORT_OF_DEPTH ? 1 : 0;
      mostMissingMm = Math.max(mostMissingMm, missingMm);
    }
    String condition =
        String.format(Locale.ROOT, "play %.2f, tilt %.0f, %s", play, tiltDegrees, clearance.option);
    return List.of(
        new RigidFigure("peg", condition, "failed of " + hands + " insertions", failed, "", 0),
        RigidFigure.of("peg", condition, "missing depth, most", mostMissingMm, "mm"));
  }

  /** Returns a block whose hole leaves a play on each side of the peg. */
  private BodyScene block(RigidTool peg, ToolClearance clearance, double play) {
    double holeMm = RADIUS_MM + play - 1;
    BodyScene block;
    double leftMm;
    do {
      holeMm += HOLE_STEP_MM;
      block = SurfaceScene.scene(drilled(holeMm));
      KeepOut keepOut = new KeepOut(block, peg, clearance.clearance(block, peg));
      leftMm = keepOut.distanceFromLineMm(MOUTH, axis) - RADIUS_MM;
    } while (leftMm < play);
    return block;
  }

  /** Returns a block from which voxels with centres near the axis are removed. */
  private BitCube drilled(double holeMm) {
    BitCube bits = new BitCube(EDGE, EDGE, EDGE);
    Vec3 centre = new Vec3();
    for (int k = MARGIN; k < EDGE - MARGIN; k++) {
      for (int j = MARGIN; j < EDGE - MARGIN; j++) {
        for (int i = MARGIN; i < EDGE - MARGIN; i++) {
          centre.set(i + 0.5, j + 0.5, k + 0.5).sub(MOUTH, centre);
          double height = centre.dot(axis);
          boolean isInBlock = height < 0 && height > -BLOCK_DEPTH_MM;
          if (isInBlock && Math.sqrt(centre.dot(centre) - height * height) > holeMm) {
            bits.set(i, j, k);
          }
        }
      }
    }
    return bits;
  }

  /** Lowers the peg; returns the depth along the axis that it is short of the hand, mm. */
  private double insert(ToolRun run, KeepOut keepOut, SplittableRandom random) {
    Pose device = new Pose();
    double heightMm = LENGTH_MM / 2 + STARTING_GAP_MM;
    double lowestMm = LENGTH_MM / 2 - INSERTED_MM;
    double[] wobble = new double[5];
    run.start(device(heightMm, wobble, device));
    while (heightMm > lowestMm) {
      heightMm = Math.max(lowestMm, heightMm - LOWERED_MM_PER_FRAME);
      for (int n = 0; n < wobble.length; n++) {
        wobble[n] += 0.03 * (random.nextGaussian() - 0.5 * wobble[n]);
      }
      run.follow(device(heightMm, wobble, device));
      watch.watch(run, keepOut, device);
    }
    watch.rest(run, device);
    run.motion.pose().translation.sub(device.translation, shift);
    return Math.abs(shift.dot(axis));
  }

  private Pose device(double heightMm, double[] wobble, Pose dest) {
    dest.rotation.setRotationVector(tilt);
    axis.mul(heightMm, dest.translation).add(MOUTH, dest.translation);
    shift.set(OFF_MM + wobble[0], -0.5 * OFF_MM + wobble[1], 0);
    turn.set(OFF_RAD + 0.1 * wobble[2], 0.1 * wobble[3], 0.1 * wobble[4]);
    return dest.displace(shift, turn, 1, scratch, dest);
  }
}
