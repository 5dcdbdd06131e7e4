package org.palpate.reduction;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.device.DeviceState;
import org.palpate.device.HandStop;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;
import org.palpate.reduction.TouchSearch.Touch;
import org.palpate.rigid.MovableShapes;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.ToolSampler;

/**
 * Plans how a hand that knows the truth puts fragments back: it touches each one from outside,
 * presses a button to hold it, lifts it off, leads it to its place, and lets it go.
 *
 * <p>The order and the ways are those of a {@link Disassembly} in reverse. Before the hand puts a
 * fragment back, it clears those away that lie in its way and are not in place yet. If the fragment
 * does not arrive on one way, the hand tries the next. A fragment that did not come out of its
 * place is led there along the straight line on which it meets the least. When the hand carries the
 * plan out, it trembles, and only verified motions move a fragment, so it may stop before its
 * place. One thread; use bodies of your own, whose poses change.
 */
public final class ReductionPlan {
  /** The most sample points of a fragment at which rough faces are compared. */
  private static final int MOST_POINTS = 4000;

  /**
   * The distance by which a fragment is lifted off and from which it approaches its place, as a
   * fraction of the radius of the ball around all bodies.
   */
  private static final double LIFT = 0.55;

  /** The depth below the touched point to which the hand presses, shortest voxel edges. */
  private static final double PRESS_EDGES = 1;

  private static final double PRESS_SECONDS = 0.4;

  /** The time in which the hand corrects its grip before faces meet. */
  private static final double LOOK_SECONDS = 1;

  /** The number of times that the hand brings a fragment home on a way before it tries another. */
  private static final int TRIES = 8;

  /** The number of ways that it tries; if there are fewer, it tries them again. */
  private static final int WAYS = 3;

  /** The distance of a fragment that was put aside, as a multiple of the radius of the ball. */
  private static final double ASIDE = 3;

  /** The same for one that was cleared away. */
  private static final double CLEARED = 0.8;

  /**
   * The number of stops that put a fragment aside and lead back around the bodies: one outside, the
   * three of {@link #putDown}, and those of {@link #goAround}. A hand that succeeds leaves them
   * out.
   */
  private static final int STOPS_ASIDE = 1 + 3 + BallAround.POINTS_BETWEEN;

  /** The most sample points of a fragment that show whether another lies in its way. */
  private static final int POINTS_IN_THE_WAY = 300;

  /** The distance of the poses of a way at which that is tested, shortest voxel edges. */
  private static final double PACE_EDGES = 2;

  private final BodyScene bodies;
  private final BodyScene seen;
  private final List<RigidTool> shapes = new ArrayList<>();
  private final BallAround ball;
  private final TouchSearch touches;
  private final List<HandStop> stops = new ArrayList<>();
  private final List<Disassembly.Exit> exits = new ArrayList<>();

  /** The stop from which the hand first goes straight to a fragment. */
  private int firstApproach;

  /** The fragments that are not in place yet and can be cleared away. */
  private final List<Integer> scattered = new ArrayList<>();

  private final FragmentPlaces places;

  private ReductionPlan(BodyScene bodies, BodyScene seen) {
    this.bodies = bodies;
    this.seen = seen;
    for (int n = 0; n < bodies.count(); n++) {
      Body body = bodies.body(n);
      shapes.add(ToolSampler.ofSegment(body.bits(), body.grid()).thinned(MOST_POINTS));
    }
    places =
        new FragmentPlaces(
            bodies, shapes.stream().map(each -> each.thinned(POINTS_IN_THE_WAY)).toList());
    List<Vec3> points = new ArrayList<>();
    for (int n = 0; n < bodies.count(); n++) {
      points.addAll(List.of(points(shapes.get(n), bodies.body(n).pose())));
    }
    ball = new BallAround(points);
    touches = new TouchSearch(bodies, shapes, ball);
  }

  /**
   * {@return a plan}
   *
   * @param bodies the bodies where they are when the hand begins; the plan moves them
   * @param truth the pose at which each body belongs, from rest to present
   * @param points the sample points of the bodies that the hand will move, and their clearance
   * @param seen the bodies that the hand sees while it carries out the plan, in the same order
   * @throws java.util.concurrent.CancellationException if the thread is interrupted
   */
  public static ReductionPlan of(
      BodyScene bodies, List<Pose> truth, MovableShapes points, BodyScene seen) {
    ReductionPlan plan = new ReductionPlan(bodies, seen);
    plan.stops.add(plan.free(plan.ball.outside(new Vec3(0, 0, 1))));
    plan.exits.addAll(Disassembly.of(bodies, truth, points, plan.liftMm()));
    plan.exits.forEach(exit -> plan.scattered.add(exit.fragment()));
    for (int n = plan.exits.size() - 1; n >= 0; n--) {
      Disassembly.Exit exit = plan.exits.get(n);
      plan.scattered.remove(Integer.valueOf(exit.fragment()));
      plan.putBack(exit.fragment(), plan.ways(exit, truth.get(exit.fragment())));
    }
    return plan;
  }

