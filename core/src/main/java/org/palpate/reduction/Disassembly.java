package org.palpate.reduction;

import java.util.ArrayList;
import java.util.List;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.geometry.AffineMap;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.reduction.PullSearch.Pulled;
import org.palpate.rigid.MovableShapes;
import org.palpate.rigid.RigidScene;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.volume.BitCube;

/**
 * Takes the fragments of a bone out of their places, one after the other. The reverse is an order,
 * and ways, in which they can be put back.
 *
 * <p>A fragment that came out lies where the fracture left it, because a hand that puts it back
 * last has not moved it before. If it would lie in the place of one that is still to come out, it
 * is taken out after that one, or is taken far away if that cannot be.
 *
 * <p>The first fragment that comes out is taken out, and no other order is tried. So a fragment may
 * be hindered by one that now lies where the fracture left it. If none comes out, the one that came
 * least far is given up and taken away.
 */
public final class Disassembly {
  /** The most sample points of a fragment at which the start of a pull is sought. */
  private static final int MOST_POINTS = 1000;

  /** A fragment lies in the place of another if it is that near along an axis, voxels. */
  private static final int NEAR_VOXELS = 1;

  private static final long SEED = 1;
  private static final Pulled NOT_OUT = new Pulled(List.of(), 0);

  private final PullSearch search;
  private final BodyScene bodies;
  private final List<RigidTool> shapes;
  private final List<Pose> starts;
  private final double reachMm;
  private final List<Exit> exits = new ArrayList<>();
  private final List<Integer> left = new ArrayList<>();

  /**
   * A fragment that was taken out.
   *
   * @param fragment its index
   * @param pulled its way out; without one it was given up
   * @param among the fragments that were in their places then, besides those that stand still
   */
  public record Exit(int fragment, Pulled pulled, List<Integer> among) {
    /** Copies the list. */
    public Exit {
      among = List.copyOf(among);
    }
  }

  private Disassembly(
      PullSearch search, List<RigidTool> shapes, List<Pose> starts, double reachMm) {
    this.search = search;
    this.shapes = shapes;
    this.starts = starts;
    this.reachMm = reachMm;
    bodies = search.bodies();
    for (int n = 0; n < bodies.count(); n++) {
      if (bodies.body(n).mobility() == Mobility.MOVABLE) {
        left.add(n);
      }
    }
  }

  /**
   * {@return the fragments in the order in which they came out} Bodies that overlap in their places
   * are not moved, and none of them has a way.
   *
   * @param scene the bodies where the fracture left them; not moved
   * @param truth the place of each body that can move, rest to present
   * @param shapes the sample points of the bodies
   * @param reachMm the distance from its place at which a fragment is out
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
    PullSearch search;
    try {
      search = new PullSearch(new BodyScene(copies), shapes);
    } catch (RigidScene.BodiesOverlapException e) {
      return none(scene);
    }
    Disassembly disassembly = new Disassembly(search, shapes.shapes(), starts, reachMm);
    disassembly.run();
    return disassembly.exits;
  }

  private static List<Exit> none(BodyScene scene) {
    List<Exit> none = new ArrayList<>();
    for (int n = 0; n < scene.count(); n++) {
      if (scene.body(n).mobility() == Mobility.MOVABLE) {
        none.add(new Exit(n, NOT_OUT, List.of()));
      }
    }
    return none;
  }

  private void run() {
    while (!left.isEmpty()) {
      if (!takeOutStraight() && !takeOutOneInTheWay()) {
        takeOutAround();
      }
    }
  }

  /**
   * Takes out each fragment that comes out by a straight pull, and will not lie in the place of
   * another.
   *
   * @return whether a fragment came out
   */
  private boolean takeOutStraight() {
    int before = left.size();
    for (int fragment : List.copyOf(left)) {
      if (!liesInTheWay(fragment)) {
        Pulled pulled = pullStraight(fragment);
        if (pulled.isOut()) {
          takeOut(fragment, pulled);
        }
      }
    }
    return left.size() < before;
  }

  /**
   * Takes out the first fragment that comes out by a straight pull, of those that will lie in the
   * place of another.
   *
   * @return whether a fragment came out
   */
  private boolean takeOutOneInTheWay() {
    for (int fragment : left) {
      if (liesInTheWay(fragment)) {
        Pulled pulled = pullStraight(fragment);
        if (pulled.isOut()) {
          takeOut(fragment, pulled);
          return true;
        }
      }
    }
    return false;
  }

  private Pulled pullStraight(int fragment) {
    Vec3[] points = points(fragment, bodies.body(fragment).pose());
    Vec3 first = new WayOut(bodies, fragment, points, reachMm).direction();
    return search.straight(fragment, first, reachMm);
  }

  /** Takes out the first fragment that comes out by random pulls, or gives one up. */
  private void takeOutAround() {
    int fragment = left.get(0);
    Pulled least = search.around(fragment, reachMm, SEED);
    for (int n = 1; n < left.size() && !least.isOut(); n++) {
      Pulled pulled = search.around(left.get(n), reachMm, SEED);
      if (pulled.isOut() || pulled.farthestMm() < least.farthestMm()) {
        fragment = left.get(n);
        least = pulled;
      }
    }
    takeOut(fragment, least);
  }

  private void takeOut(int fragment, Pulled pulled) {
    exits.add(new Exit(fragment, pulled, left));
    if (liesInTheWay(fragment) || !pulled.isOut()) {
      search.remove(fragment);
    } else {
      search.put(fragment, starts.get(fragment));
    }
    left.remove(Integer.valueOf(fragment));
  }

  /** Whether the fracture left a fragment in the place of another that is still there. */
  private boolean liesInTheWay(int fragment) {
    Vec3[] points = points(fragment, starts.get(fragment));
    for (int other : left) {
      if (other != fragment) {
        Pose place = bodies.body(other).pose();
        if (meets(points, other, place)
            || meets(points(other, place), fragment, starts.get(fragment))) {
          return true;
        }
      }
    }
    return false;
  }

  private Vec3[] points(int fragment, Pose pose) {
    return ReductionPlan.points(shapes.get(fragment).thinned(MOST_POINTS), pose);
  }

  private boolean meets(Vec3[] points, int other, Pose pose) {
    Body body = bodies.body(other);
    AffineMap toGrid = body.toolToGrid(pose, new Pose(), new AffineMap());
    Vec3 at = new Vec3();
    for (Vec3 point : points) {
      if (isNear(body.bits(), toGrid.transform(point, at))) {
        return true;
      }
    }
    return false;
  }

  /** Whether a solid voxel lies near a point along an axis of the grid. */
  private static boolean isNear(BitCube bits, Vec3 grid) {
    int i = (int) Math.floor(grid.x);
    int j = (int) Math.floor(grid.y);
    int k = (int) Math.floor(grid.z);
    for (int n = -NEAR_VOXELS; n <= NEAR_VOXELS; n++) {
      if (bits.get(i + n, j, k) || bits.get(i, j + n, k) || bits.get(i, j, k + n)) {
        return true;
      }
    }
    return false;
  }
}
