package org.palpate.reduction;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.reduction.PullSearch.Pulled;
import org.palpate.rigid.MovableShapes;
import org.palpate.rigid.RigidScene;
import org.palpate.rigid.tool.RigidTool;

/**
 * Takes the fragments of a bone out of their places, one after the other. The reverse is an order,
 * and ways, in which they can be put back.
 *
 * <p>A fragment that came out is taken far away, because a hand can clear it out of the way before
 * it puts the others back. So taking one out never hinders the others, and it does not matter which
 * of several comes first. Those that the fracture left in the place of another come last, so that
 * the hand has less to clear.
 *
 * <p>First those fragments come out that a trembling hand has led home again in every rehearsal. If
 * there is none, the one comes out that arrived most often. If none arrived at all, random pulls
 * are tried too, and one comes out that arrives on such a way, or else any that comes out. If none
 * comes out, the one that came least far is given up and taken away.
 */
public final class Disassembly {
  /** The most sample points of a fragment at which the start of a pull is sought. */
  private static final int MOST_POINTS = 1000;

  /** The most ways of a fragment that are rehearsed. */
  private static final int MOST_WAYS = 4;

  /** The most frames of all rehearsals. */
  private static final long MOST_FRAMES = 400_000;

  private static final long SEED = 1;
  private static final Pulled NOT_OUT = new Pulled(List.of(), 0, Double.POSITIVE_INFINITY);

  private final PullSearch search;
  private final Rehearsal rehearsal;
  private final BodyScene bodies;
  private final List<RigidTool> shapes = new ArrayList<>();
  private final FragmentPlaces places;
  private final List<Pose> starts;
  private final double reachMm;
  private final List<Exit> exits = new ArrayList<>();
  private final List<Integer> left = new ArrayList<>();

  /**
   * A fragment that was taken out.
   *
   * @param fragment its index
   * @param pulled its way out; without one it was given up
   * @param others more ways out, in other directions
   * @param among the fragments that were in their places then, besides those that stand still
   */
  public record Exit(int fragment, Pulled pulled, List<Pulled> others, List<Integer> among) {
    /** Copies the lists. */
    public Exit {
      others = List.copyOf(others);
      among = List.copyOf(among);
    }
  }

  /**
   * The ways out of a fragment.
   *
   * @param ways that on which it arrived most often first
   * @param arrivals the share of rehearsals in which it arrived there
   */
  private record Rehearsed(int fragment, List<Pulled> ways, double arrivals) {}

  private Disassembly(
      PullSearch search, Rehearsal rehearsal, MovableShapes points, List<Pose> starts, double mm) {
    this.search = search;
    this.rehearsal = rehearsal;
    this.starts = starts;
    reachMm = mm;
    bodies = search.bodies();
    for (int n = 0; n < bodies.count(); n++) {
      boolean moves = bodies.body(n).mobility() == Mobility.MOVABLE;
      shapes.add(moves ? points.shapes().get(n).thinned(MOST_POINTS) : null);
      if (moves) {
        left.add(n);
      }
    }
    places = new FragmentPlaces(bodies, shapes);
  }

  /**
   * {@return the fragments in the order in which they came out} Bodies that overlap in their places
   * are not moved, and none of them has a way.
   *
   * @param scene the bodies where the fracture left them; not moved
   * @param truth the place of each body that can move, rest to present
   * @param shapes the sample points of the bodies, and the clearance that they keep
   * @param reachMm the distance from its place at which a fragment is out
   * @throws java.util.concurrent.CancellationException if the thread is interrupted
   */
  public static List<Exit> of(
      BodyScene scene, List<Pose> truth, MovableShapes shapes, double reachMm) {
    List<Body> copies = new ArrayList<>();
    List<Pose> starts = new ArrayList<>();
    for (int n = 0; n < scene.count(); n++) {
      Body body = scene.body(n);
      boolean moves = body.mobility() == Mobility.MOVABLE;
      Body copy = new Body(body.name(), body.bits(), body.grid(), body.mobility());
      copy.setPose(moves ? truth.get(n) : body.pose());
      copies.add(copy);
      starts.add(new Pose().set(body.pose()));
    }
    BodyScene inPlace = new BodyScene(copies);
    MovableShapes points = MovableShapes.ofPoints(inPlace);
    PullSearch search;
    Rehearsal rehearsal;
    try {
      search = new PullSearch(inPlace, points);
      rehearsal = new Rehearsal(inPlace, shapes, MOST_FRAMES);
    } catch (RigidScene.BodiesOverlapException e) {
      return none(scene);
    }
    Disassembly disassembly = new Disassembly(search, rehearsal, points, starts, reachMm);
    disassembly.run();
    return disassembly.exits;
  }

