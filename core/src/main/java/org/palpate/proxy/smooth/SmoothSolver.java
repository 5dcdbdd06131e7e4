package org.palpate.proxy.smooth;

import org.palpate.geometry.Vec3;
import org.palpate.proxy.GuardedSolver;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.Metric;
import org.palpate.proxy.Obstacles;
import org.palpate.proxy.ProxySolver;

/**
 * Slides the interaction point on an implicit surface that is made on the fly from the voxels
 * around it, so that forces feel like the surface and not like stairs. Nothing is precalculated.
 *
 * <p>Guarantee: the point moves by legs that {@link LegGuard} or {@link GuardedSolver} cast
 * exactly, whatever the surface says.
 *
 * <p>Rest: a frame counts only if it lowers a potential, the distance to the device plus what the
 * point lies below the surface ({@link #potential}), a fixed function of point, device and solids
 * in doubles. It may rise by no more than the device moved since the last frame, and has to fall by
 * {@link #LEAST_FALL_EDGES} where the device did not move; else the frame is taken back. So for a
 * device at rest the potential, never negative, falls by at least that much in every frame that
 * moves the point: there are finitely many such frames, no cycle, and then the point rests bit for
 * bit. Arriving at the device ends it too: the way to go is then of length 0. The same rule is the
 * hysteresis between places that are about equally near.
 *
 * <p>References: Zilles and Salisbury 1995, Salisbury and Tarr 1997, Chan et al. 2011. Haptic
 * thread only; allocates nothing.
 */
public final class SmoothSolver implements ProxySolver {
  /** How much nearer a frame must lead when the device rests, shortest voxel edges. */
  static final double LEAST_FALL_EDGES = 1e-6;

  /**
   * What an edge below the surface weighs against an edge of distance. Above 1, so that leaving the
   * inside pays; twice that, as the field is flatter in places.
   */
  private static final double DEPTH_WEIGHT = 2;

  /** Deeper below the surface than this counts the same: slits are all inside. */
  private static final double DEEPEST_EDGES = 1;

  /** Shares of solid below this are the open: there is no surface near. */
  private static final double OPEN_SHARE = 0.02;

  private static final double CROSSING_EDGES = 0.02;

  /** How far from voxels the point stays that hold it above the surface, shortest voxel edges. */
  private static final double CLEARANCE_EDGES = 1e-3;

  private static final int MOST_HOPS = 6;
  private static final double[] LIFTS_EDGES = {.05, .13, .3, .56, 1, 1.4};

  private final Metric metric;
  private final double shortestMm;
  private final Vec3 edges;
  private final LegGuard guard;
  private final GuardedSolver onVoxels;
  private final SmoothField field;
  private final SurfaceLevel level;
  private final ContactSearch search;
  private final Vec3 target = new Vec3();
  private final Vec3 foot = new Vec3();
  private final Vec3 lastDevice = new Vec3(Double.NaN, 0, 0);
  private final Vec3 restedAt = new Vec3(Double.NaN, 0, 0);

  private Obstacles obstacles;
  private Vec3 device;
  private InteractionPoint point;
  private Vec3 p;

  /**
   * A solver for one grid.
   *
   * @param metric the grid's spacing
   * @param maxStepMm the most the point may travel in one frame, w_max, positive
   */
  public SmoothSolver(Metric metric, double maxStepMm) {
    if (!(maxStepMm > 0)) {
      throw new IllegalArgumentException("maxStepMm must be positive: maxStepMm=" + maxStepMm);
    }
    this.metric = metric;
    shortestMm = Math.min(metric.spacingX(), Math.min(metric.spacingY(), metric.spacingZ()));
    edges =
        new Vec3(
            metric.spacingX() / shortestMm,
            metric.spacingY() / shortestMm,
            metric.spacingZ() / shortestMm);
    guard = new LegGuard(metric, maxStepMm);
    onVoxels = new GuardedSolver(metric, maxStepMm);
    NodeSource nodes = new BitNodes(new SmoothingKernel(metric));
    field = new SmoothField(nodes, edges);
    level = new SurfaceLevel(nodes);
    search = new ContactSearch(field, level, edges);
  }

