package org.palpate.reduction;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.device.DeviceState;
import org.palpate.device.HandStop;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.MovableShapes;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.ToolSampler;

/**
 * Plans how a hand that knows the truth puts fragments back: it touches each one from outside,
 * presses a button to hold it, lifts it off, leads it to its place, and lets it go.
 *
 * <p>The order and the ways are those of a {@link Disassembly} in reverse. A fragment that did not
 * come out of its place is led there along the straight line on which it meets the least. When the
 * hand carries the plan out, it trembles, and only verified motions move a fragment, so it may stop
 * before its place. One thread; use bodies of your own, whose poses change.
 */
public final class ReductionPlan {
  /** The most sample points of a fragment at which rough faces are compared. */
  private static final int MOST_POINTS = 4000;

  /** The most of them at which the plan looks for a place to touch. */
  private static final int MOST_TOUCHES = 160;

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

  /** The depth below a touched point that is solid, or the hand would slip off an edge. */
  private static final double DEEP_EDGES = 2;

  private static final double PRESS_SECONDS = 0.4;

  /** The time in which the hand corrects its grip before faces meet. */
  private static final double LOOK_SECONDS = 1;

  private static final double SETTLE_SECONDS = 0.8;

  /** The number of times that the hand brings a fragment home before it puts it aside. */
  private static final int TRIES = 20;

  /** The distance of a fragment that was put aside, as a multiple of the radius of the ball. */
  private static final double ASIDE = 3;

  /** The number of stops that put a fragment aside; a hand that succeeds leaves them out. */
  private static final int STOPS_ASIDE = 4;

  /**
   * The distances to which a fragment goes back for another try, shortest voxel edges. Faces that
   * have met a voxel beside their place come free by a little; others need more room.
   */
  private static final double[] BACK_EDGES = {1, 1.5, 2, 3, 8};

  /** The part of a distance that counts as all of it, because distances of poses are rounded. */
  private static final double WHOLE = 1 - 1e-9;

  /** The distance of a path around the bodies, as a multiple of the radius of their ball. */
  private static final double AROUND = 1.15;

  private static final int PARTS_OF_A_PATH_AROUND = 4;

  private final BodyScene bodies;
  private final BodyScene seen;
  private final FreeLines lines;
  private final List<RigidTool> shapes = new ArrayList<>();
  private final Vec3 middle = new Vec3();
  private final List<HandStop> stops = new ArrayList<>();
  private final List<Disassembly.Exit> exits = new ArrayList<>();
  private double radiusMm;

  /** A point at which the hand takes a fragment, and the direction from which it comes. */
  private record Touch(Vec3 at, Vec3 outward, double score) {}

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
   * {@return a plan}
   *
   * @param bodies the bodies where they are when the hand begins; the plan moves them
   * @param truth the pose at which each body belongs, from rest to present
   * @param seen the bodies that the hand sees while it carries out the plan, in the same order
   */
  public static ReductionPlan of(BodyScene bodies, List<Pose> truth, BodyScene seen) {
    ReductionPlan plan = new ReductionPlan(bodies, seen);
    plan.stops.add(plan.free(plan.outside(new Vec3(0, 0, 1))));
    MovableShapes points = MovableShapes.ofPoints(bodies);
    plan.exits.addAll(Disassembly.of(bodies, truth, points, plan.liftMm()));
    for (int n = plan.exits.size() - 1; n >= 0; n--) {
      Disassembly.Exit exit = plan.exits.get(n);
      plan.putBack(exit.fragment(), plan.way(exit, truth.get(exit.fragment())));
    }
    return plan;
  }

  /** {@return the stops of the hand} */
  public List<HandStop> stops() {
    return List.copyOf(stops);
  }

  /** {@return how the fragments came out of their places, in the reverse order of the plan} */
  public List<Disassembly.Exit> exits() {
    return List.copyOf(exits);
  }

  private double liftMm() {
    return LIFT * radiusMm;
  }

  /** Finds the ball around all sample points. */
  private void measure() {
    List<Vec3> all = new ArrayList<>();
    for (int n = 0; n < bodies.count(); n++) {
      all.addAll(List.of(points(shapes.get(n), bodies.body(n).pose())));
    }
    all.forEach(point -> middle.add(point, middle));
    middle.mul(1.0 / all.size(), middle);
    for (Vec3 point : all) {
      radiusMm = Math.max(radiusMm, point.sub(middle, new Vec3()).length());
    }
  }

  /** Returns the sample points of a body at a pose, world mm. */
  static Vec3[] points(RigidTool shape, Pose pose) {
    Vec3 reference = shape.referenceMm(new Vec3());
    Vec3[] points = new Vec3[shape.count()];
    for (int n = 0; n < points.length; n++) {
      Vec3 point = shape.point(n, new Vec3());
      points[n] = pose.transform(point.add(reference, point), point);
    }
    return points;
  }

  private WayOut wayOut(int fragment, Pose pose) {
    return new WayOut(bodies, fragment, points(shapes.get(fragment), pose), liftMm());
  }

  /** Returns the way out of a fragment; a straight line if none was found. */
  private List<Pose> way(Disassembly.Exit exit, Pose truth) {
    double[] backMm = Arrays.stream(BACK_EDGES).map(n -> n * bodies.shortestEdgeMm()).toArray();
    if (exit.pulled().isOut()) {
      return Ways.simplified(exit.pulled().way(), backMm, shapes.get(exit.fragment()));
    }
    Vec3 away = wayOut(exit.fragment(), truth).direction();
    List<Pose> way = new ArrayList<>(List.of(truth));
    Arrays.stream(backMm).forEach(mm -> way.add(lifted(truth, away, mm)));
    way.add(lifted(truth, away, liftMm()));
    return way;
  }