  private static List<Exit> none(BodyScene scene) {
    List<Exit> none = new ArrayList<>();
    for (int n = 0; n < scene.count(); n++) {
      if (scene.body(n).mobility() == Mobility.MOVABLE) {
        none.add(new Exit(n, NOT_OUT, List.of(), List.of()));
      }
    }
    return none;
  }

  private void run() {
    while (!left.isEmpty()) {
      int before = left.size();
      Rehearsed best = takeOutThoseThatArrive();
      if (left.size() == before) {
        if (best.arrivals > 0) {
          takeOut(best.fragment, best.ways);
        } else {
          takeOutAround(best);
        }
      }
    }
  }

  /**
   * Takes out each fragment that comes out by a straight pull, and always arrives when it is led
   * home.
   *
   * @return the best of the others
   */
  private Rehearsed takeOutThoseThatArrive() {
    Rehearsed best = new Rehearsed(-1, List.of(), -1);
    for (int fragment : inOrder()) {
      List<Pulled> ways = pullStraight(fragment);
      if (!ways.isEmpty()) {
        Rehearsed rehearsed = rehearse(fragment, ways);
        if (rehearsed.arrivals == 1) {
          takeOut(fragment, rehearsed.ways);
        } else if (rehearsed.arrivals > best.arrivals) {
          best = rehearsed;
        }
      }
    }
    return best;
  }

  /** Returns those that are left. Those that would lie in the place of another come last. */
  private List<Integer> inOrder() {
    List<Integer> order = new ArrayList<>(left);
    order.sort(Comparator.comparing(this::liesInTheWay));
    return order;
  }

  private List<Pulled> pullStraight(int fragment) {
    Vec3[] points = ReductionPlan.points(shapes.get(fragment), bodies.body(fragment).pose());
    Vec3 first = new WayOut(bodies, fragment, points, reachMm).direction();
    return search.straight(fragment, first, reachMm, MOST_WAYS);
  }

  /** Rehearses ways until a fragment always arrives on one. */
  private Rehearsed rehearse(int fragment, List<Pulled> ways) {
    double[] arrivals = new double[ways.size()];
    int best = 0;
    for (int n = 0; n < ways.size() && arrivals[best] < 1; n++) {
      arrivals[n] = rehearsal.arrivals(fragment, ways.get(n).way());
      best = arrivals[n] > arrivals[best] ? n : best;
    }
    List<Integer> order = new ArrayList<>(IntStream.range(0, ways.size()).boxed().toList());
    order.sort(Comparator.comparingDouble(n -> -arrivals[n]));
    return new Rehearsed(fragment, order.stream().map(ways::get).toList(), arrivals[best]);
  }

  /**
   * Takes out the first fragment that comes out by random pulls and arrives when it is led home, or
   * any that comes out, or gives one up.
   *
   * @param straight one that comes out by straight pulls and never arrived; it may have no ways
   */
  private void takeOutAround(Rehearsed straight) {
    Rehearsed best = straight;
    int nearest = left.get(0);
    double nearestMm = Double.POSITIVE_INFINITY;
    for (int n = 0; n < left.size() && best.arrivals <= 0; n++) {
      int fragment = left.get(n);
      Pulled pulled = search.around(fragment, reachMm, SEED);
      double arrivals = pulled.isOut() ? rehearsal.arrivals(fragment, pulled.way()) : -1;
      if (arrivals > best.arrivals) {
        best = new Rehearsed(fragment, List.of(pulled), arrivals);
      }
      if (pulled.farthestMm() < nearestMm) {
        nearest = fragment;
        nearestMm = pulled.farthestMm();
      }
    }
    if (best.ways.isEmpty()) {
      takeOut(nearest, List.of(new Pulled(List.of(), nearestMm, Double.POSITIVE_INFINITY)));
    } else {
      takeOut(best.fragment, best.ways);
    }
  }

  private void takeOut(int fragment, List<Pulled> ways) {
    exits.add(new Exit(fragment, ways.get(0), ways.subList(1, ways.size()), left));
    search.remove(fragment);
    left.remove(Integer.valueOf(fragment));
  }

  /** Whether the fracture left a fragment in the place of another that is still there. */
  private boolean liesInTheWay(int fragment) {
    Pose start = starts.get(fragment);
    return left.stream()
        .anyMatch(n -> n != fragment && places.meet(fragment, start, n, bodies.body(n).pose()));
  }
}
