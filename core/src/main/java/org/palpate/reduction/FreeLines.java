package org.palpate.reduction;

import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.geometry.AffineMap;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.raycast.ExactRayCaster;
import org.palpate.raycast.Ray;
import org.palpate.raycast.RayHit;

/**
 * Finds straight lines that touch no body of a scene: for a point, and for a fragment that leaves a
 * pose along a direction. World mm. One thread.
 */
final class FreeLines {
  /** The number of directions that are compared, spread evenly over the sphere. */
  private static final int DIRECTIONS = 160;

  /** The angle between a direction and the four around it that measure how wide its opening is. */
  private static final double OPENING_RAD = 0.35;

  private static final double GOLDEN_ANGLE = Math.PI * (3 - Math.sqrt(5));

  private final BodyScene scene;
  private final ExactRayCaster caster = new ExactRayCaster();
  private final Ray ray = new Ray();
  private final RayHit hit = new RayHit();
  private final AffineMap toGrid = new AffineMap();
  private final Pose world = new Pose();
  private final Vec3 gridFrom = new Vec3();
  private final Vec3 gridTo = new Vec3();

  FreeLines(BodyScene scene) {
    this.scene = scene;
  }

  /** Whether a straight line touches no body at its present pose. */
  boolean isFree(Vec3 from, Vec3 to) {
    for (int n = 0; n < scene.count(); n++) {
      if (touches(n, from, to)) {
        return false;
      }
    }
    return true;
  }

  private boolean touches(int index, Vec3 from, Vec3 to) {
    Body body = scene.body(index);
    body.toolToGrid(world, toGrid);
    toGrid.transform(from, gridFrom);
    toGrid.transform(to, gridTo);
    ray.from(gridFrom.x, gridFrom.y, gridFrom.z).to(gridTo.x, gridTo.y, gridTo.z);
    return caster.cast(body.bits(), ray, hit);
  }

  /**
   * Returns the direction along which a fragment leaves a pose most freely: the fewest of its
   * points meet another body. Among equal directions, it takes the one whose neighbouring
   * directions block the fewest points.
   *
   * @param fragment its index
   * @param points its sample points at that pose, world mm
   * @param reachMm the length of the line
   */
  Vec3 widest(int fragment, Vec3[] points, double reachMm) {
    Vec3 best = new Vec3(0, 0, 1);
    long least = Long.MAX_VALUE;
    for (int n = 0; n < DIRECTIONS; n++) {
      Vec3 direction = direction(n);
      int blocked = blocked(fragment, points, direction, reachMm);
      // The opening only decides between equals.
      long narrow = (long) blocked * (4L * points.length + 1);
      if (narrow < least) {
        long score = narrow + blockedAround(fragment, points, direction, reachMm);
        if (score < least) {
          least = score;
          best = direction;
        }
      }
    }
    return best;
  }

  /** Returns a direction of a Fibonacci lattice on the sphere. */
  static Vec3 direction(int n) {
    double z = 1 - (2 * n + 1.0) / DIRECTIONS;
    double radius = Math.sqrt(1 - z * z);
    double angle = n * GOLDEN_ANGLE;
    return new Vec3(radius * StrictMath.cos(angle), radius * StrictMath.sin(angle), z);
  }

  private int blockedAround(int fragment, Vec3[] points, Vec3 direction, double reachMm) {
    Vec3 side = Math.abs(direction.z) < 0.7 ? new Vec3(0, 0, 1) : new Vec3(1, 0, 0);
    Vec3 u = direction.cross(side, new Vec3());
    u.mul(StrictMath.tan(OPENING_RAD) / u.length(), u);
    Vec3 v = direction.cross(u, new Vec3());
    int blocked = 0;
    for (Vec3 tilt : new Vec3[] {u, u.mul(-1, new Vec3()), v, v.mul(-1, new Vec3())}) {
      Vec3 tilted = direction.add(tilt, new Vec3());
      tilted.mul(1 / tilted.length(), tilted);
      blocked += blocked(fragment, points, tilted, reachMm);
    }
    return blocked;
  }

  /** Returns the number of points that meet another body on a straight line. */
  private int blocked(int fragment, Vec3[] points, Vec3 direction, double reachMm) {
    Vec3 path = direction.mul(reachMm, new Vec3());
    Vec3 end = new Vec3();
    int blocked = 0;
    for (Vec3 point : points) {
      point.add(path, end);
      for (int n = 0; n < scene.count(); n++) {
        if (n != fragment && touches(n, point, end)) {
          blocked++;
          break;
        }
      }
    }
    return blocked;
  }
}
