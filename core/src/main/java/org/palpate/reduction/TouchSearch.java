package org.palpate.reduction;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.tool.RigidTool;

/**
 * Finds the points at which a hand can take hold of a fragment and leave it again. A straight line
 * from outside leads to such a point where the fragment lies, and another leads away from it where
 * the hand will let the fragment go. Without the second, bones around the point would catch the
 * tool there.
 *
 * <p>World mm. One thread.
 */
final class TouchSearch {
  /** The most sample points of a fragment among which a point is sought. */
  private static final int MOST_TOUCHES = 160;

  /**
   * The distance from a touched point beyond which the fragment must not lie on the line, shortest
   * voxel edges.
   */
  private static final double CLEAR_EDGES = 2;

  /** The depth below a touched point that is solid, or the hand would slip off an edge. */
  private static final double DEEP_EDGES = 2;

  /** The distance of lines beside one that has room for a tremor, shortest voxel edges. */
  private static final double ROOM_EDGES = 0.7;

  /** The highest demand comes first. */
  private static final List<Demand> DEMANDS =
      List.of(
          new Demand(true, ROOM_EDGES, true),
          new Demand(true, ROOM_EDGES, false),
          new Demand(true, 0, true),
          new Demand(true, 0, false),
          new Demand(false, ROOM_EDGES, true),
          new Demand(false, ROOM_EDGES, false),
          new Demand(false, 0, true),
          new Demand(false, 0, false));

  private static final List<Vec3> DIRECTIONS =
      IntStream.range(0, WayOut.DIRECTIONS).mapToObj(WayOut::direction).toList();

  private final BodyScene bodies;
  private final FreeLines lines;
  private final List<RigidTool> shapes;
  private final BallAround ball;
  private final double edgeMm;

  /**
   * A point at which the hand takes a fragment.
   *
   * @param at the point where the fragment lies
   * @param outward the direction from which the hand comes, a unit vector
   * @param off the direction in which it leaves the fragment where it let it go, a unit vector
   */
  record Touch(Vec3 at, Vec3 outward, Vec3 off) {}

  /**
   * A sample point of a fragment where it lies, the same where the hand lets the fragment go, and
   * the directions from the middle of the fragment to both.
   */
  private record Candidate(Vec3 at, Vec3 away, Vec3 end, Vec3 awayThen, double farMm) {}

  /**
   * The demands on a point.
   *
   * @param leaves whether the hand can leave the fragment there
   * @param roomEdges the distance of free lines beside, shortest voxel edges
   * @param isAway whether the hand must come along a line from the middle of the fragment
   */
  private record Demand(boolean leaves, double roomEdges, boolean isAway) {}

  /**
   * Creates a search.
   *
   * @param bodies where they are when a search begins
   * @param shapes sample points of each body
   * @param ball all bodies lie in it
   */
  TouchSearch(BodyScene bodies, List<RigidTool> shapes, BallAround ball) {
    this.bodies = bodies;
    this.shapes = shapes;
    this.ball = ball;
    lines = new FreeLines(bodies);
    edgeMm = bodies.shortestEdgeMm();
  }

  /**
   * Returns the point that is nearest to the middle of the fragment, so that a tremor that turns
   * the hand moves the fragment little. Prefers points at which the hand can leave the fragment.
   * Among them, prefers points whose lines have room for a tremor, and then points that a line away
   * from the middle reaches. Takes the nearest point if it finds no line to any point.
   *
   * @param end the pose at which the hand will let the fragment go
   * @param preferred the direction of the line if none is free
   */
  Touch find(int fragment, Pose end, Vec3 preferred) {
    List<Candidate> candidates = candidates(fragment, end);
    for (Demand demand : DEMANDS) {
      for (Candidate each : candidates) {
        Optional<Vec3> outward = outward(fragment, each, demand);
        Optional<Vec3> off = outward.flatMap(reached -> off(fragment, each, end, demand));
        if (off.isPresent()) {
          return new Touch(each.at, outward.get(), off.get());
        }
      }
    }
    Candidate nearest = candidates.get(0);
    return new Touch(nearest.at, preferred, ball.away(nearest.end));
  }

