package org.palpate.reduction;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.CancellationException;
import org.palpate.body.BodyScene;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.Clearance;
import org.palpate.rigid.MovableShapes;
import org.palpate.rigid.ReferencePose;
import org.palpate.rigid.RigidScene;
import org.palpate.rigid.RigidSettings;
import org.palpate.rigid.RigidSolver;
import org.palpate.rigid.ToolMotion;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.ToolSampler;

/**
 * Pulls a fragment out of its place between others, as a person takes a puzzle apart to see how it
 * goes together. The rigid solver carries each pull out, so a way consists of verified motions, and
 * a fragment slides along what it meets.
 *
 * <p>If no way is found, there may still be one. World mm; poses are rest to present. One thread.
 *
 * <p>Reference for {@link #around}: S. LaValle, Rapidly-exploring random trees, 1998.
 */
public final class PullSearch {
  /** The number of random pulls; each leads on from a pose that was reached. */
  private static final int RANDOM_PULLS = 600;

  /** A pull ends after so many frames, or so many without progress. */
  private static final int MOST_FRAMES = 80;

  private static final int IDLE_FRAMES = 3;
  private static final int IDLE_SHAKEN_FRAMES = 20;

  /** The least progress of a frame, shortest voxel edges. */
  private static final double PROGRESS_EDGES = 0.01;

  private static final double SHAKEN_PROGRESS_EDGES = 0.05;

  /** The motion of the hand in a frame of a shaken pull, edges. */
  private static final double ADVANCE_EDGES = 0.14;

  /** The largest distance by which it shakes from there, edges. */
  private static final double SHAKE_EDGES = 0.4;

  /** The length of a shaken pull that leads all the way out, edges. */
  private static final double LONGEST_SHAKEN_EDGES = 14;

  /** The least distance of two poses that are kept, in the kinetic metric, edges. */
  private static final double APART_EDGES = 0.15;

  /** The longest random pull but for those that lead all the way out, edges. */
  private static final double PULL_EDGES = 6;

  private static final double LARGEST_TURN_RAD = 0.3;

  /** One random pull in this many leads all the way out. */
  private static final int LONG_ONE_IN = 4;

  /** One random pull in this many is shaken. */
  private static final int SHAKEN_ONE_IN = 3;

  /** One random pull in this many turns nothing. */
  private static final int STRAIGHT_ONE_IN = 3;

  /** A pull leads on from the farthest of up to 2^8 poses that are drawn at random. */
  private static final int MOST_DOUBLINGS = 8;

  /** A fragment is out at this part of the distance that was asked for. */
  private static final double OUT_PART = 0.9;

  /** A way with a detour of at most this counts as straight, edges. */
  private static final double STRAIGHT_EDGES = 0.5;

  /** The cosine of the least angle between the directions of two ways. */
  private static final double SAME_DIRECTION = 0.97;

  private static final double MAX_STEP_MM = 8;

  /** The distance of the tool that holds nothing, and of fragments in nobody's way, mm. */
  private static final double ABSENT_MM = 10_000;

  /** The place of the tool that holds nothing; not to be written. */
  static final Pose NOWHERE = Pose.at(-ABSENT_MM, 0, 0);

  private final BodyScene bodies;
  private final RigidSolver point;
  private final RigidSolver[] hands;
  private final ReferencePose[] references;
  private final ToolMotion motion;
  private final double edgeMm;
  private final Pose home = new Pose();
  private final Pose target = new Pose();
  private final Pose seen = new Pose();
  private final Quaternion scratch = new Quaternion();

  /**
   * The farthest that a fragment came.
   *
   * @param way the poses from its place to where it is out, both included; empty if it did not come
   *     out
   * @param farthestMm the largest distance of its reference point from its place
   * @param detourMm the length by which the way is longer than the motion from its first pose to
   *     its last, in the kinetic metric; infinite if it did not come out
   */
  public record Pulled(List<Pose> way, double farthestMm, double detourMm) {
    /** {@return whether a way out was found} */
    public boolean isOut() {
      return !way.isEmpty();
    }
  }

  /** A pose that was reached, after those on the way to it. The first is where it belongs. */
  private record Reached(Pose body, Reached before, double farMm, double pathMm) {}

  /**
   * Creates a search.
   *
   * @param bodies the bodies in their places; the search moves them
   * @param shapes their sample points
   * @throws RigidScene.BodiesOverlapException if two bodies overlap in their places
   */
  public PullSearch(BodyScene bodies, MovableShapes shapes) {
    this.bodies = bodies;
    point = solver(bodies, shapes);
    motion = point.newMotion();
    edgeMm = bodies.shortestEdgeMm();
    hands = new RigidSolver[bodies.count()];
    references = new ReferencePose[bodies.count()];
    for (int n = 0; n < hands.length; n++) {
      if (point.canMove(n)) {
        hands[n] = point.ofBody(n, false); // along faces, fewer random pulls lead out
        references[n] = new ReferencePose(shapes.shapes().get(n).referenceMm(new Vec3()));
      }
    }
  }

