package org.palpate.proxy.exact;

import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.LegPath;
import org.palpate.proxy.ProxySolver;
import org.palpate.raycast.ExactRayCaster;
import org.palpate.raycast.Ray;
import org.palpate.raycast.RayHit;
import org.palpate.statistics.SkipCounters;
import org.palpate.statistics.SkipKind;

/**
 * The paper's path finding made exact: every leg, as the segment between its two doubles, is
 * disjoint from every closed solid voxel; each starts bit for bit where the last one ended.
 *
 * <p>A frame goes straight towards the device, stops {@link #STOP_SHORT_VOXELS} before what is in
 * the way, goes on along its face, and where it is stuck climbs a stair of one voxel, or of a few
 * where it is far behind, when it comes out nearer on top. So a frame ends strictly nearer to the
 * device, by {@link GridMetric#squaredDistance} in doubles, or at the same bits: squared distances
 * are finitely many, so for a device at rest there is no cycle and an end. A way over very many
 * stairs goes on in the next frame, see {@link #ENOUGH_STEPS}.
 *
 * <p>Source: the way of following surfaces is Vlasov et al. 2013, section 4.2; faces as constraints
 * that are held until the way is free are Zilles and Salisbury 1995. Haptic thread only; allocates
 * nothing. Cost: a few casts of about the frame's travel.
 */
public final class GuardedSolver implements ProxySolver {
  /**
   * How far before a face the point stops, in voxels. A power of two, so that face and gap add
   * without rounding up to coordinates of 2^32; far below what a hand feels, far above the rounding
   * of coordinates.
   */
  public static final double STOP_SHORT_VOXELS = 0x1p-20;

  /**
   * A leg cut to the path that is left is cut a little shorter, so that rounding cannot exceed
   * w_max.
   */
  private static final double CUT_SHORT = 1 - 0x1p-40;

  /** By more than a few roundings can hide. */
  private static final double SURELY_LESS = 1 - 0x1p-40;

  /**
   * From how far behind the device, in shortest voxel edges, a climb goes up more than one stair.
   * The farther the device, the less a step along a convex surface brings: on a torus pressed 10
   * voxels deep one stair alone leaves the point up to 15 % farther away than the paper's way does;
   * below 8 it would cost a quarter of the frame's time for 1 %.
   */
  private static final double FAR_VOXELS = 8;

  /** A fourth stair was measured to bring nothing. */
  private static final int STAIRS_IF_FAR = 3;

  /** Along a longer way the ray cast, which skips empty bricks, is faster than voxel by voxel. */
  private static final double LONGEST_ROW_VOXELS = 16;

  /**
   * A frame that came nearer and took more steps than this is enough: the rest of a long way is
   * left to the next one. A hand that slides two voxels a frame takes a dozen; only jumps over many
   * stairs take more, most where w_max is many voxels.
   */
  public static final int ENOUGH_STEPS = 40;

  /** A long way counts as a step more for each of these: where w_max is many voxels. */
  private static final double VOXELS_A_STEP = 8;

  /** And as no more than of this length. */
  private static final double LONG_VOXELS = 64;

  private static final int NOTHING_HELD = 0;

  private final GridMetric metric;
  private final double maxStepMm;
  private final double farMm;
  private final boolean skipsRest;
  private final ExactRayCaster caster = new ExactRayCaster();
  private final Ray ray = new Ray();
  private final RayHit hit = new RayHit();
  private final Vec3 target = new Vec3();
  private final Vec3 end = new Vec3();
  private final Vec3 beforeClimb = new Vec3();
  private final Vec3 restedAt = new Vec3();
  private final ProxyVoxel voxel;
  private final FailedStepCache fruitless;

  private CollisionScene obstacles;
  private Vec3 device;
  private Vec3 p;
  private LegPath legs;
  private boolean stopped;
  private boolean outOfPath;
  private boolean rests;
  private boolean pathTooShort;
  private boolean skippedClimbs;
  private long climbsSkipped;
  private long restsSkipped;
  private int steps;

  /**
   * A solver for one grid.
   *
   * @param metric the grid's spacing
   * @param maxStepMm the most the point may travel in one frame, w_max, positive
   */
  public GuardedSolver(GridMetric metric, double maxStepMm) {
    this(metric, maxStepMm, SkipOptions.ALL);
  }