  /** Returns sample points, those that are nearest to the middle of the fragment first. */
  private List<Candidate> candidates(int fragment, Pose end) {
    RigidTool shape = shapes.get(fragment);
    RigidTool some = shape.thinned(MOST_TOUCHES);
    Pose start = bodies.body(fragment).pose();
    Vec3[] now = ReductionPlan.points(some, start);
    Vec3[] then = ReductionPlan.points(some, end);
    Vec3 own = start.transform(shape.referenceMm(new Vec3()), new Vec3());
    Vec3 ownThen = end.transform(shape.referenceMm(new Vec3()), new Vec3());
    List<Candidate> candidates = new ArrayList<>();
    for (int n = 0; n < now.length; n++) {
      double farMm = now[n].sub(own, new Vec3()).length();
      candidates.add(
          new Candidate(now[n], away(now[n], own), then[n], away(then[n], ownThen), farMm));
    }
    candidates.sort(Comparator.comparingDouble(Candidate::farMm));
    return candidates;
  }

  /** Returns the direction from the middle of a fragment to a point, or any if they coincide. */
  private static Vec3 away(Vec3 point, Vec3 middle) {
    Vec3 away = point.sub(middle, new Vec3());
    double farMm = away.length();
    return farMm > 0 ? away.mul(1 / farMm, away) : DIRECTIONS.get(0);
  }

  /** Returns the direction of a free line from outside to a point where the fragment lies. */
  private Optional<Vec3> outward(int fragment, Candidate candidate, Demand demand) {
    List<Vec3> directions = demand.isAway ? List.of(candidate.away) : DIRECTIONS;
    return directions.stream()
        .filter(each -> isFirm(fragment, besides(candidate.at, each, demand.roomEdges), each))
        .filter(each -> isFree(fragment, besides(candidate.at, each, demand.roomEdges), each))
        .findFirst();
  }

  /** Returns the direction of a free line from a point at which the hand let the fragment go. */
  private Optional<Vec3> off(int fragment, Candidate candidate, Pose end, Demand demand) {
    if (!demand.leaves) {
      return Optional.of(ball.away(candidate.end));
    }
    Body body = bodies.body(fragment);
    Pose start = new Pose().set(body.pose());
    body.setPose(end);
    Optional<Vec3> off =
        Stream.concat(Stream.of(candidate.awayThen), DIRECTIONS.stream())
            .filter(each -> isFree(fragment, besides(candidate.end, each, demand.roomEdges), each))
            .findFirst();
    body.setPose(start);
    return off;
  }

  /** Whether a fragment is solid below points on it. */
  private boolean isFirm(int fragment, List<Vec3> points, Vec3 outward) {
    Vec3 deep = outward.mul(-DEEP_EDGES * edgeMm, new Vec3());
    return points.stream().allMatch(at -> lines.isSolid(fragment, at.add(deep, new Vec3())));
  }

  /** Whether lines from points on a fragment to outside meet no body. */
  private boolean isFree(int fragment, List<Vec3> points, Vec3 outward) {
    for (Vec3 at : points) {
      Vec3 clear = outward.mul(CLEAR_EDGES * edgeMm, new Vec3()).add(at, new Vec3());
      if (!lines.isFreeBut(fragment, at, clear) || !lines.isFree(clear, ball.beyond(at, outward))) {
        return false;
      }
    }
    return true;
  }

  /** Returns a point, and four around it if they are to lie at a distance across a direction. */
  private List<Vec3> besides(Vec3 at, Vec3 direction, double edges) {
    if (edges == 0) {
      return List.of(at);
    }
    Vec3 u = direction.cross(WayOut.beside(direction), new Vec3());
    u.mul(edges * edgeMm / u.length(), u);
    Vec3 v = direction.cross(u, new Vec3());
    return Stream.of(new Vec3(), u, u.mul(-1, new Vec3()), v, v.mul(-1, new Vec3()))
        .map(side -> at.add(side, side))
        .toList();
  }
}