  /** Returns a solver of a tool that holds nothing, whose solvers of bodies move them. */
  static RigidSolver solver(BodyScene bodies, MovableShapes shapes) {
    RigidSettings settings = RigidSettings.of(MAX_STEP_MM, Clearance.POINTS);
    return new RigidSolver(new RigidScene(bodies, ToolSampler.point(), shapes, settings));
  }

  /** Throws if the thread is interrupted, which says that nobody waits for the result. */
  static void requireWanted() {
    if (Thread.currentThread().isInterrupted()) {
      throw new CancellationException("the thread that plans was interrupted");
    }
  }

  /** Returns the bodies where they are. */
  BodyScene bodies() {
    return bodies;
  }

  /**
   * Puts a fragment somewhere, unverified.
   *
   * @param fragment its index
   * @param pose rest to present
   */
  public void put(int fragment, Pose pose) {
    bodies.body(fragment).setPose(pose);
  }

  /**
   * Takes a fragment away, so that it is in nobody's way.
   *
   * @param fragment its index
   */
  public void remove(int fragment) {
    put(fragment, Pose.at((1 + fragment) * ABSENT_MM, 0, 0));
  }

  /**
   * Pulls a fragment straight along many directions.
   *
   * @param fragment its index
   * @param first the direction that comes first, a unit vector
   * @param reachMm the distance from its place at which it is out
   * @param most the most ways; the search ends once so many lead out without a detour
   * @return the ways out in different directions, that with the least detour first; it is back in
   *     its place
   * @throws CancellationException if the thread is interrupted
   */
  public List<Pulled> straight(int fragment, Vec3 first, double reachMm, int most) {
    Reached start = begin(fragment);
    List<Pulled> ways = new ArrayList<>();
    int straight = 0;
    for (int n = -1; n < WayOut.DIRECTIONS && straight < most; n++) {
      Vec3 shift = (n < 0 ? first : WayOut.direction(n)).mul(reachMm, new Vec3());
      Pulled pulled = pulled(fragment, pull(fragment, start, shift, new Vec3()), reachMm);
      if (pulled.isOut() && add(fragment, pulled, ways)) {
        straight += isStraight(pulled) ? 1 : 0;
      }
    }
    put(fragment, home);
    ways.sort(Comparator.comparingDouble(Pulled::detourMm));
    return List.copyOf(ways.subList(0, Math.min(most, ways.size())));
  }

  /** Adds a way if it leads elsewhere, or instead of one that leads there on a longer detour. */
  private boolean add(int fragment, Pulled pulled, List<Pulled> ways) {
    RigidTool shape = hands[fragment].shape();
    Vec3 direction = Ways.direction(pulled.way(), shape);
    for (int n = 0; n < ways.size(); n++) {
      if (Ways.direction(ways.get(n).way(), shape).dot(direction) > SAME_DIRECTION) {
        if (pulled.detourMm < ways.get(n).detourMm) {
          ways.set(n, pulled);
        }
        return false;
      }
    }
    return ways.add(pulled);
  }

  /** Whether a way leads out without a detour that matters. */
  boolean isStraight(Pulled pulled) {
    return pulled.detourMm <= STRAIGHT_EDGES * edgeMm;
  }

  /**
   * Pulls a fragment along random directions and with turns, each time on from a pose that it has
   * reached, until it is out or has been pulled {@value #RANDOM_PULLS} times.
   *
   * @param fragment its index
   * @param reachMm the distance from its place at which it is out
   * @param seed chooses the pulls
   * @return how far it came; it is back in its place
   * @throws CancellationException if the thread is interrupted
   */
  public Pulled around(int fragment, double reachMm, long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    Reached farthest = begin(fragment);
    List<Reached> tree = new ArrayList<>(List.of(farthest));
    for (int n = 0; n < RANDOM_PULLS && !isOut(farthest, reachMm); n++) {
      Reached end = pullAtRandom(fragment, tree, reachMm, random);
      farthest = farther(farthest, end);
      if (isNew(fragment, tree, end)) {
        tree.add(end);
      }
    }
    return pulled(fragment, farthest, reachMm);
  }

  private Reached begin(int fragment) {
    home.set(bodies.body(fragment).pose());
    return new Reached(new Pose().set(home), null, 0, 0);
  }

  private static Reached farther(Reached one, Reached other) {
    return other.farMm > one.farMm ? other : one;
  }

  private static boolean isOut(Reached reached, double reachMm) {
    return reached.farMm >= OUT_PART * reachMm;
  }

  private Pulled pulled(int fragment, Reached farthest, double reachMm) {
    put(fragment, home);
    List<Pose> way = new ArrayList<>();
    for (Reached each = farthest; each != null && isOut(farthest, reachMm); each = each.before) {
      way.add(each.body);
    }
    Collections.reverse(way);
    return new Pulled(way, farthest.farMm, detourMm(fragment, farthest, way));
  }

  private double detourMm(int fragment, Reached end, List<Pose> way) {
    if (way.isEmpty()) {
      return Double.POSITIVE_INFINITY;
    }
    Pose from = references[fragment].toReference(home, new Pose());
    Pose to = references[fragment].toReference(end.body, new Pose());
    return end.pathMm - hands[fragment].shape().metric().distance(from, to);
  }