  /** Returns a solver that skips only some of its work, to measure what the rest is worth. */
  static GuardedSolver skippingOnly(SkipOptions skips, GridMetric metric, double maxStepMm) {
    return new GuardedSolver(metric, maxStepMm, skips);
  }

  private GuardedSolver(GridMetric metric, double maxStepMm, SkipOptions skips) {
    if (!(maxStepMm > 0)) {
      throw new IllegalArgumentException("maxStepMm must be positive: maxStepMm=" + maxStepMm);
    }
    this.metric = metric;
    this.maxStepMm = maxStepMm;
    farMm = FAR_VOXELS * metric.shortestEdgeMm();
    voxel = new ProxyVoxel(skips.neighbourhoods());
    fruitless = new FailedStepCache(metric, skips.failedSteps());
    skipsRest = skips.rest();
  }

  @Override
  public void reset() {
    rests = false;
    fruitless.forget();
    voxel.forget();
  }

  @Override
  public void addSkips(SkipCounters dest) {
    caster.addSkips(dest);
    dest.add(SkipKind.NEIGHBOURS, voxel.knownNeighbours());
    dest.add(SkipKind.CLIMBS, climbsSkipped);
    dest.add(SkipKind.REST, restsSkipped);
  }

  @Override
  public void follow(CollisionScene solids, Vec3 devicePosition, InteractionPoint point) {
    point.legs.clear();
    steps = 0;
    if (rests && devicePosition.sameBits(restedAt)) {
      restsSkipped++;
      return; // nothing that the answer depends on has changed: same bits, same contact
    }
    begin(solids, devicePosition, point);
    if (devicePosition.sameBits(restedAt)) {
      fruitless.forget(); // the point is to rest only after a full search
    }
    do {
      descend(NOTHING_HELD);
    } while (!outOfPath && !arrived() && !hasWorkedEnough() && climb());
    point.contact = stopped || (!arrived() && isWayBlocked());
    rests = skipsRest && legs.count() == 0 && !skippedClimbs;
    restedAt.set(devicePosition);
  }

  private void begin(CollisionScene solids, Vec3 devicePosition, InteractionPoint point) {
    obstacles = solids;
    device = devicePosition;
    p = point.position;
    legs = point.legs;
    stopped = false;
    outOfPath = false;
    skippedClimbs = false;
    voxel.locate(solids, p);
  }

  /** Whether the rest of a long way is left to the next frame: only where this one came nearer. */
  private boolean hasWorkedEnough() {
    return steps > ENOUGH_STEPS && legs.count() > 0;
  }

  /**
   * Ways that the last frame tried and stairs that it looked at. What it read of the solids is not
   * in here: a {@link org.palpate.volume.BitCube} can count that.
   */
  public int steps() {
    return steps;
  }

  private boolean arrived() {
    return p.x == device.x && p.y == device.y && p.z == device.z;
  }

  private boolean isWayBlocked() {
    return !isFree(device);
  }

  /**
   * Moves nearer to the device until stuck, arrived or out of path.
   *
   * @param held axes, as bits, along which the point stays where it is
   */
  private void descend(int held) {
    boolean mayComeNearer = true;
    while (mayComeNearer
        && !outOfPath
        && !arrived()
        && !(held == NOTHING_HELD && hasWorkedEnough())) {
      mayComeNearer = slide(held);
    }
  }

  /**
   * Goes towards the device; each face that stops it takes away an axis, until a leg is free or
   * none is left. False where another slide would not come nearer.
   */
  private boolean slide(int held) {
    boolean moved = false;
    int faces = held;
    while (!outOfPath && aim(faces)) {
      steps++;
      int stops = voxel.stopsOnWayTo(target);
      if (stops != 0) {
        stopped = true;
        faces |= stops;
        if (!aim(faces)) {
          return moved;
        }
      }
      boolean cut = cutToPathLeft();
      if (!cut && !moved && voxel.contains(target)) {
        moveNearer(target, faces != NOTHING_HELD);
        return false; // in the same voxel before the same stops, and at the device along the rest
      }
      steps += (int) (Math.min(LONG_VOXELS, span(target)) / VOXELS_A_STEP);
      if (isFree(target)) {
        outOfPath |= cut;
        return moveNearer(target, faces != NOTHING_HELD) || moved;
      }
      stopped = true;
      if (hit.axis == RayHit.NO_AXIS) {
        return moved; // the point touches a solid: it stays until it is set free
      }
      moved |= approach(faces != NOTHING_HELD);
      faces |= 1 << hit.axis;
    }
    return moved;
  }