  /** {@return the stops of the hand} */
  public List<HandStop> stops() {
    return List.copyOf(stops);
  }

  /**
   * {@return the index of the stop from which the hand first goes straight to a fragment} Before it
   * the hand touches nothing; 0 if it touches nothing at all.
   */
  public int firstApproach() {
    return firstApproach;
  }

  /** {@return how the fragments came out of their places, in the reverse order of the plan} */
  public List<Disassembly.Exit> exits() {
    return List.copyOf(exits);
  }

  private double liftMm() {
    return LIFT * ball.radiusMm();
  }

  /** Sets where the plan leaves a fragment. */
  private void leave(int fragment, Pose pose) {
    bodies.body(fragment).setPose(pose);
    ball.reachTo(farthestMm());
  }

  private double farthestMm() {
    double farMm = 0;
    for (int n = 0; n < bodies.count(); n++) {
      farMm = Math.max(farMm, places.farthestMm(n, ball.middle()));
    }
    return farMm;
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

  /** Returns the ways out of a fragment, the best first; a straight line if none was found. */
  private List<WayHome> ways(Disassembly.Exit exit, Pose truth) {
    double edgeMm = bodies.shortestEdgeMm();
    RigidTool shape = shapes.get(exit.fragment());
    if (!exit.pulled().isOut()) {
      Vec3 away = wayOut(exit.fragment(), truth).direction();
      return List.of(WayHome.straight(truth, away, liftMm(), edgeMm, shape));
    }
    List<WayHome> ways = new ArrayList<>();
    ways.add(WayHome.of(exit.pulled().way(), edgeMm, shape));
    exit.others().forEach(other -> ways.add(WayHome.of(other.way(), edgeMm, shape)));
    return ways;
  }

  /**
   * Adds the stops that clear the way of a fragment and lead it home. After the stop that lets it
   * go come the {@link #STOPS_ASIDE} that put it aside if no try succeeds.
   *
   * @param ways lead from its place to where it is out, the best first
   */
  private void putBack(int fragment, List<WayHome> ways) {
    clear(fragment, ways.get(0));
    Pose start = new Pose().set(bodies.body(fragment).pose());
    Vec3 up = wayOut(fragment, start).direction();
    Touch touch = touch(fragment, up, ways.get(0).place());
    Pose startToHand = inverse(start).multiply(take(touch), new Pose());
    hold(lifted(start, up).multiply(startToHand, new Pose()), 0, false);
    for (int n = 0; n < WAYS; n++) {
      lead(fragment, ways.get(n % ways.size()), startToHand, stopsFrom(n + 1, ways));
    }
    WayHome last = ways.get((WAYS - 1) % ways.size());
    Pose there = last.place().multiply(startToHand, new Pose());
    stops.add(letGo(there, 1 + STOPS_ASIDE));
    hold(last.out().multiply(startToHand, new Pose()), 0, false);
    Vec3 away = Ways.direction(last.poses(), shapes.get(fragment));
    Pose aside = WayHome.shifted(last.out(), away, ASIDE * ball.radiusMm());
    Pose asideHand = aside.multiply(startToHand, new Pose());
    Vec3 back = asideHand.rotation.rotate(touch.outward(), new Vec3()).mul(liftMm(), new Vec3());
    putDown(asideHand, back.add(asideHand.translation, back));
    Vec3 off = ball.beyond(there.translation, touch.off());
    goAround(off);
    stops.add(free(off));
    leave(fragment, last.place());
  }

  /** Returns the number of stops on all ways from a way on. */
  private static int stopsFrom(int first, List<WayHome> ways) {
    int count = 0;
    for (int n = first; n < WAYS; n++) {
      count += 1 + ways.get(n % ways.size()).stops();
    }
    return count;
  }

  /**
   * Adds the stops that lead a fragment from where it is out to its place.
   *
   * @param after the number of stops on other ways that follow, before the one that lets it go
   */
  private void lead(int fragment, WayHome way, Pose startToHand, int after) {
    correct(fragment, way.out(), startToHand, false);
    int otherwise = after > 0 ? 1 : 2; // A hand that fails does not let go here.
    way.addTo(stops, startToHand, seen.body(fragment)::pose, TRIES, 1 + after, otherwise);
  }

  /** Clears the fragments away that are not in place yet and lie in the way of another. */
  private void clear(int fragment, WayHome way) {
    for (int other : List.copyOf(scattered)) {
      Pose pose = bodies.body(other).pose();
      if (motion(fragment, way).stream().anyMatch(at -> places.meet(fragment, at, other, pose))) {
        scattered.remove(Integer.valueOf(other));
        clearAway(other);
      }
    }
  }

  /** Returns poses of a fragment from where it lies to its place. */
  private List<Pose> motion(int fragment, WayHome way) {
    Pose start = bodies.body(fragment).pose();
    List<Pose> ends = new ArrayList<>(List.of(start));
    ends.add(lifted(start, wayOut(fragment, start).direction()));
    for (int n = way.poses().size() - 1; n >= 0; n--) {
      ends.add(way.poses().get(n));
    }
    return Ways.paced(ends, PACE_EDGES * bodies.shortestEdgeMm(), shapes.get(fragment));
  }

  /** Adds the stops that take a fragment away from where it lies, out of the ball. */
  private void clearAway(int fragment) {
    Pose start = new Pose().set(bodies.body(fragment).pose());
    Vec3 up = wayOut(fragment, start).direction();
    Pose lifted = lifted(start, up);
    Vec3 reference = shapes.get(fragment).referenceMm(new Vec3());
    Vec3 out = ball.away(lifted.transform(reference, new Vec3()));
    Pose away = WayHome.shifted(lifted, out, CLEARED * ball.radiusMm());
    Touch touch = touch(fragment, up, away);
    Pose startToHand = inverse(start).multiply(take(touch), new Pose());
    hold(lifted.multiply(startToHand, new Pose()), 0, false);
    correct(fragment, away, startToHand, true);
    Pose hand = away.multiply(startToHand, new Pose());
    putDown(hand, ball.beyond(hand.translation, touch.off()));
    leave(fragment, away);
  }

  /** Adds the stops that let a fragment go and leave it for a point. */
  private void putDown(Pose hand, Vec3 off) {
    hold(hand, PRESS_SECONDS, true);
    stops.add(letGo(hand, 1));
    stops.add(free(off));
  }

  private static HandStop letGo(Pose pose, int next) {
    return new HandStop(pose, 0, PRESS_SECONDS, true, Optional.empty(), next);
  }

  private void hold(Pose pose, double seconds, boolean isSteady) {
    stops.add(new HandStop(pose, DeviceState.FIRST_BUTTON, seconds, isSteady));
  }

  /** Adds a stop at which the hand corrects by eye how it holds a fragment. */
  private void correct(int fragment, Pose goal, Pose startToHand, boolean isSteady) {
    Optional<HandStop.Aim> aim =
        Optional.of(new HandStop.Aim(seen.body(fragment)::pose, goal, 0, 0, 1));
    Pose hand = goal.multiply(startToHand, new Pose());
    stops.add(new HandStop(hand, DeviceState.FIRST_BUTTON, LOOK_SECONDS, isSteady, aim, 1));
  }

  private Pose lifted(Pose pose, Vec3 direction) {
    return WayHome.shifted(pose, direction, liftMm());
  }

  private static Pose inverse(Pose pose) {
    Pose inverse = new Pose();
    pose.rotation.conjugate(inverse.rotation);
    inverse.rotation.rotate(pose.translation, inverse.translation);
    inverse.translation.mul(-1, inverse.translation);
    return inverse;
  }

  /** Finds where to touch a fragment that is taken now and let go at another pose. */
  private Touch touch(int fragment, Vec3 preferred, Pose end) {
    Body body = bodies.body(fragment);
    double farMm = farthestMm();
    Pose start = new Pose().set(body.pose());
    body.setPose(end);
    ball.reachTo(Math.max(farMm, places.farthestMm(fragment, ball.middle())));
    body.setPose(start);
    return touches.find(fragment, end, preferred);
  }

  /** Adds the stops that touch a fragment and take hold of it; returns the pose of the hand. */
  private Pose take(Touch touch) {
    Vec3 far = ball.beyond(touch.at(), touch.outward());
    goAround(far);
    if (firstApproach == 0) {
      firstApproach = stops.size();
    }
    stops.add(free(far));
    double depthMm = PRESS_EDGES * bodies.shortestEdgeMm();
    Vec3 pressed = touch.outward().mul(-depthMm, new Vec3()).add(touch.at(), new Vec3());
    Pose hand = new Pose().set(pressed, new Quaternion());
    stops.add(new HandStop(hand, 0, PRESS_SECONDS, true));
    hold(hand, PRESS_SECONDS, true);
    return hand;
  }

  /** Adds stops around the ball of all bodies, from the last stop to a point outside. */
  private void goAround(Vec3 to) {
    Vec3 from = stops.get(stops.size() - 1).pose().translation;
    ball.between(from, to).forEach(point -> stops.add(free(point)));
  }

  private HandStop free(Vec3 position) {
    return new HandStop(new Pose().set(position, new Quaternion()), 0, 0, false);
  }
}
