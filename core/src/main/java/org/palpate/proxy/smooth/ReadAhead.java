package org.palpate.proxy.smooth;

import org.palpate.geometry.Vec3;
import org.palpate.proxy.smooth.field.OccupancyField;

/**
 * Lets the field read voxels where the point will soon be, in frames that have time for it. A hand
 * that meets a surface, or comes to a new part of it, would otherwise wait for a whole window.
 *
 * <p>It changes no answer. The direction therefore outlives a reset of the solver: after an edit
 * the hand goes on as before, and after a jump it is wrong for an edge of motion. Only the work of
 * frames depends on it. Belongs to the haptic thread; allocates nothing.
 */
final class ReadAhead {
  /**
   * The distance to look ahead: the edge of a brick. A window reaches 6 cells farther, so a surface
   * is read before the point meets it.
   */
  private static final double AHEAD_EDGES = 4;

  /** The shortest motion that gives a direction. */
  private static final double MIN_MOTION_EDGES = 1;

  private final OccupancyField field;
  private final EdgeUnits units;

  /** The position of the point when its direction was found last; the grid's origin at first. */
  private final Vec3 from = new Vec3();

  /** The direction of its motion, a unit vector in edges; 0 at first. */
  private final Vec3 direction = new Vec3();

  private final Vec3 ahead = new Vec3();

  ReadAhead(OccupancyField field, EdgeUnits units) {
    this.field = field;
    this.units = units;
  }

  /** Reads a little of the voxels ahead of the point, which is at {@code position} now. */
  void read(Vec3 position) {
    if (field.interpolatesSlices()) {
      turn(position);
      units.offset(position, AHEAD_EDGES, direction, ahead);
      field.readAhead(ahead);
    }
  }

  private void turn(Vec3 position) {
    double edges = units.distance(from, position);
    if (edges >= MIN_MOTION_EDGES) {
      units.vector(from, position, direction);
      direction.mul(1 / edges, direction);
      from.set(position);
    }
  }
}