  /**
   * Sets the target: the device, but for the axes that are taken away. False where that is where
   * the point is.
   */
  private boolean aim(int faces) {
    target.set(
        (faces & 1) != 0 ? p.x : device.x,
        (faces & 2) != 0 ? p.y : device.y,
        (faces & 4) != 0 ? p.z : device.z);
    return target.x != p.x || target.y != p.y || target.z != p.z;
  }

  /** The longest component of the way from the point. */
  private double span(Vec3 to) {
    double x = Math.abs(to.x - p.x);
    double y = Math.abs(to.y - p.y);
    double z = Math.abs(to.z - p.z);
    double longer = x > y ? x : y; // by hand, since Math.max of doubles takes several times as long
    return longer > z ? longer : z;
  }

  private boolean cutToPathLeft() {
    double leftMm = maxStepMm - legs.lengthMm();
    double square = square(p, target);
    if (leftMm > 0 && square < leftMm * leftMm * SURELY_LESS) {
      return false; // mostly, and without a square root
    }
    double lengthMm = Math.sqrt(square);
    if (lengthMm <= leftMm) {
      return false;
    }
    double share = Math.max(0, leftMm / lengthMm * CUT_SHORT);
    target.set(
        p.x + share * (target.x - p.x),
        p.y + share * (target.y - p.y),
        p.z + share * (target.z - p.z));
    if (distance(p, target) > leftMm) {
      target.set(p); // so far out that doubles lie farther apart than the path that is left
    }
    return true;
  }

  /**
   * Whether the straight way from the point to {@code to} touches no solid; else {@link #hit} says
   * where it does.
   */
  private boolean isFree(Vec3 to) {
    return voxel.contains(to) || !meetsSolid(to);
  }

  private boolean meetsSolid(Vec3 to) {
    int axis = voxel.axisOfWay(to);
    if (axis >= 0 && Math.abs(to.get(axis) - p.get(axis)) <= LONGEST_ROW_VOXELS) {
      return voxel.meetsAlong(axis, to.get(axis), hit);
    }
    return obstacles.cast(caster, ray.from(p.x, p.y, p.z).to(to.x, to.y, to.z), hit);
  }

  /** Goes on the way to the target to just before the face that was hit. */
  private boolean approach(boolean alongSurface) {
    int axis = hit.axis;
    boolean up = target.get(axis) > p.get(axis);
    int cell = hit.cell(axis);
    double stop = up ? cell - STOP_SHORT_VOXELS : cell + 1 + STOP_SHORT_VOXELS;
    if (up ? stop <= p.get(axis) : stop >= p.get(axis)) {
      return false;
    }
    double share = (stop - p.get(axis)) / (target.get(axis) - p.get(axis));
    end.set(
        p.x + share * (target.x - p.x),
        p.y + share * (target.y - p.y),
        p.z + share * (target.z - p.z));
    end.set(axis, stop);
    if (voxel.axisOfWay(target) == axis
        && Math.abs(target.get(axis) - p.get(axis)) <= LONGEST_ROW_VOXELS) {
      // The row was walked, so the voxels up to the hit are free; of a cast from very far out the
      // first of several hits may be told by rounding alone.
      return moveNearer(end, alongSurface);
    }
    boolean free = isFree(end);
    hit.axis = axis;
    return free && moveNearer(end, alongSurface);
  }

  /** Takes a free leg, if it ends strictly nearer to the device. */
  private boolean moveNearer(Vec3 to, boolean alongSurface) {
    if (!(squareToDevice(to) < squareToDevice(p))) {
      return false;
    }
    move(to, alongSurface);
    return true;
  }