  /**
   * Adds the stops that lead a fragment home. After the stop that lets it go come the {@link
   * #STOPS_ASIDE} that put it aside if no try succeeds.
   *
   * @param way leads from its place to where it is out
   */
  private void putBack(int fragment, List<Pose> way) {
    Pose truth = way.get(0);
    Pose out = way.get(way.size() - 1);
    Pose start = new Pose().set(bodies.body(fragment).pose());
    Vec3 up = wayOut(fragment, start).direction();
    Touch touch = touch(fragment, start, up);
    Pose startToHand = inverse(start).multiply(take(touch), new Pose());
    hold(lifted(start, up, liftMm()).multiply(startToHand, new Pose()), 0, false);
    Pose handOut = lead(fragment, out, startToHand, LOOK_SECONDS, 0, 0);
    for (int n = way.size() - 2; n > 0; n--) {
      hold(way.get(n).multiply(startToHand, new Pose()), 0, false);
    }
    double backMm = BACK_EDGES[BACK_EDGES.length - 1] * bodies.shortestEdgeMm() * WHOLE;
    int back = Ways.stopsTo(backMm, way, shapes.get(fragment));
    Pose there = lead(fragment, truth, startToHand, SETTLE_SECONDS, TRIES, back);
    stops.add(letGo(there, 1 + STOPS_ASIDE));
    hold(handOut, 0, false);
    Vec3 away = Ways.direction(way, shapes.get(fragment));
    Pose aside = lifted(out, away, ASIDE * radiusMm).multiply(startToHand, new Pose());
    hold(aside, PRESS_SECONDS, true);
    stops.add(letGo(aside, 1));
    Vec3 off = aside.rotation.rotate(touch.outward, new Vec3()).mul(liftMm(), new Vec3());
    stops.add(free(off.add(aside.translation, off)));
    stops.add(free(outside(there.translation.sub(middle, new Vec3()))));
    bodies.body(fragment).setPose(truth);
  }

  private static HandStop letGo(Pose pose, int next) {
    return new HandStop(pose, 0, PRESS_SECONDS, true, Optional.empty(), next);
  }

  private void hold(Pose pose, double seconds, boolean isSteady) {
    stops.add(new HandStop(pose, DeviceState.FIRST_BUTTON, seconds, isSteady));
  }

  /** Adds a stop at which the hand corrects by eye how it holds a fragment; returns its pose. */
  private Pose lead(
      int fragment, Pose goal, Pose startToHand, double seconds, int tries, int back) {
    Pose hand = goal.multiply(startToHand, new Pose());
    int otherwise = 2; // A hand that fails does not let go here.
    Optional<HandStop.Aim> aim =
        Optional.of(new HandStop.Aim(seen.body(fragment)::pose, goal, tries, back, otherwise));
    stops.add(new HandStop(hand, DeviceState.FIRST_BUTTON, seconds, tries > 0, aim, 1));
    return hand;
  }

  private static Pose lifted(Pose pose, Vec3 direction, double mm) {
    Pose lifted = new Pose().set(pose);
    lifted.translation.add(direction.mul(mm, new Vec3()), lifted.translation);
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
  private Pose take(Touch touch) {
    Vec3 far = beyondBall(touch.at, touch.outward);
    goAround(far);
    stops.add(free(far));
    double depthMm = PRESS_EDGES * bodies.shortestEdgeMm();
    Vec3 pressed = touch.outward.mul(-depthMm, new Vec3()).add(touch.at, new Vec3());
    Pose hand = new Pose().set(pressed, new Quaternion());
    stops.add(new HandStop(hand, 0, PRESS_SECONDS, true));
    hold(hand, PRESS_SECONDS, true);
    return hand;
  }

  /**
   * Returns a sample point that a free straight line from outside reaches. Of several it takes the
   * line that is nearest to a preferred direction. Lines away from the middle of the points come
   * first, then all others. Without any it takes the first point.
   */
  private Touch touch(int fragment, Pose start, Vec3 preferred) {
    Vec3[] points = points(shapes.get(fragment).thinned(MOST_TOUCHES), start);
    Vec3 own = new Vec3();
    for (Vec3 point : points) {
      own.add(point, own);
    }
    own.mul(1.0 / points.length, own);
    Touch best = new Touch(points[0], preferred, Double.NEGATIVE_INFINITY);
    for (Vec3 point : points) {
      Vec3 direction = point.sub(own, new Vec3());
      direction.mul(1 / direction.length(), direction);
      best = better(fragment, best, new Touch(point, direction, direction.dot(preferred)));
    }
    for (int n = 0; n < WayOut.DIRECTIONS && best.score == Double.NEGATIVE_INFINITY; n++) {
      Vec3 direction = WayOut.direction(n);
      for (Vec3 point : points) {
        best = better(fragment, best, new Touch(point, direction, direction.dot(preferred)));
      }
    }
    return best;
  }

  /** Returns another touch if the hand can reach it and it has the higher score, else the best. */
  private Touch better(int fragment, Touch best, Touch other) {
    double edgeMm = bodies.shortestEdgeMm();
    Vec3 clear = other.outward.mul(CLEAR_EDGES * edgeMm, new Vec3()).add(other.at, new Vec3());
    Vec3 deep = other.outward.mul(-DEEP_EDGES * edgeMm, new Vec3()).add(other.at, new Vec3());
    return other.score > best.score
            && lines.isSolid(fragment, deep)
            && lines.isFree(clear, beyondBall(other.at, other.outward))
        ? other
        : best;
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
