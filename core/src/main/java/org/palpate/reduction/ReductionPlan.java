package org.palpate.reduction;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.device.DeviceState;
import org.palpate.device.HandStop;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.ToolSampler;

/**
 * Plans how a hand that knows the truth puts fragments back: it touches each one from outside,
 * presses a button to hold it, lifts it off, leads it to its place in the direction with the widest
 * opening, and lets it go.
 *
 * <p>The plan is geometry alone and verifies no motion. When the hand carries it out, only verified
 * motions move a fragment, so it may stop before its place. One thread; use bodies of your own,
 * whose poses change.
 */
public final class ReductionPlan {
  /** The most sample points of a fragment that the plan looks at. */
  private static final int MOST_POINTS = 160;

  /**
   * The distance by which a fragment is lifted off and from which it approaches its place, as a
   * fraction of the radius of the ball around all bodies.
   */
  private static final double LIFT = 0.55;

  /** The depth below the touched point to which the hand presses, shortest voxel edges. */
  private static final double PRESS_EDGES = 1;

  /**
   * The distance from a touched point beyond which a straight line outwards must be free, shortest
   * voxel edges.
   */
  private static final double CLEAR_EDGES = 2;

  private static final double PRESS_SECONDS = 0.4;
  private static final double SETTLE_SECONDS = 1.2;

  /** The distance of a path around the bodies, as a multiple of the radius of their ball. */
  private static final double AROUND = 1.15;

  private static final int PARTS_OF_A_PATH_AROUND = 4;

  private final BodyScene bodies;
  private final BodyScene seen;
  private final FreeLines lines;
  private final List<RigidTool> shapes = new ArrayList<>();
  private final Vec3 middle = new Vec3();
  private final List<HandStop> stops = new ArrayList<>();
  private double radiusMm;

  private ReductionPlan(BodyScene bodies, BodyScene seen) {
    this.bodies = bodies;
    this.seen = seen;
    lines = new FreeLines(bodies);
    for (int n = 0; n < bodies.count(); n++) {
      Body body = bodies.body(n);
      shapes.add(ToolSampler.ofSegment(body.bits(), body.grid()).thinned(MOST_POINTS));
    }
    measure();
  }

  /**
   * Returns the stops of the hand.
   *
   * @param bodies the bodies where they are when the hand begins; the plan moves them
   * @param truth the pose at which each body belongs, from rest to present; the next body to move
   *     is always the one that belongs nearest to the bodies in place
   * @param seen the bodies that the hand sees while it carries out the plan, in the same order
   */
  public static List<HandStop> of(BodyScene bodies, List<Pose> truth, BodyScene seen) {
    ReductionPlan plan = new ReductionPlan(bodies, seen);
    List<Integer> left = new ArrayList<>();
    for (int n = 0; n < bodies.count(); n++) {
      if (bodies.body(n).mobility() == Mobility.MOVABLE) {
        left.add(n);
      }
    }
    plan.stops.add(plan.free(plan.outside(new Vec3(0, 0, 1))));
    while (!left.isEmpty()) {
      int next = plan.nearestToOthers(left, truth);
      left.remove(Integer.valueOf(next));
      plan.putBack(next, truth.get(next));
    }
    return plan.stops;
  }

  private double liftMm() {
    return LIFT * radiusMm;
  }

  /** Finds the ball around all sample points. */
  private void measure() {
    List<Vec3> all = new ArrayList<>();
    for (int n = 0; n < bodies.count(); n++) {
      all.addAll(List.of(points(n, bodies.body(n).pose())));
    }
    all.forEach(point -> middle.add(point, middle));
    middle.mul(1.0 / all.size(), middle);
    for (Vec3 point : all) {
      radiusMm = Math.max(radiusMm, point.sub(middle, new Vec3()).length());
    }
  }

  /** Returns the sample points of a body at a pose, world mm. */
  private Vec3[] points(int body, Pose pose) {
    RigidTool shape = shapes.get(body);
    Vec3 reference = shape.referenceMm(new Vec3());
    Vec3[] points = new Vec3[shape.count()];
    for (int n = 0; n < points.length; n++) {
      Vec3 point = shape.point(n, new Vec3());
      points[n] = pose.transform(point.add(reference, point), point);
    }
    return points;
  }

  /** Returns the body of a list that belongs nearest to those that are not in it. */
  private int nearestToOthers(List<Integer> left, List<Pose> truth) {
    int nearest = left.get(0);
    double least = Double.POSITIVE_INFINITY;
    for (int candidate : left) {
      double distance = gapToOthers(candidate, left, truth);
      if (distance < least) {
        least = distance;
        nearest = candidate;
      }
    }
    return nearest;
  }

  /** Returns a typical gap: the tenth part of all points that lies nearest to the others. */
  private double gapToOthers(int candidate, List<Integer> left, List<Pose> truth) {
    Vec3[] own = points(candidate, truth.get(candidate));
    double[] gaps = new double[own.length];
    Arrays.fill(gaps, Double.POSITIVE_INFINITY);
    for (int other = 0; other < bodies.count(); other++) {
      if (other == candidate || left.contains(other)) {
        continue;
      }
      for (Vec3 point : points(other, truth.get(other))) {
        for (int n = 0; n < own.length; n++) {
          gaps[n] = Math.min(gaps[n], own[n].sub(point, new Vec3()).length());
        }
      }
    }
    Arrays.sort(gaps);
    return gaps[gaps.length / 10];
  }

