package org.palpate.force.guide;

import java.util.function.DoubleUnaryOperator;
import org.palpate.force.EffectSite;
import org.palpate.force.HandState;
import org.palpate.force.HapticEffect;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.volume.VoxelGrid;

/**
 * Pushes the tool away from a segment, or pulls it there. A segment that is a body is where the
 * body is. The force depends on the depth of the tool's deepest sample point in a margin around the
 * segment. All points in the margin share it by their depths, so it passes from one to another
 * without a step.
 *
 * <p>A body in hand feels nothing. Haptic thread; allocates nothing.
 */
public final class SegmentPush implements HapticEffect {
  private final SegmentDistance segment;
  private final double marginMm;
  private final DoubleUnaryOperator newton;
  private final EffectSite site;
  private final Vec3 lever = new Vec3();
  private final Vec3 at = new Vec3();
  private final Vec3 outward = new Vec3();
  private final Vec3 push = new Vec3();
  private final Vec3 moment = new Vec3();
  private final Pose atRest = new Pose();
  private double deepestMm;
  private double sumMm;

  /**
   * Creates an effect.
   *
   * @param segment measures at least up to the margin
   * @param marginMm the width of the margin, mm
   * @param newton the push at a depth in mm, N; continuous, 0 at depth 0, negative for a pull
   * @param site the frame that the effect belongs to
   */
  public SegmentPush(
      SegmentDistance segment, double marginMm, DoubleUnaryOperator newton, EffectSite site) {
    this.segment = segment;
    this.marginMm = marginMm;
    this.newton = newton;
    this.site = site;
  }

  @Override
  public void add(HandState hand, Vec3 forceNewton, Vec3 torqueNewtonMm) {
    if (hand.heldBody >= 0) {
      return;
    }
    sumPushes(hand);
    if (sumMm > 0) {
      double factor = newton.applyAsDouble(deepestMm) / sumMm;
      forceNewton.add(push.mul(factor, push), forceNewton);
      if (hand.isRigid) {
        torqueNewtonMm.add(moment.mul(factor, moment), torqueNewtonMm);
      }
    }
  }

  /** Returns the pose of the segment, from rest to present. */
  private Pose pose(HandState hand) {
    int body = segment.body();
    return body >= 0 && body < hand.bodyPoses.size() ? hand.bodyPoses.get(body) : atRest;
  }

  /**
   * Sums the outward directions of all points in the margin and their moments, times the depths.
   */
  private void sumPushes(HandState hand) {
    push.set(0, 0, 0);
    moment.set(0, 0, 0);
    deepestMm = 0;
    sumMm = 0;
    VoxelGrid grid = segment.grid();
    Pose pose = pose(hand);
    for (int n = 0; n < site.points().size(); n++) {
      hand.tool.rotation.rotate(site.points().get(n), lever);
      site.frameToWorld().transform(lever.add(hand.tool.translation, at), at);
      grid.worldToGrid(pose.inverseTransform(at, at), at);
      double depthMm = marginMm - segment.at(at.x, at.y, at.z);
      if (depthMm > 0) {
        segment.gradient(at, outward);
        grid.gridMmToWorld().rotate(outward, outward);
        pose.rotation.rotate(outward, outward);
        site.frameToWorld().inverseRotate(outward, outward).mul(depthMm, outward);
        push.add(outward, push);
        moment.add(lever.cross(outward, outward), moment);
        deepestMm = Math.max(deepestMm, depthMm);
        sumMm += depthMm;
      }
    }
  }
}
