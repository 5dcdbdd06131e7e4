package org.palpate.reduction;

import java.util.ArrayList;
import java.util.List;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.ReferencePose;
import org.palpate.rigid.tool.RigidTool;

/** Computations on ways of a fragment, which lead from its place to where it is out. */
final class Ways {
  /** The farthest that a simplified way leads from the whole one, in the kinetic metric, mm. */
  private static final double DEVIATION_MM = 0.05;

  /** The largest distance of poses at which a way can be divided, in the kinetic metric, mm. */
  private static final double DENSE_MM = 0.25;

  private Ways() {}

  /**
   * Leaves out poses of a way that lie nearly on the motion between others. For each of the given
   * distances, it keeps the first pose that is at least so far from the place.
   *
   * @param found poses from rest to present
   * @param keptMm distances in the kinetic metric, the shortest first
   */
  static List<Pose> simplified(List<Pose> found, double[] keptMm, RigidTool shape) {
    List<Pose> way = dense(found, shape);
    List<Pose> kept = new ArrayList<>(List.of(way.get(0)));
    int from = 0;
    for (double mm : keptMm) {
      int to = Math.max(from, stopsTo(mm, way, shape));
      addSimplified(way.subList(from, to + 1), shape, kept);
      from = to;
    }
    addSimplified(way.subList(from, way.size()), shape, kept);
    return kept;
  }

  /** Returns a way with poses between those that are far from each other. */
  private static List<Pose> dense(List<Pose> way, RigidTool shape) {
    return paced(way, DENSE_MM, shape);
  }

  /** Returns a way with poses between those that are farther from each other than a distance. */
  static List<Pose> paced(List<Pose> way, double paceMm, RigidTool shape) {
    List<Pose> dense = new ArrayList<>(List.of(way.get(0)));
    for (int n = 1; n < way.size(); n++) {
      Pose from = way.get(n - 1);
      Pose to = way.get(n);
      double mm = shape.metric().distance(reference(from, shape), reference(to, shape));
      int parts = Math.max(1, (int) Math.ceil(mm / paceMm));
      for (int k = 1; k < parts; k++) {
        dense.add(between(from, to, (double) k / parts, shape));
      }
      dense.add(to);
    }
    return dense;
  }

  /** Adds the poses of a part of a way but the first, without those that lie between others. */
  private static void addSimplified(List<Pose> way, RigidTool shape, List<Pose> dest) {
    int last = 0;
    for (int n = 2; n < way.size(); n++) {
      if (!isNearMotion(way, last, n, shape)) {
        last = n - 1;
        dest.add(way.get(last));
      }
    }
    if (way.size() > 1) {
      dest.add(way.get(way.size() - 1));
    }
  }

  /** Whether the poses between two others lie near the even motion from one to the other. */
  private static boolean isNearMotion(List<Pose> way, int from, int to, RigidTool shape) {
    Pose.Scratch scratch = new Pose.Scratch();
    Pose begin = reference(way.get(from), shape);
    Pose end = reference(way.get(to), shape);
    double longMm = shape.metric().distance(begin, end);
    Pose even = new Pose();
    for (int n = from + 1; n < to; n++) {
      Pose pose = reference(way.get(n), shape);
      double part = Math.min(1, shape.metric().distance(begin, pose) / longMm);
      begin.interpolate(end, part, scratch, even);
      if (shape.metric().distance(even, pose) > DEVIATION_MM) {
        return false;
      }
    }
    return true;
  }

  /** Returns a pose between two others, on the even motion about the reference point. */
  private static Pose between(Pose from, Pose to, double part, RigidTool shape) {
    Pose at = reference(from, shape);
    at.interpolate(reference(to, shape), part, new Pose.Scratch(), at);
    return new ReferencePose(shape.referenceMm(new Vec3()))
        .toRest(ReferencePose.snap(at), new Pose());
  }

  private static Pose reference(Pose pose, RigidTool shape) {
    return new ReferencePose(shape.referenceMm(new Vec3())).toReference(pose, new Pose());
  }

  /** Returns the index of the first pose that is at least so far from the place, or the last. */
  static int stopsTo(double mm, List<Pose> way, RigidTool shape) {
    Pose home = reference(way.get(0), shape);
    int n = 1;
    while (n < way.size() - 1 && shape.metric().distance(home, reference(way.get(n), shape)) < mm) {
      n++;
    }
    return n;
  }

  /** Returns the direction from the place to where a fragment is out, a unit vector. */
  static Vec3 direction(List<Pose> way, RigidTool shape) {
    Vec3 out = reference(way.get(way.size() - 1), shape).translation;
    Vec3 direction = out.sub(reference(way.get(0), shape).translation, new Vec3());
    return direction.mul(1 / direction.length(), direction);
  }
}
