package org.palpate.proxy.smooth;

import org.palpate.geometry.Vec3;
import org.palpate.proxy.smooth.ClosestPointSearch.Outcome;
import org.palpate.proxy.smooth.field.FieldSample;
import org.palpate.proxy.smooth.field.OccupancyField;
import org.palpate.proxy.smooth.field.SeedCell;

/**
 * Slides the point along the isosurface towards the point of it that is closest to the device. One
 * iteration brings the point to the isosurface, searches within reach, and moves there.
 */
final class SurfaceSlide {
  private static final int MAX_ITERATIONS = 6;

  /** The outcome of a free-space motion towards the device. */
  private enum Approach {
    BLOCKED,
    TO_SURFACE,
    UNHINDERED
  }

  private final OccupancyField field;
  private final VerifiedMotion motion;
  private final StraightPath straightPath;
  private final LiftedMotion liftedMotion;
  private final ClosestPointSearch search;
  private final IsosurfaceIntersection intersection;
  private final WindowBudget budget;
  private final EdgeUnits units;
  private final Vec3 start = new Vec3();
  private final Vec3 target = new Vec3();

  /** The cell from which the search reaches empty space. */
  private final SeedCell seed = new SeedCell();

  SurfaceSlide(
      OccupancyField field,
      EdgeUnits units,
      WindowBudget budget,
      VerifiedMotion motion,
      StraightPath straightPath) {
    this.field = field;
    this.units = units;
    this.budget = budget;
    this.motion = motion;
    this.straightPath = straightPath;
    liftedMotion = new LiftedMotion(motion, units);
    search = new ClosestPointSearch(field, units, budget);
    intersection = new IsosurfaceIntersection(field, units, budget);
  }

  /**
   * Slides until the point arrives, or cannot go on, or has gained enough for its work budget.
   *
   * @param limit the potential that {@code rule} accepts at most
   */
  void slide(Vec3 device, RestRule rule, double limit) {
    boolean goesOn = true;
    for (int n = 0; n < MAX_ITERATIONS && goesOn && motion.canMove(); n++) {
      goesOn = iterate(n, device);
      if (goesOn && budget.isSpent()) {
        goesOn = !budget.isOverdrawn() && !rule.accepts(motion.position(), device, limit);
      }
    }
  }

  /** Runs one iteration; returns whether another one may lead on. */
  private boolean iterate(int n, Vec3 device) {
    if (n > 0 && straightPath.verifyTowardsDevice(device)) {
      motion.commit(false);
      return false;
    }
    Vec3 point = motion.position();
    seed.set(point);
    FieldSample sample = field.evaluate(seed, point);
    if (sample.isOpen()) {
      Approach approach = approachSurface(device);
      if (approach == Approach.BLOCKED) {
        return false;
      }
    }
    Outcome outcome = search.search(seed, point, device);
    if (outcome == Outcome.NO_SURFACE) {
      return false;
    }
    if (outcome == Outcome.OUTSIDE && !search.hasLeftStart()) {
      return leaveSurface(device);
    }
    boolean moved = liftedMotion.moveTo(search.found(), search.normal());
    return moved && outcome != Outcome.CONVERGED;
  }

  /**
   * Leaves the isosurface for a device that lies above its tangent plane. Returns whether another
   * iteration may lead on.
   */
  private boolean leaveSurface(Vec3 device) {
    start.set(motion.position());
    Approach approach = approachSurface(device);
    if (approach == Approach.UNHINDERED
        && units.distance(start, motion.position()) > IsosurfaceIntersection.TOLERANCE_EDGES) {
      return true;
    }
    projectDevice(device);
    return false;
  }

  /** Moves to the projection of a close device onto the isosurface, if there is one. */
  private void projectDevice(Vec3 device) {
    Vec3 point = motion.position();
    if (units.distance(point, device) > ClosestPointSearch.REACH_EDGES) {
      return;
    }
    seed.set(point);
    Outcome outcome = search.search(seed, device, device);
    if (outcome == Outcome.CONVERGED) {
      liftedMotion.moveTo(search.found(), search.normal());
    }
  }

  /**
   * Moves straight towards the device; if a solid is in the way, to where the isosurface begins.
   */
  private Approach approachSurface(Vec3 device) {
    motion.cutToRemainingPath(device, target);
    boolean free = motion.isFree(target);
    if (free && !(straightPath.isDeviceInSolid() && target.sameBits(device))) {
      boolean moved = motion.move(target);
      return moved ? Approach.UNHINDERED : Approach.BLOCKED;
    }
    Vec3 point = motion.position();
    double last = free ? 1 : motion.blockedFraction();
    double fraction = intersection.find(point, target, last);
    if (Double.isNaN(fraction)) {
      return Approach.BLOCKED;
    }
    VerifiedMotion.between(point, target, fraction, target);
    boolean moved = motion.move(target);
    seed.set(point);
    return moved ? Approach.TO_SURFACE : Approach.BLOCKED;
  }
}
