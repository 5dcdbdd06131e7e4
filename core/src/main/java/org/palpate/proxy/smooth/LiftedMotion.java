package org.palpate.proxy.smooth;

import org.palpate.geometry.Vec3;
import org.palpate.raycast.RayHit;

/**
 * Moves the point to a position on the isosurface. If voxels stand out of the isosurface there, the
 * point moves to the lowest free position above it that the search finds.
 */
final class LiftedMotion {
  /** The heights above the isosurface that are tried, lowest first. */
  private static final double[] LIFTS_EDGES = {.05, .13, .3, .56, 1, 1.4};

  /** The distance that the point keeps from voxels that stop it on its way down. */
  private static final double CLEARANCE_EDGES = 1e-3;

  private static final int AXES = 3;

  private final VerifiedMotion motion;
  private final EdgeUnits units;

  /** The direction in which the point rises, along the faces that overhang it. */
  private final Vec3 up = new Vec3();

  /** The end of a rise from the point. */
  private final Vec3 risen = new Vec3();

  /** A position above the one to be reached. */
  private final Vec3 above = new Vec3();

  /** The lowest position that the segment down from there reaches. */
  private final Vec3 lowered = new Vec3();

  LiftedMotion(VerifiedMotion motion, EdgeUnits units) {
    this.motion = motion;
    this.units = units;
  }

  /**
   * Moves the point to a position on the isosurface, or above it.
   *
   * @param to the position
   * @param normal the outward unit normal there
   * @return whether a leg towards it was found; if not, the point stays, or has only risen
   */
  boolean moveTo(Vec3 to, Vec3 normal) {
    boolean moved = motion.slide(to);
    if (!moved) {
      moved = moveAbove(to, normal);
    }
    if (!moved) {
      moved = riseAndMoveAbove(to, normal);
    }
    return moved;
  }

  /** Moves in one leg to the lowest free position above {@code to} that the tried heights give. */
  private boolean moveAbove(Vec3 to, Vec3 normal) {
    for (double lift : LIFTS_EDGES) {
      units.offset(to, lift, normal, above);
      if (motion.isFree(above)) {
        lower(above, to, lowered);
        return motion.slide(motion.isFree(lowered) ? lowered : above);
      }
    }
    return false;
  }

  /** Rises from where the point is, and then moves over and down. */
  private boolean riseAndMoveAbove(Vec3 to, Vec3 normal) {
    up.set(normal);
    double height = Math.max(0, units.height(motion.position(), to, normal));
    for (double lift : LIFTS_EDGES) {
      boolean canRise = findRise(lift);
      if (!canRise) {
        return false;
      }
      units.offset(to, height + lift, normal, above);
      if (motion.isFree(risen, above)) {
        lower(above, to, lowered);
        return moveOver();
      }
    }
    return false;
  }

  /** Moves up to {@link #risen} and on to {@link #lowered}, or else to {@link #above}. */
  private boolean moveOver() {
    boolean rose = motion.slide(risen);
    if (!rose) {
      return false;
    }
    return motion.slide(motion.isFree(risen, lowered) ? lowered : above);
  }

  /** Writes the position at which voxels stop a straight segment downwards, a little above them. */
  private void lower(Vec3 from, Vec3 to, Vec3 dest) {
    if (motion.isFree(from, to)) {
      dest.set(to);
    } else {
      double clearance = CLEARANCE_EDGES / Math.max(CLEARANCE_EDGES, units.distance(from, to));
      double fraction = Math.max(0, motion.blockedFraction() - clearance);
      VerifiedMotion.between(from, to, fraction, dest);
    }
  }

  /**
   * Finds the end of a free rise by {@code lift}; a face in the way takes its axis off the
   * direction, for higher lifts as well.
   *
   * @return false if there is none
   */
  private boolean findRise(double lift) {
    for (int tries = 0; tries < AXES; tries++) {
      units.offset(motion.position(), lift, up, risen);
      if (motion.isFree(risen)) {
        return true;
      }
      int axis = motion.blockedAxis();
      if (axis == RayHit.NO_AXIS) {
        return false;
      }
      up.set(axis, 0);
    }
    return false;
  }
}
