package org.palpate.proxy.smooth;

import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.LegPath;
import org.palpate.proxy.PathLimit;
import org.palpate.raycast.ExactRayCaster;
import org.palpate.raycast.Ray;
import org.palpate.raycast.RayHit;
import org.palpate.statistics.SkipCounters;

/**
 * Moves the interaction point, and only by legs that touch no solid: each leg is cast exactly, as
 * the segment between its two doubles, before the point moves. Nothing else in this package writes
 * the point's position, save to take back the legs of a frame.
 */
final class VerifiedMotion {
  /** What the last cast that was blocked hit. */
  final RayHit hit = new RayHit();

  private final GridMetric metric;
  private final PathLimit pathLimit;
  private final ExactRayCaster caster = new ExactRayCaster();
  private final Ray ray = new Ray();
  private final Vec3 target = new Vec3();
  private final Vec3 start = new Vec3();

  /** Ways looked at since the frame began. */
  private int casts;

  private CollisionScene obstacles;
  private Vec3 position;
  private LegPath legs;

  VerifiedMotion(GridMetric metric, double maxStepMm) {
    this.metric = metric;
    pathLimit = new PathLimit(metric, maxStepMm);
  }

  /** Begins a frame: forgets the point's legs and remembers where it is. */
  void begin(CollisionScene newObstacles, InteractionPoint point) {
    obstacles = newObstacles;
    position = point.position;
    legs = point.legs;
    legs.clear();
    casts = 0;
    start.set(position);
  }

  /** Takes back all legs of this frame. */
  void takeBack() {
    legs.clear();
    position.set(start);
  }

  /** Whether the straight way between two points touches no solid; else {@link #hit} says where. */
  boolean isFree(Vec3 from, Vec3 to) {
    casts++;
    return !obstacles.cast(caster, ray.from(from.x, from.y, from.z).to(to.x, to.y, to.z), hit);
  }

  /** Whether the straight way from the point to {@code to} touches no solid. */
  boolean isFree(Vec3 to) {
    return isFree(position, to);
  }

  /** Whether w_max allows to go to {@code to} in one leg. */
  boolean reaches(Vec3 to) {
    return reaches(distanceMm(position, to));
  }

  /** Whether w_max allows to go this far in one leg. */
  boolean reaches(double lengthMm) {
    return lengthMm <= pathLimit.remainingMm(legs);
  }

  /** Whether there is path and room for another leg in this frame. */
  boolean canMove() {
    return !legs.isFull() && !pathLimit.isUsedUp(legs);
  }

  /** Ways that were looked at in this frame. */
  int casts() {
    return casts;
  }

  boolean hasMoved() {
    return legs.count() != 0;
  }

  /**
   * Goes straight to {@code to}, or as far as w_max allows; stays where a solid is in the way.
   *
   * @param alongSurface whether the leg slides along a surface
   * @return whether the way that w_max allows was free
   */
  boolean move(Vec3 to, boolean alongSurface) {
    if (legs.isFull()) {
      return false;
    }
    cutToPathLeft(to, target);
    if (target.sameBits(position)) {
      return true;
    }
    if (!target.isFinite() || !isFree(target)) {
      return false;
    }
    double lengthMm = distanceMm(position, target);
    legs.add(
        position.x, position.y, position.z, target.x, target.y, target.z, lengthMm, alongSurface);
    position.set(target);
    return true;
  }

  /** Writes the point that w_max allows to reach on the segment to {@code to} into {@code dest}. */
  void cutToPathLeft(Vec3 to, Vec3 dest) {
    pathLimit.cut(legs, position, to, dest);
  }

  /** Writes the point at {@code share} of the way, rounded. */
  static void between(Vec3 from, Vec3 to, double share, Vec3 dest) {
    dest.set(
        from.x + share * (to.x - from.x),
        from.y + share * (to.y - from.y),
        from.z + share * (to.z - from.z));
  }

  double distanceMm(Vec3 from, Vec3 to) {
    return metric.distance(from.x, from.y, from.z, to.x, to.y, to.z);
  }

  /** Adds what its rays skipped. */
  void addSkips(SkipCounters dest) {
    caster.addSkips(dest);
  }
}
