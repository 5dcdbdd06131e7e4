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

/**
 * The smooth surface of one body for contacts: the height of a point over the isosurface, and the
 * normal. Both come from the occupancy field on which the point solver {@code smooth} slides. With
 * a clearance, the surface lies higher by the length by which the grown solids reach beyond the
 * body along the normal.
 *
 * <p>No other class of this package uses the field. Haptic thread only; an evaluation allocates
 * nothing.
 */
final class ContactField {
  /** The least slope of the field near a surface, 1/edge. */
  private static final double LEAST_SLOPE = 1e-4;

  /** The normal at the last point that was evaluated, unit, world axes. */
  final Vec3 normal = new Vec3();

  /** The height of that point over the surface, mm; negative below it. */
  double heightMm;

  private final Body body;
  private final ClearanceLevels levels;
  private final OccupancyField field;
  private final SeedCell seed = new SeedCell();
  private final CollisionScene solids;
  private final double edgeMm;
  private final Vec3 gradient = new Vec3();
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
    field = grey == null ? OccupancyField.ofBits(metric) : OccupancyField.ofGrey(metric, grey);
    solids = new CollisionScene(List.of(body.bits()));
    field.use(solids);
  }

  /**
   * Evaluates height and normal at a point that lies in an empty voxel.
   *
   * @param grid the point, grid coordinates
   * @param clearanceLevel the clearance level that the point keeps
   * @return whether there is a surface near
   */
  boolean evaluate(Vec3 grid, int clearanceLevel) {
    if (body.edits() != editsSeen) {
      editsSeen = body.edits();
      field.forget();
    }
    FieldSample sample = field.evaluate(seed.set(grid), grid);
    gradient.set(sample.gx(), sample.gy(), sample.gz());
    double slope = gradient.length();
    if (slope < LEAST_SLOPE) {
      return false;
    }
    gradient.mul(-1 / slope, gradient);
    heightMm =
        field.level().heightEdges(sample.occupancy(), gradient) * edgeMm
            - levels.reachMm(clearanceLevel, gradient);
    body.gridDirectionToWorld(gradient, normal);
    return true;
  }
}
