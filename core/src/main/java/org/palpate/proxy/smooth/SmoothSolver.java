package org.palpate.proxy.smooth;

import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.ProxySolver;
import org.palpate.proxy.exact.GuardedSolver;
import org.palpate.proxy.smooth.field.BinaryCoefficientSource;
import org.palpate.proxy.smooth.field.CoefficientSource;
import org.palpate.proxy.smooth.field.GreyCoefficientSource;
import org.palpate.proxy.smooth.field.GreyIsosurface;
import org.palpate.proxy.smooth.field.GreyIsosurfaceSource;
import org.palpate.proxy.smooth.field.IsoLevel;
import org.palpate.proxy.smooth.field.OccupancyField;
import org.palpate.proxy.smooth.field.SmoothingKernel;
import org.palpate.raycast.RayHit;
import org.palpate.statistics.SkipCounters;

/**
 * Slides the interaction point on an implicit surface that is made on the fly from the voxels
 * around it, so that forces feel like the surface and not like stairs. Nothing is precalculated.
 *
 * <p>Guarantee: the point moves by legs that {@link VerifiedMotion} or {@link GuardedSolver} cast
 * exactly, whatever the surface says.
 *
 * <p>Rest: a frame counts only if it lowers a potential, the distance to the device plus what the
 * point lies below the surface ({@link #potential}), a fixed function of point, device and solids
 * in doubles, bounded below. It may rise by no more than the device moved since the last frame, and
 * has to fall by {@link #LEAST_FALL_EDGES} where the device did not move; else the frame is taken
 * back. So for a device at rest the potential falls by at least that much in every frame that moves
 * the point: there are finitely many such frames, no cycle, and then the point rests bit for bit.
 * Arriving at the device ends it too. A flight in the open towards a device beyond w_max may raise
 * the potential, but while the device rests only from nearer than every flight before: there are
 * finitely many of these as well, and after the last one the potential falls. The same rule is the
 * hysteresis between places that are about equally near. A frame that has read {@link
 * #ENOUGH_WINDOWS} ends there only where it counts, so the rule is not touched by it.
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

  /**
   * What an edge above the surface takes off an edge of distance: nearly all, so that going over
   * what stands out costs next to nothing, and below 1, so that coming down pays.
   */
  private static final double LIFT_WEIGHT = 0.98;

  /** Higher above the surface than this counts the same. */
  private static final double HIGHEST_EDGES = 2;

  /** Shares of solid below this are the open: there is no surface near. */
  private static final double OPEN_SHARE = 0.02;

  /** How far from voxels the point stays that hold it above the surface, shortest voxel edges. */
  private static final double CLEARANCE_EDGES = 1e-3;

  /** The path over which curvature is smoothed, and the ripple of it that voxels make. */
  private static final double BEND_PATH_EDGES = 12;

  private static final double BEND_RIPPLE_EDGES = 0.05;

  /** What leaving the surface for the voxels must gain beside, so that modes do not flicker. */
  private static final double TOLL_EDGES = 0.3;

  private static final int MOST_HOPS = 6;

  /**
   * A frame that read this many windows and fell as far as it must is enough: the rest of a long
   * way is left to the next one. A hand that slides two voxels a frame reads one or two.
   */
  private static final int ENOUGH_WINDOWS = 3;

  private static final double[] LIFTS_EDGES = {.05, .13, .3, .56, 1, 1.4};

  private final GridMetric metric;
  private final double shortestMm;
  private final Vec3 edges;
  private final VerifiedMotion guard;
  private final GuardedSolver onVoxels;
  private final OccupancyField field;
  private final IsoLevel level;
  private final ClosestPointSearch search;
  private final IsosurfaceIntersection crossing;
  private final Vec3 target = new Vec3();
  private final Vec3 foot = new Vec3();
  private final Vec3 low = new Vec3();
  private final Vec3 up = new Vec3();
  private final Vec3 lastDevice = new Vec3(Double.NaN, 0, 0);
  private final Vec3 restedAt = new Vec3(Double.NaN, 0, 0);

  private double nearerEdges;
  private long overOf = -1;
  private double overEdges;
  private boolean deviceInSolid;
  private double lastFlightEdges;
  private boolean onSurface;
  private long evaluationsBefore;
  private long enoughWindows;
  private int stepsOnVoxels;
  private CollisionScene obstacles;
  private Vec3 device;
  private InteractionPoint point;
  private Vec3 p;

  /**
   * A solver that knows the bits alone.
   *
   * @param metric the grid's spacing
   * @param maxStepMm the most the point may travel in one frame, w_max, positive
   */
  public SmoothSolver(GridMetric metric, double maxStepMm) {
    this(
        metric,
        maxStepMm,
        new BinaryCoefficientSource(new SmoothingKernel(metric, SmoothingKernel.FOR_BITS)));
  }

  /**
   * A solver that knows the grey values of which the solids were made by a threshold. Bits that
   * were edited since are felt as they are.
   *
   * @param metric the grid's spacing
   * @param maxStepMm the most the point may travel in one frame, w_max, positive
   */
  public SmoothSolver(GridMetric metric, double maxStepMm, GreyIsosurface grey) {
    this(metric, maxStepMm, new GreyIsosurfaceSource(grey));
  }

  /** The same where the grey values may change; {@link #reset} after each change. */
  public SmoothSolver(GridMetric metric, double maxStepMm, GreyIsosurfaceSource grey) {
    this(
        metric,
        maxStepMm,
        new GreyCoefficientSource(new SmoothingKernel(metric, SmoothingKernel.FOR_GREY), grey));
  }

  private SmoothSolver(GridMetric metric, double maxStepMm, CoefficientSource nodes) {
    if (!(maxStepMm > 0)) {
      throw new IllegalArgumentException("maxStepMm must be positive: maxStepMm=" + maxStepMm);
    }
    this.metric = metric;
    shortestMm = metric.shortestEdgeMm();
    edges =
        new Vec3(
            metric.spacingX() / shortestMm,
            metric.spacingY() / shortestMm,
            metric.spacingZ() / shortestMm);
    guard = new VerifiedMotion(metric, maxStepMm);
    onVoxels = new GuardedSolver(metric, maxStepMm);
    field = new OccupancyField(nodes, edges);
    level = new IsoLevel(nodes, edges);
    search = new ClosestPointSearch(field, level, edges);
    crossing = new IsosurfaceIntersection(field, search, edges);
  }

  @Override
  public void addSkips(SkipCounters dest) {
    onVoxels.addSkips(dest);
    guard.addSkips(dest);
  }

  @Override
  public void reset() {
    field.forget();
    onVoxels.reset();
    lastDevice.x = Double.NaN;
    restedAt.x = Double.NaN;
  }

  @Override
  public void follow(CollisionScene solids, Vec3 devicePosition, InteractionPoint moved) {
    begin(solids, devicePosition, moved);
    if (device.sameBits(restedAt) && solids == obstacles) {
      return; // nothing that the answer depends on has changed: same bits, same contact
    }
    obstacles = solids;
    field.use(solids);
    deviceInSolid = isDeviceInSolid();
    double farMm = guard.distanceMm(p, device);
    boolean near = guard.reaches(farMm);
    if (near ? !goVisibly() : !flyOn(farMm / shortestMm)) {
      followSurface(farMm / shortestMm);
    }
    point.contact = !p.sameBits(device) && isWayBlocked();
    restedAt.set(device);
    if (point.legs.count() != 0) {
      restedAt.x = Double.NaN;
    }
    lastDevice.set(device);
  }

  private void begin(CollisionScene solids, Vec3 devicePosition, InteractionPoint moved) {
    device = devicePosition;
    point = moved;
    p = moved.position;
    moved.limitsForceRate = true;
    guard.begin(solids, moved);
    evaluationsBefore = field.evaluation;
    enoughWindows = field.windows + ENOUGH_WINDOWS;
    stepsOnVoxels = 0;
  }

  /**
   * Values of the surface that the last frame took, ways that it looked at, and steps on the
   * voxels. What it read of the solids is not in here: a {@link org.palpate.volume.BitCube} can
   * count that.
   */
  public int steps() {
    return (int) (field.evaluation - evaluationsBefore) + guard.casts() + stepsOnVoxels;
  }

  private boolean isWayBlocked() {
    return deviceInSolid || !guard.isFree(device);
  }

  /** Whether the device's cell is solid: then every way that ends there is blocked. */
  private boolean isDeviceInSolid() {
    return obstacles.isSolid(
        (int) Math.floor(device.x), (int) Math.floor(device.y), (int) Math.floor(device.z));
  }

  /** Goes to a device within w_max where it can be seen. */
  private boolean goVisibly() {
    return !deviceInSolid && guard.move(device, false);
  }

  /**
   * In the open, with the device farther than w_max, the point flies straight on. While the device
   * rests it does so only from nearer than it ever did, so that such frames come to an end.
   */
  private boolean flyOn(double fromEdges) {
    if (!device.sameBits(lastDevice)) {
      lastFlightEdges = Double.POSITIVE_INFINITY;
    }
    field.seed(p.x, p.y, p.z);
    field.evaluate(p.x, p.y, p.z);
    boolean mayFly = field.value < OPEN_SHARE && lastFlightEdges - fromEdges >= LEAST_FALL_EDGES;
    if (!mayFly || !guard.move(device, false)) {
      return false;
    }
    lastFlightEdges = fromEdges;
    return true;
  }

  /** Goes towards the device as far as w_max allows, where nothing is in the way. */
  private boolean goStraight() {
    return guard.reaches(device) ? goVisibly() : guard.move(device, false);
  }

  private void followSurface(double farEdges) {
    double highest = potential(farEdges) + allowedRise();
    slide(highest);
    if (guard.hasMoved() && isBelow(highest)) {
      point.surfaceHeightMm = shortestMm * heightOnSurface();
      onSurface = true;
      return;
    }
    guard.takeBack();
    onVoxels.reset();
    onVoxels.follow(obstacles, device, point);
    stepsOnVoxels = onVoxels.steps();
    double toll = onSurface ? TOLL_EDGES : 0;
    if (guard.hasMoved() && isBelow(highest - toll)) {
      point.surfaceHeightMm = shortestMm * heightOnVoxels();
      onSurface = false;
    } else {
      guard.takeBack();
    }
  }

  /** How high the point is over what it stands for, as the field says, where it slides on it. */
  private double heightOnSurface() {
    double most = level.heightEdges() + HIGHEST_EDGES;
    double height = level.heightEdges() + overLevel() - nearerWhereBent();
    return Math.max(0, Math.min(most, height));
  }

  /**
   * How much nearer the level runs where the surface is bent: smoothed over the path, for single
   * curvatures carry the ripple of the voxels, but never far from what they say.
   */
  private double nearerWhereBent() {
    double now = level.nearerWhereBent(search.sumOfCurvatures());
    double share = Math.min(1, point.legs.lengthMm() / (shortestMm * BEND_PATH_EDGES));
    double smoothed = nearerEdges + share * (now - nearerEdges);
    nearerEdges = Math.max(now - BEND_RIPPLE_EDGES, Math.min(now + BEND_RIPPLE_EDGES, smoothed));
    return nearerEdges;
  }

  /** The same where voxels hold the point: 0 where they stand alone, and deep between them. */
  private double heightOnVoxels() {
    if (!search.findNormal()) {
      return 0;
    }
    double crowd = 2 * field.value / level.share(search.normal) - 1;
    return Math.max(0, Math.min(1, crowd)) * Math.min(level.heightEdges(), heightOnSurface());
  }

  /** How far the point lies over the level, where the field was evaluated last. */
  private double overLevel() {
    if (overOf != field.evaluation) {
      overOf = field.evaluation;
      overEdges = overLevelAnew();
    }
    return overEdges;
  }

  private double overLevelAnew() {
    if (!search.findNormal()) {
      return field.value < OPEN_SHARE ? HIGHEST_EDGES : 0;
    }
    double over = level.over(field.value, search.normal);
    return Math.max(-level.heightEdges(), Math.min(HIGHEST_EDGES, over));
  }

  private double allowedRise() {
    double moved = distanceEdges(lastDevice, device);
    return Double.isNaN(moved) ? Double.POSITIVE_INFINITY : moved - LEAST_FALL_EDGES;
  }

  private boolean isBelow(double highest) {
    return p.sameBits(device) || potential() <= highest;
  }

  /**
   * What falls: the distance to the device, with most of the height above the surface taken off and
   * the depth below it added, weighed; in shortest edges.
   */
  double potential() {
    return potential(distanceEdges(p, device));
  }

  private double potential(double farEdges) {
    field.seed(p.x, p.y, p.z);
    field.evaluate(p.x, p.y, p.z);
    double over = overLevel();
    if (over > 0) {
      return farEdges - LIFT_WEIGHT * over;
    }
    return farEdges + DEPTH_WEIGHT * (over > -DEEPEST_EDGES ? -over : DEEPEST_EDGES);
  }

  private double distanceEdges(Vec3 from, Vec3 to) {
    return metric.distance(from.x, from.y, from.z, to.x, to.y, to.z) / shortestMm;
  }

  /** Moves along the surface towards the point nearest to the device, hop by hop. */
  private void slide(double highest) {
    for (int hop = 0; hop < MOST_HOPS && guard.canMove(); hop++) {
      if (!hop(hop) || (hasWorkedEnough() && isBelow(highest))) {
        return;
      }
    }
  }

  private long mostWindows() {
    return enoughWindows + ClosestPointSearch.SOME_WINDOWS;
  }

  private boolean hasWorkedEnough() {
    return field.windows >= enoughWindows;
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
    int answer = search.search(p, device, enoughWindows);
    if (answer == ClosestPointSearch.LOST) {
      return false;
    }
    if (answer == ClosestPointSearch.OUTSIDE && search.at.sameBits(p)) {
      return flyOrProject();
    }
    return goTo(search.at) && answer != ClosestPointSearch.FOUND;
  }

  private boolean flyOrProject() {
    foot.set(p);
    if (fly() && distanceEdges(foot, p) > IsosurfaceIntersection.EDGES) {
      return true;
    }
    field.seed(p.x, p.y, p.z);
    if (distanceEdges(p, device) > ClosestPointSearch.REACH_EDGES
        || search.search(device, device, enoughWindows) != ClosestPointSearch.FOUND) {
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
    double share = crossing.find(p, target, guard.hit.t, mostWindows());
    if (Double.isNaN(share)) {
      return false;
    }
    VerifiedMotion.between(p, target, share, foot);
    boolean moved = guard.move(foot, false);
    field.seed(p.x, p.y, p.z);
    return moved;
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
      VerifiedMotion.between(from, to, Math.max(0, guard.hit.t - clearance), dest);
    }
  }

  /** First rises from where it is, along faces that lean over it, then goes over and down. */
  private boolean riseAndGoTo(Vec3 to) {
    up.set(search.normal);
    double over = heightOver(to);
    for (double lift : LIFTS_EDGES) {
      if (!rise(lift, foot)) {
        return false;
      }
      liftedAbove(to, Math.max(0, over) + lift, target);
      if (guard.isFree(foot, target)) {
        lowerOnVoxels(target, to, low);
        return guard.move(foot, true) && guard.move(guard.isFree(foot, low) ? low : target, true);
      }
    }
    return false;
  }

  /** How high the point is over the tangent plane of {@code to}, edges. */
  private double heightOver(Vec3 to) {
    return (p.x - to.x) * edges.x * search.normal.x
        + (p.y - to.y) * edges.y * search.normal.y
        + (p.z - to.z) * edges.z * search.normal.z;
  }

  /**
   * Writes where a rise by {@code lift} leads; a face in the way takes its axis off {@link #up}.
   */
  private boolean rise(double lift, Vec3 dest) {
    for (int tries = 0; tries < 3; tries++) {
      dest.set(
          p.x + lift * up.x / edges.x, p.y + lift * up.y / edges.y, p.z + lift * up.z / edges.z);
      if (guard.isFree(dest)) {
        return true;
      }
      if (guard.hit.axis == RayHit.NO_AXIS) {
        return false;
      }
      up.set(guard.hit.axis, 0);
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