  private Reached pullAtRandom(
      int fragment, List<Reached> tree, double reachMm, SplittableRandom random) {
    Reached from = tree.get(random.nextInt(tree.size()));
    for (int rivals = (1 << random.nextInt(MOST_DOUBLINGS + 1)) - 1; rivals > 0; rivals--) {
      from = farther(from, tree.get(random.nextInt(tree.size())));
    }
    boolean isLong = random.nextInt(LONG_ONE_IN) == 0;
    double mm = isLong ? reachMm : PULL_EDGES * edgeMm * random.nextDouble();
    Vec3 shift = inBall(random);
    if (random.nextBoolean()) {
      Vec3 away = fromHome(fragment, from.body);
      shift.add(away.mul(1 / Math.max(away.length(), 1e-9), away), shift);
    }
    shift.mul(mm / Math.max(shift.length(), 1e-9), shift);
    boolean isTurned = random.nextInt(STRAIGHT_ONE_IN) > 0;
    Vec3 turn = inBall(random);
    turn.mul(isTurned ? LARGEST_TURN_RAD : 0, turn);
    return random.nextInt(SHAKEN_ONE_IN) == 0
        ? shake(fragment, from, shift, turn, random)
        : pull(fragment, from, shift, turn);
  }

  private static Vec3 inBall(SplittableRandom random) {
    Vec3 v = new Vec3();
    do {
      v.set(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1));
    } while (v.length() > 1);
    return v;
  }

  /** Returns how a pose has moved the reference point of a fragment from its place. */
  private Vec3 fromHome(int fragment, Pose pose) {
    Vec3 at = new Vec3();
    at.set(references[fragment].toReference(pose, seen).translation);
    return at.sub(references[fragment].toReference(home, seen).translation, at);
  }

  private boolean isNew(int fragment, List<Reached> tree, Reached end) {
    Pose reference = references[fragment].toReference(end.body, new Pose());
    for (Reached each : tree) {
      Pose other = references[fragment].toReference(each.body, seen);
      double mm = hands[fragment].shape().metric().distance(other, reference);
      if (mm < APART_EDGES * edgeMm) {
        return false;
      }
    }
    return true;
  }

  /** Takes a fragment in hand at a pose that it has reached. */
  private RigidSolver take(int fragment, Reached from) {
    requireWanted();
    put(fragment, from.body);
    point.place(NOWHERE, motion);
    hands[fragment].takeOver(motion);
    return hands[fragment];
  }

  /** Pulls a fragment towards a pose until it rests; returns where it came. */
  private Reached pull(int fragment, Reached from, Vec3 shift, Vec3 turn) {
    RigidSolver hand = take(fragment, from);
    Pose goal = motion.pose().displace(shift, turn, 1, scratch, new Pose());
    Reached last = from;
    double leftMm = hand.shape().metric().distance(motion.pose(), goal);
    int idle = 0;
    for (int n = 0; n < MOST_FRAMES && idle < IDLE_FRAMES && leftMm > 0; n++) {
      last = follow(fragment, last, goal);
      double nowMm = hand.shape().metric().distance(motion.pose(), goal);
      idle = nowMm < leftMm - PROGRESS_EDGES * edgeMm ? 0 : idle + 1;
      leftMm = nowMm;
    }
    return last;
  }

  /** Moves the hand slowly towards a pose, and shakes the fragment at random on the way. */
  private Reached shake(
      int fragment, Reached from, Vec3 shift, Vec3 turn, SplittableRandom random) {
    RigidSolver hand = take(fragment, from);
    Pose start = new Pose().set(motion.pose());
    Reached last = from;
    double part = Math.min(1, LONGEST_SHAKEN_EDGES * edgeMm / shift.length());
    int frames = (int) Math.ceil(part * shift.length() / (ADVANCE_EDGES * edgeMm));
    double farMm = 0;
    int idle = 0;
    for (int n = 1; n <= frames && idle < IDLE_SHAKEN_FRAMES; n++) {
      start.displace(shift, turn, part * n / frames, scratch, target);
      Vec3 shaken = inBall(random);
      target.translation.add(shaken.mul(SHAKE_EDGES * edgeMm, shaken), target.translation);
      last = follow(fragment, last, target);
      double nowMm = hand.shape().metric().distance(start, motion.pose());
      idle = nowMm > farMm + SHAKEN_PROGRESS_EDGES * edgeMm ? 0 : idle + 1;
      farMm = Math.max(farMm, nowMm);
    }
    return last;
  }

  /** Runs a frame, and adds the poses of its path to those that were reached. */
  private Reached follow(int fragment, Reached from, Pose goal) {
    hands[fragment].follow(goal, motion);
    Reached last = from;
    for (int n = 1; n <= motion.steps(); n++) {
      Pose pose = references[fragment].toRest(motion.pathPose(n), new Pose());
      double stepMm =
          hands[fragment].shape().metric().distance(motion.pathPose(n - 1), motion.pathPose(n));
      double farMm = fromHome(fragment, pose).length();
      last = new Reached(pose, last, farMm, last.pathMm + stepMm);
    }
    return last;
  }
}
