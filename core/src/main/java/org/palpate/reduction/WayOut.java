package org.palpate.reduction;

import java.util.ArrayList;
import java.util.List;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.geometry.AffineMap;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;

/**
 * The straight line along which a fragment leaves a pose most freely. Its points are shifted along
 * many directions by growing distances, and those that lie in another body are counted.
 *
 * <p>Rough faces that fit block most directions by a few points near the pose. So the points must
 * be dense there, or a direction seems to be free that is not. World mm. One thread.
 */
final class WayOut {
  /** The number of directions that are compared, spread evenly over the sphere. */
  static final int DIRECTIONS = 160;

  /** The angle between a direction and the four around it that measure how wide its opening is. */
  private static final double OPENING_RAD = 0.35;

  /** The shortest shift, shortest voxel edges, and the ratio of each shift to the one before. */
  private static final double FIRST_EDGES = 0.5;

  private static final double GROWTH = 1.5;

  /** After longer shifts, shortest voxel edges, one of {@link #FAR_STRIDE} points is enough. */
  private static final double FAR_EDGES = 4;

  private static final int FAR_STRIDE = 6;

  private static final double GOLDEN_ANGLE = Math.PI * (3 - Math.sqrt(5));

  private final List<OtherBody> others = new ArrayList<>();
  private final List<Double> shiftsMm = new ArrayList<>();
  private final double farMm;
  private final Vec3 direction = new Vec3(0, 0, 1);
  private long blocked = Long.MAX_VALUE;

  /**
   * Another body, and the points of the fragment in the grid coordinates of that body: those near
   * its voxels, and some of all.
   */
  private record OtherBody(BitCube bits, AffineMap worldToGrid, List<Vec3> near, List<Vec3> some) {

    static OtherBody of(Body body, Vec3[] world) {
      AffineMap map = body.toolToGrid(new Pose(), new AffineMap());
      List<Vec3> near = new ArrayList<>();
      List<Vec3> some = new ArrayList<>();
      for (int n = 0; n < world.length; n++) {
        Vec3 p = map.transform(world[n], new Vec3());
        if (isNear(body.bits(), p)) {
          near.add(p);
        }
        if (n % FAR_STRIDE == 0) {
          some.add(p);
        }
      }
      return new OtherBody(body.bits(), map, near, some);
    }

    /** Whether a point may lie in a voxel after a shift of up to {@code FAR_EDGES}. */
    private static boolean isNear(BitCube bits, Vec3 p) {
      int i = (int) Math.floor(p.x) >> BitCube.BRICK_SHIFT;
      int j = (int) Math.floor(p.y) >> BitCube.BRICK_SHIFT;
      int k = (int) Math.floor(p.z) >> BitCube.BRICK_SHIFT;
      long any = 0;
      for (int w = k - 1; w <= k + 1; w++) {
        for (int v = j - 1; v <= j + 1; v++) {
          any |= bits.brick(i - 1, v, w) | bits.brick(i, v, w) | bits.brick(i + 1, v, w);
        }
      }
      return any != 0;
    }

    /** Returns about how many points lie in the body after a shift, mm. */
    int count(Vec3 shift, boolean isFar) {
      Vec3 cells = worldToGrid.transformDirection(shift, new Vec3());
      int count = 0;
      for (Vec3 p : isFar ? some : near) {
        int i = (int) Math.floor(p.x + cells.x);
        int j = (int) Math.floor(p.y + cells.y);
        int k = (int) Math.floor(p.z + cells.z);
        count += bits.get(i, j, k) ? 1 : 0;
      }
      return isFar ? FAR_STRIDE * count : count;
    }
  }

  /**
   * Finds the line on which the fewest points are blocked. Of equal ones, it takes the one around
   * which other directions block the fewest points.
   *
   * @param fragment the index of the fragment; -1 if it is none of the bodies
   * @param points its sample points at that pose, world mm
   * @param reachMm the length of the line
   */
  WayOut(BodyScene scene, int fragment, Vec3[] points, double reachMm) {
    for (int n = 0; n < scene.count(); n++) {
      if (n != fragment) {
        others.add(OtherBody.of(scene.body(n), points));
      }
    }
    farMm = FAR_EDGES * scene.shortestEdgeMm();
    for (double mm = FIRST_EDGES * scene.shortestEdgeMm(); mm < reachMm; mm *= GROWTH) {
      shiftsMm.add(mm);
    }
    shiftsMm.add(reachMm);
    long narrow = Long.MAX_VALUE;
    for (int n = 0; n < DIRECTIONS; n++) {
      Vec3 candidate = direction(n);
      long count = count(candidate, blocked);
      if (count <= blocked) {
        long around = countAround(candidate, count < blocked ? Long.MAX_VALUE : narrow);
        if (count < blocked || around < narrow) {
          blocked = count;
          narrow = around;
          direction.set(candidate);
        }
      }
    }
  }

  /** Returns the direction of the line, a unit vector. */
  Vec3 direction() {
    return direction;
  }

  /** Returns how many points are blocked on the line; a point counts for each shift. */
  long blocked() {
    return blocked;
  }

  /** Returns a direction of a Fibonacci lattice on the sphere. */
  static Vec3 direction(int n) {
    double z = 1 - (2 * n + 1.0) / DIRECTIONS;
    double radius = Math.sqrt(1 - z * z);
    double angle = n * GOLDEN_ANGLE;
    return new Vec3(radius * StrictMath.cos(angle), radius * StrictMath.sin(angle), z);
  }

  /** Returns an axis that is not along a direction. */
  static Vec3 beside(Vec3 direction) {
    return Math.abs(direction.z) < 0.7 ? new Vec3(0, 0, 1) : new Vec3(1, 0, 0);
  }

  private long countAround(Vec3 candidate, long most) {
    Vec3 u = candidate.cross(beside(candidate), new Vec3());
    u.mul(StrictMath.tan(OPENING_RAD) / u.length(), u);
    Vec3 v = candidate.cross(u, new Vec3());
    long count = 0;
    for (Vec3 tilt : new Vec3[] {u, u.mul(-1, new Vec3()), v, v.mul(-1, new Vec3())}) {
      Vec3 tilted = candidate.add(tilt, new Vec3());
      tilted.mul(1 / tilted.length(), tilted);
      count += count(tilted, most);
    }
    return count;
  }

  /** Returns how many points are blocked along a direction, or some number above a limit. */
  private long count(Vec3 along, long most) {
    Vec3 shift = new Vec3();
    long count = 0;
    for (double mm : shiftsMm) {
      along.mul(mm, shift);
      for (OtherBody each : others) {
        count += each.count(shift, mm > farMm);
      }
      if (count > most) {
        return count;
      }
    }
    return count;
  }
}