  private void putBack(int fragment, Pose truth) {
    Pose start = new Pose().set(bodies.body(fragment).pose());
    Vec3 up = lines.widest(fragment, points(fragment, start), liftMm());
    Vec3 away = lines.widest(fragment, points(fragment, truth), liftMm());
    Pose hand = touch(fragment, start, up);
    Pose startToHand = inverse(start).multiply(hand, new Pose());
    hold(lifted(start, up).multiply(startToHand, new Pose()), 0, false);
    hold(lifted(truth, away).multiply(startToHand, new Pose()), 0, false);
    Pose there = truth.multiply(startToHand, new Pose());
    Body led = seen.body(fragment);
    stops.add(
        new HandStop(
            there,
            DeviceState.FIRST_BUTTON,
            SETTLE_SECONDS,
            true,
            Optional.of(new HandStop.Aim(led::pose, truth))));
    stops.add(new HandStop(there, 0, PRESS_SECONDS, true));
    Vec3 outward = there.translation.sub(middle, new Vec3());
    stops.add(free(outside(outward)));
    bodies.body(fragment).setPose(truth);
  }

  private void hold(Pose pose, double seconds, boolean isSteady) {
    stops.add(new HandStop(pose, DeviceState.FIRST_BUTTON, seconds, isSteady));
  }

  private Pose lifted(Pose pose, Vec3 direction) {
    Pose lifted = new Pose().set(pose);
    lifted.translation.add(direction.mul(liftMm(), new Vec3()), lifted.translation);
    return lifted;
  }

  private static Pose inverse(Pose pose) {
    Pose inverse = new Pose();
    pose.rotation.conjugate(inverse.rotation);
    inverse.rotation.rotate(pose.translation, inverse.translation);
    inverse.translation.mul(-1, inverse.translation);
    return inverse;
  }

  /** Adds the stops that touch a fragment and take hold of it; returns the pose of the hand. */
  private Pose touch(int fragment, Pose start, Vec3 preferred) {
    Vec3 at = new Vec3();
    Vec3 outward = new Vec3().set(preferred);
    chooseTouch(points(fragment, start), preferred, at, outward);
    Vec3 far = beyondBall(at, outward);
    goAround(far);
    stops.add(free(far));
    Vec3 pressed =
        outward.mul(-PRESS_EDGES * bodies.shortestEdgeMm(), new Vec3()).add(at, new Vec3());
    Pose hand = new Pose().set(pressed, new Quaternion());
    stops.add(new HandStop(hand, 0, PRESS_SECONDS, true));
    hold(hand, PRESS_SECONDS, true);
    return hand;
  }

  /**
   * Chooses a sample point that a free straight line from outside reaches, and the direction of the
   * line. Of several it chooses the direction nearest to a preferred one. Without any it chooses
   * the first point.
   */
  private void chooseTouch(Vec3[] points, Vec3 preferred, Vec3 at, Vec3 outward) {
    double clearMm = CLEAR_EDGES * bodies.shortestEdgeMm();
    Vec3 own = new Vec3();
    for (Vec3 point : points) {
      own.add(point, own);
    }
    own.mul(1.0 / points.length, own);
    at.set(points[0]);
    double best = Double.NEGATIVE_INFINITY;
    for (Vec3 point : points) {
      Vec3 direction = point.sub(own, new Vec3());
      direction.mul(1 / direction.length(), direction);
      double score = direction.dot(preferred);
      Vec3 clear = direction.mul(clearMm, new Vec3()).add(point, new Vec3());
      if (score > best && lines.isFree(clear, beyondBall(point, direction))) {
        best = score;
        at.set(point);
        outward.set(direction);
      }
    }
  }

  /** Returns the point on a ray that leaves the ball around all bodies. */
  private Vec3 beyondBall(Vec3 from, Vec3 direction) {
    Vec3 offset = from.sub(middle, new Vec3());
    double along = offset.dot(direction);
    double r = AROUND * radiusMm;
    double root = Math.sqrt(Math.max(0, along * along - offset.dot(offset) + r * r));
    return direction.mul(root - along, new Vec3()).add(from, new Vec3());
  }

  private Vec3 outside(Vec3 direction) {
    Vec3 far = direction.mul(AROUND * radiusMm / direction.length(), new Vec3());
    return far.add(middle, far);
  }

  /** Adds stops around the ball of all bodies, from the last stop to a point outside. */
  private void goAround(Vec3 to) {
    Vec3 from = stops.get(stops.size() - 1).pose().translation.sub(middle, new Vec3());
    Vec3 end = to.sub(middle, new Vec3());
    for (int n = 1; n < PARTS_OF_A_PATH_AROUND; n++) {
      double part = (double) n / PARTS_OF_A_PATH_AROUND;
      Vec3 between = from.mul(1 - part, new Vec3()).add(end.mul(part, new Vec3()), new Vec3());
      if (between.length() > 0) {
        stops.add(free(outside(between)));
      }
    }
  }

  private HandStop free(Vec3 position) {
    return new HandStop(new Pose().set(position, new Quaternion()), 0, 0, false);
  }
}