  @Override
  public void reset() {
    field.forget();
    onVoxels.reset();
    lastDevice.x = Double.NaN;
    restedAt.x = Double.NaN;
  }

  @Override
  public void follow(Obstacles solids, Vec3 devicePosition, InteractionPoint moved) {
    begin(solids, devicePosition, moved);
    if (device.sameBits(restedAt) && solids == obstacles) {
      return; // nothing that the answer depends on has changed: same bits, same contact
    }
    obstacles = solids;
    field.use(solids);
    if (!goStraight()) {
      followSurface();
    }
    point.contact = !p.sameBits(device) && isWayBlocked();
    restedAt.set(device);
    if (point.legs.count() != 0) {
      restedAt.x = Double.NaN;
    }
    lastDevice.set(device);
  }

  private void begin(Obstacles solids, Vec3 devicePosition, InteractionPoint moved) {
    device = devicePosition;
    point = moved;
    p = moved.position;
    guard.begin(solids, moved);
  }

  private boolean isWayBlocked() {
    return deviceIsInSolid() || !guard.isFree(device);
  }

  /** Whether the device's cell is solid: then every way that ends there is blocked. */
  private boolean deviceIsInSolid() {
    return obstacles.isSolid(
        (int) Math.floor(device.x), (int) Math.floor(device.y), (int) Math.floor(device.z));
  }

  /** Where the device can be seen the point goes there. */
  private boolean goStraight() {
    boolean hopeless = guard.reaches(device) && deviceIsInSolid();
    return !hopeless && guard.move(device, false);
  }

  private void followSurface() {
    double highest = potential() + allowedRise();
    slide();
    if (guard.hasMoved() && isBelow(highest)) {
      point.surfaceHeightMm = shortestMm * heightOnSurface();
      return;
    }
    guard.takeBack();
    onVoxels.reset();
    onVoxels.follow(obstacles, device, point);
    if (guard.hasMoved() && isBelow(highest)) {
      point.surfaceHeightMm = shortestMm * heightOnVoxels();
    } else {
      guard.takeBack();
    }
  }

  /** The height of the surface's share at the point over solid, edges: more where it was lifted. */
  private double heightOnSurface() {
    double lifted = Math.max(0, Math.min(1, search.heightEdges));
    return SurfaceLevel.HEIGHT_EDGES * below() + lifted;
  }

  /** The same where voxels hold the point: 0 where they stand alone, and deep between them. */
  private double heightOnVoxels() {
    double share = level.share(search.normal);
    double above = Math.max(0, Math.min(1, 2 * field.value / share - 1));
    return SurfaceLevel.HEIGHT_EDGES * Math.min(above, below());
  }

  /** From 1 on the surface to 0 at half solid. */
  private double below() {
    double share = level.share(search.normal);
    return Math.max(0, Math.min(1, (0.5 - field.value) / (0.5 - share)));
  }

  private double allowedRise() {
    double moved = distanceEdges(lastDevice, device);
    return Double.isNaN(moved) ? Double.POSITIVE_INFINITY : moved - LEAST_FALL_EDGES;
  }

  private boolean isBelow(double highest) {
    return p.sameBits(device) || potential() <= highest;
  }

  /**
   * What falls: the distance to the device and, weighed, how far the point lies below the surface
   * as the field's plane shows it; in shortest edges.
   */
  private double potential() {
    field.seed(p.x, p.y, p.z);
    field.evaluate(p.x, p.y, p.z);
    double below = 0;
    if (search.findNormal()) {
      below = (field.value - level.share(search.normal)) / level.slope();
    }
    return distanceEdges(p, device) + DEPTH_WEIGHT * Math.max(0, Math.min(DEEPEST_EDGES, below));
  }

  private double distanceEdges(Vec3 from, Vec3 to) {
    return metric.distance(from.x, from.y, from.z, to.x, to.y, to.z) / shortestMm;
  }

