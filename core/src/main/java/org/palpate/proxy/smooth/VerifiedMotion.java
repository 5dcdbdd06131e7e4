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
 * Moves the interaction point by propose, verify, commit.
 *
 * <ol>
 *   <li>Propose: {@link #verify} takes any end for the next leg and cuts the leg to the path that
 *       w_max leaves.
 *   <li>Verify: it casts the straight segment between the two doubles exactly against every closed
 *       solid voxel.
 *   <li>Commit: {@link #commit} moves the point along the verified leg and adds it to the path.
 * </ol>
 *
 * <p>Invariant: every leg of the path was verified, and each starts bit for bit where the last one
 * ended. So the guarantee depends on no solver and on no field. The point's position has no other
 * writer in this package; {@link #takeBack} restores the position at which the frame began.
 *
 * <p>Belongs to the haptic thread; allocates nothing. Cost: one exact cast a verification.
 */
final class VerifiedMotion {
  private final GridMetric metric;
  private final PathLimit pathLimit;
  private final ExactRayCaster caster = new ExactRayCaster();
  private final Ray ray = new Ray();
  private final RayHit hit = new RayHit();
  private final Vec3 start = new Vec3();

  /** The end of the leg that was proposed last. */
  private final Vec3 target = new Vec3();

  /** Whether that leg may be committed. */
  private boolean verified;

  /** Whether that leg has no length, so that there is nothing to add to the path. */
  private boolean targetIsPosition;

  private int casts;
  private CollisionScene scene;
  private Vec3 position;
  private LegPath legs;

  /**
   * Creates the motion for one grid.
   *
   * @param maxStepMm the longest path of one frame, w_max
   */
  VerifiedMotion(GridMetric metric, double maxStepMm) {
    this.metric = metric;
    pathLimit = new PathLimit(metric, maxStepMm);
  }

  /** Begins a frame: clears the path and notes where the point is. */
  void beginFrame(CollisionScene newScene, InteractionPoint point) {
    scene = newScene;
    position = point.position;
    legs = point.legs;
    legs.clear();
    verified = false;
    casts = 0;
    start.set(position);
  }

  /** Returns where the point is, grid coordinates, not to be changed. */
  Vec3 position() {
    return position;
  }

  /** Takes back all legs of this frame, whoever moved the point. */
  void takeBack() {
    legs.clear();
    verified = false;
    position.set(start);
  }

  /**
   * Whether the straight segment between two positions touches no solid. If not, {@link
   * #blockedFraction} and {@link #blockedAxis} say where.
   */
  boolean isFree(Vec3 from, Vec3 to) {
    casts++;
    return !scene.cast(caster, ray.from(from.x, from.y, from.z).to(to.x, to.y, to.z), hit);
  }

  /** Whether the straight segment from the point to {@code to} touches no solid. */
  boolean isFree(Vec3 to) {
    return isFree(position, to);
  }

  /** Returns the fraction of the last blocked segment at which it meets a solid. */
  double blockedFraction() {
    return hit.t;
  }

  /**
   * Returns the axis of the face that blocked the last segment: 0, 1, 2, or {@link RayHit#NO_AXIS}.
   */
  int blockedAxis() {
    return hit.axis;
  }

  /** Whether w_max allows one leg to {@code to}. */
  boolean reaches(Vec3 to) {
    return reaches(distanceMm(position, to));
  }

  /** Whether w_max allows one leg of this length. */
  boolean reaches(double lengthMm) {
    return lengthMm <= pathLimit.remainingMm(legs);
  }

  /** Whether w_max and the path's capacity allow another leg in this frame. */
  boolean canMove() {
    return !legs.isFull() && !pathLimit.isUsedUp(legs);
  }

  /** Whether the point has moved in this frame. */
  boolean hasMoved() {
    return legs.count() != 0;
  }

  /** Returns how many segments were cast in this frame. */
  int casts() {
    return casts;
  }

  /**
   * Proposes a leg straight to {@code to}, or as far towards it as w_max allows, and verifies it.
   * Nothing moves.
   *
   * @return whether the leg touches no solid and may be committed
   */
  boolean verify(Vec3 to) {
    verified = false;
    if (!legs.isFull()) {
      cutToRemainingPath(to, target);
      targetIsPosition = target.sameBits(position);
      verified = targetIsPosition || (target.isFinite() && isFree(target));
    }
    return verified;
  }

  /**
   * Moves the point along the leg that was verified last; a leg without length is left out.
   *
   * @param alongSurface whether the leg slides along a surface, for friction
   * @throws IllegalStateException if no leg is verified
   */
  void commit(boolean alongSurface) {
    if (!verified) {
      throw new IllegalStateException("no verified leg to commit from " + position);
    }
    verified = false;
    if (!targetIsPosition) {
      addLeg(alongSurface);
      position.set(target);
    }
  }

  private void addLeg(boolean alongSurface) {
    legs.add(
        position.x,
        position.y,
        position.z,
        target.x,
        target.y,
        target.z,
        distanceMm(position, target),
        alongSurface);
  }

  /** Moves straight towards {@code to} through free space; returns whether the leg was verified. */
  boolean move(Vec3 to) {
    boolean free = verify(to);
    if (free) {
      commit(false);
    }
    return free;
  }

  /** Moves straight towards {@code to} along a surface; returns whether the leg was verified. */
  boolean slide(Vec3 to) {
    boolean free = verify(to);
    if (free) {
      commit(true);
    }
    return free;
  }

  /** Writes the end of a leg towards {@code to}, cut to the path that w_max leaves. */
  void cutToRemainingPath(Vec3 to, Vec3 dest) {
    pathLimit.cut(legs, position, to, dest);
  }

  /** Writes the position at a fraction of a straight segment, rounded. */
  static void between(Vec3 from, Vec3 to, double fraction, Vec3 dest) {
    dest.set(
        from.x + fraction * (to.x - from.x),
        from.y + fraction * (to.y - from.y),
        from.z + fraction * (to.z - from.z));
  }

  /** Returns the distance between two positions, mm. */
  double distanceMm(Vec3 from, Vec3 to) {
    return metric.distance(from.x, from.y, from.z, to.x, to.y, to.z);
  }

  /** Adds the work that the casts left out to {@code dest}. */
  void addSkips(SkipCounters dest) {
    caster.addSkips(dest);
  }
}
