package org.palpate.rigid;

import java.util.List;
import org.palpate.body.Body;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.smooth.field.FieldSample;
import org.palpate.proxy.smooth.field.GreyIsosurfaceSource;
import org.palpate.proxy.smooth.field.OccupancyField;
import org.palpate.proxy.smooth.field.SeedCell;
import org.palpate.rigid.tool.RigidTool;

/**
 * The smooth surface of one body for contacts: where a tool touches it, the height of that point
 * over the isosurface, and the normal. Both come from the occupancy field on which the point solver
 * {@code smooth} slides. With a clearance, the surface lies higher by the length by which the grown
 * solids reach beyond the body along the normal.
 *
 * <p>No other class of this package uses the field. Haptic thread only; an evaluation allocates
 * nothing.
 */
final class ContactField {
  /** The least slope of the field near a surface, 1/edge. */
  private static final double LEAST_SLOPE = 1e-4;

  /**
   * The most searches of the lowest point of a curved tool. Each begins with the normal that the
   * last one has found.
   */
  private static final int SEARCHES = 2;

  /** The point that was found last, in the frame of the sample points, mm. */
  final Vec3 at = new Vec3();

  /** The normal at that point, unit, world axes. */
  final Vec3 normal = new Vec3();

  /** The height of that point over the surface, mm; negative below it. */
  double heightMm;

  /** The distance that a point is kept from the body's own surface along the normal, mm. */
  double clearanceMm;

  /** The number of evaluations that the last search took. */
  int evaluations;

  private final Body body;
  private final ClearanceLevels levels;
  private final OccupancyField field;
  private final SeedCell seed = new SeedCell();
  private final CollisionScene solids;
  private final double edgeMm;
  private final Vec3 gradient = new Vec3();
  private final Vec3 grid = new Vec3();
  private final Vec3 up = new Vec3();
  private final Vec3 lowest = new Vec3();
  private final Vec3 samplePoint = new Vec3();
  private long editsSeen;

  /**
   * Creates the field of a body.
   *
   * @param grey the grey values from which the voxels were made, or null
   */
  ContactField(ClearanceLevels levels, GreyIsosurfaceSource grey) {
    this.levels = levels;
    body = levels.body;
    GridMetric metric = body.metric();
    edgeMm = metric.shortestEdgeMm();
    OccupancyField plain =
        grey == null ? OccupancyField.ofBits(metric) : OccupancyField.ofGrey(metric, grey);
    field = plain.forManyPlaces();
    solids = new CollisionScene(List.of(body.bits()));
    field.use(solids);
  }

  /**
   * Finds where a tool touches the surface near a sample point that lies in an empty voxel. That is
   * the sample point, or the lowest point of the curved surface of the tool around it. So a ball
   * rolls on its sphere, and not on the facets between its sample points.
   *
   * @param pair the body with this surface, and the points
   * @return whether there is a surface near
   */
  boolean touch(BodyVerifier pair, int point) {
    RigidTool tool = pair.points.shape;
    int level = pair.level(point);
    pair.from().transform(tool.point(point, at), grid);
    seed.set(grid);
    evaluations = 1;
    if (!evaluate(grid, level)) {
      return false;
    }
    tool.point(point, samplePoint);
    findLowest(pair, point);
    boolean found = true;
    for (int n = 0; n < SEARCHES && found && isLowestElsewhere(); n++) {
      found = evaluate(pair.from().transform(at.set(lowest), grid), level);
      evaluations++;
      findLowest(pair, point);
    }
    if (found && evaluations > 1 && isLowestElsewhere()) {
      // The lever of a ball must be parallel to the normal, or the ball would feel a torque.
      heightMm += lowest.sub(at, at).dot(up);
      at.set(lowest);
    }
    if (found) {
      pair.heights.suggest(gradient);
    }
    return found;
  }

  /** Finds the lowest point for the present normal. */
  private void findLowest(BodyVerifier pair, int point) {
    pair.points.pose.rotation.inverseRotate(normal, up);
    pair.points.shape.lowestNear(point, up, lowest);
  }

  /** Whether the lowest point is neither the one that was evaluated last nor the sample point. */
  private boolean isLowestElsewhere() {
    return !lowest.sameBits(at) && !lowest.sameBits(samplePoint);
  }

  /** Evaluates height and normal; returns whether there is a surface near. */
  private boolean evaluate(Vec3 point, int level) {
    if (body.edits() != editsSeen) {
      editsSeen = body.edits();
      field.forget();
    }
    FieldSample sample = field.evaluate(seed, point);
    gradient.set(sample.gx(), sample.gy(), sample.gz());
    double slope = gradient.length();
    if (slope < LEAST_SLOPE) {
      return false;
    }
    gradient.mul(-1 / slope, gradient);
    clearanceMm = levels.reachMm(level, gradient);
    heightMm = field.level().heightEdges(sample.occupancy(), gradient) * edgeMm - clearanceMm;
    body.gridDirectionToWorld(gradient, normal);
    return true;
  }
}