  private void move(Vec3 to, boolean alongSurface) {
    legs.add(p.x, p.y, p.z, to.x, to.y, to.z, distance(p, to), alongSurface);
    p.set(to);
    voxel.locate(obstacles, p);
    outOfPath |= legs.isFull();
  }

  /**
   * Climbs a stair of one voxel in the first direction in which that leads strictly nearer. Where
   * no climb did so from this voxel, none is tried until {@link FailedStepCache} sees one nearer.
   */
  private boolean climb() {
    double square = squareToDevice(p);
    int way = wayToDevice(square);
    if (fruitless.holds(voxel, way, device, square)) {
      skippedClimbs = true;
      climbsSkipped++;
      return false;
    }
    fruitless.begin(voxel, way, device);
    pathTooShort = false;
    for (int axis = 0; axis < 3; axis++) {
      double toDevice = device.get(axis) - p.get(axis);
      if ((toDevice <= 0 && climb(axis, 1)) || (toDevice >= 0 && climb(axis, -1))) {
        return true;
      }
    }
    if (!pathTooShort) {
      fruitless.remember();
    }
    return false;
  }

  /**
   * On which side of the point the device lies along each axis, two bits an axis; and whether far.
   */
  private int wayToDevice(double square) {
    return side(0) | side(1) << 2 | side(2) << 4 | (isFar(square) ? 1 << 6 : 0);
  }

  private boolean isFar(double square) {
    return square > farMm * farMm;
  }

  private int side(int axis) {
    double toDevice = device.get(axis) - p.get(axis);
    return toDevice > 0 ? 1 : toDevice < 0 ? 2 : 0;
  }

  private boolean climb(int axis, int direction) {
    double squareBefore = squareToDevice(p);
    return aimAtStair(axis, direction, squareBefore) && climbTo(axis, direction, squareBefore);
  }

  /**
   * Sets {@link #end} to the top of the stair beside the point. False where there is none, where
   * nothing up there is nearer to the device than before, or where the way up is blocked or too
   * long for this frame.
   */
  private boolean aimAtStair(int axis, int direction, double squareBefore) {
    steps++;
    if (!voxel.isStairOpen(axis, direction, device)) {
      return false;
    }
    double top = topOfStair(axis, direction);
    end.set(device);
    end.set(axis, top);
    if (squareToDevice(end) >= squareBefore) { // were the way on top free for ever
      fruitless.addBest(end);
      return false;
    }
    end.set(p);
    end.set(axis, top);
    if (legs.lengthMm() + distance(p, end) > maxStepMm) {
      pathTooShort = true;
      return false;
    }
    return voxel.isInsideBut(axis) || isFree(end);
  }

  /**
   * Climbs to {@link #end}, goes on from there with the axis held, far from the device up a few
   * stairs more, and comes back unless that led nearer.
   */
  private boolean climbTo(int axis, int direction, double squareBefore) {
    beforeClimb.set(p);
    int legsBefore = legs.count();
    double pathBeforeMm = legs.lengthMm();
    int stairs = isFar(squareBefore) ? STAIRS_IF_FAR : 1;
    do {
      move(end, true);
      descend(1 << axis);
      if (squareToDevice(p) < squareBefore) {
        return true;
      }
      fruitless.add(p);
      stairs--;
    } while (stairs > 0 && !outOfPath && aimAtStair(axis, direction, squareBefore));
    pathTooShort |= outOfPath;
    p.set(beforeClimb);
    voxel.locate(obstacles, p);
    legs.truncate(legsBefore, pathBeforeMm);
    outOfPath = false;
    return false;
  }

  /**
   * Just beyond the voxel that the point is in: on a stair as high as that voxel. In doubles, since
   * beyond 2^31 voxels the cell is the last that has a number.
   */
  private double topOfStair(int axis, int direction) {
    double cell = voxel.cell(axis);
    return direction > 0 ? cell + 1 + STOP_SHORT_VOXELS : cell - STOP_SHORT_VOXELS;
  }

  private double distance(Vec3 from, Vec3 to) {
    return Math.sqrt(square(from, to));
  }

  private double squareToDevice(Vec3 from) {
    return square(from, device);
  }

  private double square(Vec3 from, Vec3 to) {
    return metric.squaredDistance(from.x, from.y, from.z, to.x, to.y, to.z);
  }
}