  /** Moves along the surface towards the point nearest to the device, hop by hop. */
  private void slide() {
    for (int hop = 0; hop < MOST_HOPS && guard.canMove(); hop++) {
      if (!hop(hop)) {
        return;
      }
    }
  }

  /** One hop; true where another one may lead on. */
  private boolean hop(int number) {
    if (number > 0 && goStraight()) {
      return false;
    }
    field.seed(p.x, p.y, p.z);
    field.evaluate(p.x, p.y, p.z);
    if (field.value < OPEN_SHARE && !fly()) {
      return false;
    }
    int answer = search.search(p, device);
    if (answer == ContactSearch.LOST) {
      return false;
    }
    if (answer == ContactSearch.OUTSIDE && search.at.sameBits(p)) {
      return flyOrProject();
    }
    return goTo(search.at) && answer != ContactSearch.FOUND;
  }

  private boolean flyOrProject() {
    foot.set(p);
    if (fly() && distanceEdges(foot, p) > CROSSING_EDGES) {
      return true;
    }
    field.seed(p.x, p.y, p.z);
    if (distanceEdges(p, device) > ContactSearch.REACH_EDGES
        || search.search(device, device) != ContactSearch.FOUND) {
      return false;
    }
    goTo(search.at);
    return false;
  }

  /** Flies towards the device up to where the surface begins; false where there is none. */
  private boolean fly() {
    guard.cutToPathLeft(device, target);
    if (guard.isFree(target)) {
      return guard.move(target, false);
    }
    double low = 0;
    double high = guard.hit.t;
    double length = distanceEdges(p, target);
    if (!isInside(high)) {
      return false;
    }
    while ((high - low) * length > CROSSING_EDGES) {
      double middle = 0.5 * (low + high);
      if (isInside(middle)) {
        high = middle;
      } else {
        low = middle;
      }
    }
    LegGuard.between(p, target, low, foot);
    boolean moved = guard.move(foot, false);
    field.seed(p.x, p.y, p.z);
    return moved;
  }

  /** Whether the surface has been passed at a share of the way to the target. */
  private boolean isInside(double share) {
    LegGuard.between(p, target, share, foot);
    field.seed(foot.x, foot.y, foot.z);
    field.evaluate(foot.x, foot.y, foot.z);
    return search.findNormal() && search.heightEdges < 0;
  }

  /** Goes to a point of the surface, above it where a voxel is in the way; false when it stays. */
  private boolean goTo(Vec3 to) {
    return guard.move(to, true) || goAbove(to) || riseAndGoTo(to);
  }

  /** Goes as near above {@code to} as the voxels there let it. */
  private boolean goAbove(Vec3 to) {
    for (double lift : LIFTS_EDGES) {
      liftedAbove(to, lift, foot);
      if (guard.isFree(foot)) {
        lowerOnVoxels(foot, to, target);
        return guard.move(guard.isFree(target) ? target : foot, true);
      }
    }
    return false;
  }

  /** Writes where the way from a free point down to another one is stopped, a little above. */
  private void lowerOnVoxels(Vec3 from, Vec3 to, Vec3 dest) {
    if (guard.isFree(from, to)) {
      dest.set(to);
    } else {
      double clearance = CLEARANCE_EDGES / Math.max(CLEARANCE_EDGES, distanceEdges(from, to));
      LegGuard.between(from, to, Math.max(0, guard.hit.t - clearance), dest);
    }
  }

  /** First rises from where it is, then goes over what is in the way. */
  private boolean riseAndGoTo(Vec3 to) {
    for (double lift : LIFTS_EDGES) {
      liftedAbove(p, lift, foot);
      liftedAbove(to, lift, target);
      if (guard.isFree(p, foot) && guard.isFree(foot, target)) {
        return guard.move(foot, true) && guard.move(target, true);
      }
    }
    return false;
  }

  private void liftedAbove(Vec3 from, double lift, Vec3 dest) {
    dest.set(
        from.x + lift * search.normal.x / edges.x,
        from.y + lift * search.normal.y / edges.y,
        from.z + lift * search.normal.z / edges.z);
  }
}
