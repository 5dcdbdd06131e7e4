package org.palpate.proxy.exact;

import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.LegPath;
import org.palpate.proxy.PathLimit;
import org.palpate.proxy.ProxySolver;
import org.palpate.raycast.ExactRayCaster;
import org.palpate.raycast.Ray;
import org.palpate.raycast.RayHit;
import org.palpate.statistics.SkipCounters;
import org.palpate.statistics.SkipKind;

/**
 * The paper's path finding made exact: moves the proxy along hard voxel faces. Every leg, as the
 * segment between its two doubles, is disjoint from every closed solid voxel, and starts bit for
 * bit where the last one ended.
 *
 * <p>A frame moves straight towards the device, stops {@link #STOP_SHORT_VOXELS} before a solid,
 * and slides on along its face. If the proxy is stuck it steps up by one voxel, or by a few if the
 * device is far away, and keeps the step if it comes nearer to the device.
 *
 * <p>Invariant: a frame ends strictly nearer to the device, by {@link GridMetric#squaredDistance}
 * in doubles, or at the same bits. There are finitely many squared distances, so for a device at
 * rest the proxy comes to rest and never cycles.
 *
 * <p>References: Vlasov et al. 2013, section 4.2, for following surfaces; Zilles and Salisbury 1995
 * for faces as constraints.
 *
 * <p>Haptic thread only; allocates nothing. Cost: a few casts of about the frame's travel, bounded
 * by {@link #STEP_BUDGET}.
 */
public final class GuardedSolver implements ProxySolver {
  /**
   * The gap between the proxy and a face that stops it, in voxels. It is a power of two, so that
   * face and gap add without rounding up to coordinates of 2^32. It is far below what a hand feels
   * and far above the rounding of coordinates.
   */
  public static final double STOP_SHORT_VOXELS = 0x1p-20;

  /**
   * The work budget of a frame, in steps. A frame that has used more, and came nearer, leaves the
   * rest of a long path to the next frame. A hand that slides two voxels a frame needs a dozen
   * steps; only step-ups in a row need more, most of all if w_max is many voxels.
   */
  public static final int STEP_BUDGET = 40;

  /**
   * The distance of the device, in shortest voxel edges, from which a search tries several steps
   * up. The farther the device, the less a step along a convex surface brings. On a torus pressed
   * 10 voxels deep a single step leaves the proxy up to 15 % farther away than the paper's method
   * does. Below 8, several steps would cost a quarter of the frame's time for a gain of 1 %.
   */
  private static final double FAR_VOXELS = 8;

  /** A fourth step was measured to bring nothing. */
  private static final int MAX_STEP_UPS_IF_FAR = 3;

  /** On a longer row the ray cast, which skips empty bricks, is faster than voxel by voxel. */
  private static final double MAX_ROW_VOXELS = 16;

  /** A long slide counts as one more step for each of these. */
  private static final double VOXELS_PER_STEP = 8;

  /** The length at which a slide stops to count as longer. */
  private static final double MAX_COUNTED_VOXELS = 64;

  /** The set of fixed axes that is empty: the proxy may move along all three. */
  private static final int NONE_FIXED = 0;

  private final GridMetric metric;
  private final PathLimit pathLimit;
  private final double farMm;
  private final boolean skipsRest;
  private final ExactRayCaster caster = new ExactRayCaster();
  private final Ray ray = new Ray();
  private final RayHit hit = new RayHit();
  private final Vec3 target = new Vec3();
  private final Vec3 end = new Vec3();
  private final Vec3 beforeStep = new Vec3();
  private final Vec3 restedAt = new Vec3();
  private final ProxyVoxel voxel;
  private final FailedStepCache failedSteps;

  private CollisionScene scene;
  private Vec3 device;
  private InteractionPoint point;
  private Vec3 p;
  private LegPath legs;

  /** The squared distance of the proxy from the device, mm^2; every move of the proxy sets it. */
  private double squareMm2;

  private boolean rests;
  private long skippedSearches;
  private long skippedFrames;
  private int steps;

  /**
   * Creates a solver for one grid.
   *
   * @param metric the spacing of the grid
   * @param maxStepMm the longest path of the proxy in one frame, w_max, positive
   * @throws IllegalArgumentException if {@code maxStepMm} is not positive
   */
  public GuardedSolver(GridMetric metric, double maxStepMm) {
    this(metric, maxStepMm, SkipOptions.ALL);
  }

  private GuardedSolver(GridMetric metric, double maxStepMm, SkipOptions skips) {
    this.metric = metric;
    pathLimit = new PathLimit(metric, maxStepMm);
    farMm = FAR_VOXELS * metric.shortestEdgeMm();
    voxel = new ProxyVoxel(skips.neighbourhoods());
    failedSteps = new FailedStepCache(metric, skips.failedSteps());
    skipsRest = skips.rest();
  }

  /** Returns a solver that skips only some of its work, to measure what the rest is worth. */
  static GuardedSolver skippingOnly(SkipOptions skips, GridMetric metric, double maxStepMm) {
    return new GuardedSolver(metric, maxStepMm, skips);
  }

  @Override
  public void reset() {
    rests = false;
    failedSteps.forget();
    voxel.forget();
  }

  @Override
  public void addSkips(SkipCounters dest) {
    caster.addSkips(dest);
    dest.add(SkipKind.NEIGHBOURS, voxel.knownNeighbourhoods());
    dest.add(SkipKind.CLIMBS, skippedSearches);
    dest.add(SkipKind.REST, skippedFrames);
  }

  /**
   * Returns the work of the last frame: slides tried and steps up examined, and one more for each 8
   * voxels of a long slide. Reading the solids is not counted here; a {@link
   * org.palpate.volume.BitCube} can count that.
   */
  @Override
  public int steps() {
    return steps;
  }

  @Override
  public void follow(CollisionScene frameScene, Vec3 devicePosition, InteractionPoint framePoint) {
    framePoint.legs.clear();
    steps = 0;
    boolean deviceRests = devicePosition.sameBits(restedAt);
    if (rests && deviceRests) {
      skippedFrames++;
      return; // nothing that the answer depends on has changed: same bits, same contact
    }
    begin(frameScene, devicePosition, framePoint);
    if (deviceRests) {
      failedSteps.forget(); // the proxy may rest only after a full search
    }
    StepUpOutcome lastSearch = moveTowardsDevice();
    if (!point.contact && !hasArrived()) {
      point.contact = !isFree(device);
    }
    rests = skipsRest && legs.count() == 0 && lastSearch != StepUpOutcome.SKIPPED;
    restedAt.set(devicePosition);
  }

  private void begin(CollisionScene frameScene, Vec3 devicePosition, InteractionPoint framePoint) {
    scene = frameScene;
    device = devicePosition;
    point = framePoint;
    p = framePoint.position;
    legs = framePoint.legs;
    point.contact = false;
    squareMm2 = squareToDevice(p);
    voxel.locate(frameScene, p);
  }

  /**
   * Slides, and steps up whenever the proxy is stuck, until nothing leads nearer to the device or
   * the frame has used up its path or its work budget.
   *
   * @return the outcome of the last search for a step up; {@code NOT_NEARER} if there was none
   */
  private StepUpOutcome moveTowardsDevice() {
    StepUpOutcome lastSearch = StepUpOutcome.NOT_NEARER;
    do {
      SlideOutcome slid = slideUntilStuck(NONE_FIXED);
      if (slid == SlideOutcome.OUT_OF_PATH || hasArrived() || isBudgetSpent()) {
        return lastSearch;
      }
      lastSearch = stepUp();
    } while (lastSearch == StepUpOutcome.NEARER);
    return lastSearch;
  }

  private boolean hasArrived() {
    return p.x == device.x && p.y == device.y && p.z == device.z;
  }

  /** Whether the rest of a long path is left to the next frame: only if this one came nearer. */
  private boolean isBudgetSpent() {
    return steps > STEP_BUDGET && legs.count() > 0;
  }

  /**
   * Slides nearer to the device until the proxy is stuck, has arrived or is out of path.
   *
   * @param fixedAxes the axes, as bits, along which the proxy keeps its coordinate
   */
  private SlideOutcome slideUntilStuck(int fixedAxes) {
    SlideOutcome outcome = outcomeOfSlide(true);
    while (outcome == SlideOutcome.NEARER
        && !hasArrived()
        && !(fixedAxes == NONE_FIXED && isBudgetSpent())) {
      outcome = slide(fixedAxes);
    }
    return outcome;
  }

  private SlideOutcome outcomeOfSlide(boolean mayComeNearer) {
    if (legs.isFull()) {
      return SlideOutcome.OUT_OF_PATH;
    }
    return mayComeNearer ? SlideOutcome.NEARER : SlideOutcome.STUCK;
  }

  /**
   * Moves towards the device. Each face that stops the proxy fixes an axis more, until a leg is
   * free or no axis is left.
   */
  private SlideOutcome slide(int fixedAxes) {
    boolean moved = false;
    int fixed = fixedAxes;
    aim(fixed);
    while (!legs.isFull() && isTargetElsewhere()) {
      steps++;
      int faces = voxel.facesThatStop(target);
      if (faces != 0) {
        point.contact = true;
        fixed |= faces;
        aim(fixed);
        if (!isTargetElsewhere()) {
          return outcomeOfSlide(moved);
        }
      }
      boolean cut = pathLimit.cut(legs, p, target, target);
      if (!cut && !moved && voxel.contains(target)) {
        moveNearerInVoxel(target, fixed != NONE_FIXED);
        return outcomeOfSlide(false); // the same faces stop it, and it is at the device elsewhere
      }
      steps += (int) (Math.min(MAX_COUNTED_VOXELS, longestComponent(target)) / VOXELS_PER_STEP);
      if (isFree(target)) {
        moved |= moveNearer(target, fixed != NONE_FIXED);
        return cut ? SlideOutcome.OUT_OF_PATH : outcomeOfSlide(moved);
      }
      point.contact = true;
      int face = hit.axis;
      if (face == RayHit.NO_AXIS) {
        return outcomeOfSlide(moved); // the proxy touches a solid: it stays until it is set free
      }
      moved |= approach(face, fixed != NONE_FIXED);
      fixed |= 1 << face;
      aim(fixed);
    }
    return outcomeOfSlide(moved);
  }

  /** Sets the target to the device, except along the fixed axes. */
  private void aim(int fixedAxes) {
    target.set(
        (fixedAxes & 1) != 0 ? p.x : device.x,
        (fixedAxes & 2) != 0 ? p.y : device.y,
        (fixedAxes & 4) != 0 ? p.z : device.z);
  }

  private boolean isTargetElsewhere() {
    return target.x != p.x || target.y != p.y || target.z != p.z;
  }

  /** Returns the longest component of the segment from the proxy, voxels. */
  private double longestComponent(Vec3 to) {
    double x = Math.abs(to.x - p.x);
    double y = Math.abs(to.y - p.y);
    double z = Math.abs(to.z - p.z);
    double longer = x > y ? x : y; // Math.max of doubles would take several times as long
    return longer > z ? longer : z;
  }

  /** Whether the segment from the proxy touches no solid; if it does, {@link #hit} is set. */
  private boolean isFree(Vec3 to) {
    return voxel.contains(to) || !meetsSolid(to);
  }

  private boolean meetsSolid(Vec3 to) {
    int axis = voxel.axisOfRow(to);
    if (axis != ProxyVoxel.NO_ROW && isShortRow(to, axis)) {
      return voxel.castRow(axis, to.get(axis), hit);
    }
    return scene.cast(caster, ray.from(p.x, p.y, p.z).to(to.x, to.y, to.z), hit);
  }

  private boolean isShortRow(Vec3 to, int axis) {
    return Math.abs(to.get(axis) - p.get(axis)) <= MAX_ROW_VOXELS;
  }

  /**
   * Moves towards the target to just before the face that was hit.
   *
   * @param axis the axis of the face
   * @return whether the proxy moved
   */
  private boolean approach(int axis, boolean alongSurface) {
    double from = p.get(axis);
    double to = target.get(axis);
    boolean up = to > from;
    int cell = hit.cell(axis);
    double stop = up ? cell - STOP_SHORT_VOXELS : cell + 1 + STOP_SHORT_VOXELS;
    if (up ? stop <= from : stop >= from) {
      return false;
    }
    double fraction = (stop - from) / (to - from);
    end.set(
        p.x + fraction * (target.x - p.x),
        p.y + fraction * (target.y - p.y),
        p.z + fraction * (target.z - p.z));
    end.set(axis, stop);
    // The cast of a row has seen every voxel up to the hit. Of a ray from very far out, rounding
    // alone may decide which of several hits is the first, so that the leg must be verified.
    boolean rowWasCast = voxel.axisOfRow(target) == axis && isShortRow(target, axis);
    if (!rowWasCast && !isFree(end)) {
      return false;
    }
    return moveNearer(end, alongSurface);
  }

  /** Moves by a free leg if it ends strictly nearer to the device; returns whether it moved. */
  private boolean moveNearer(Vec3 to, boolean alongSurface) {
    if (!moveNearerInVoxel(to, alongSurface)) {
      return false;
    }
    voxel.locate(scene, p);
    return true;
  }

  /** Does the same by a leg that stays in the voxel of the proxy. */
  private boolean moveNearerInVoxel(Vec3 to, boolean alongSurface) {
    double square = squareToDevice(to);
    if (!(square < squareMm2)) {
      return false;
    }
    addLeg(to, square, alongSurface);
    return true;
  }

  private void addLeg(Vec3 to, double newSquareMm2, boolean alongSurface) {
    legs.add(p.x, p.y, p.z, to.x, to.y, to.z, distance(p, to), alongSurface);
    p.set(to);
    squareMm2 = newSquareMm2;
  }

  /**
   * Steps up in the first direction that leads strictly nearer to the device. A search that failed
   * from this voxel is repeated only if {@link FailedStepCache} sees a step that may succeed.
   */
  private StepUpOutcome stepUp() {
    boolean far = isFar(squareMm2);
    if (failedSteps.wouldFailAgain(voxel, p, device, squareMm2, far)) {
      skippedSearches++;
      return StepUpOutcome.SKIPPED;
    }
    failedSteps.begin(voxel, p, device, far);
    StepUpOutcome outcome = stepUpInAnyDirection(squareMm2);
    if (outcome == StepUpOutcome.NOT_NEARER) {
      failedSteps.remember();
    }
    return outcome;
  }

  private boolean isFar(double square) {
    return square > farMm * farMm;
  }

  /** Tries each direction that does not lead towards the device, in a fixed order. */
  private StepUpOutcome stepUpInAnyDirection(double squareBefore) {
    boolean pathTooShort = false;
    for (int axis = 0; axis < 3; axis++) {
      double toDevice = device.get(axis) - p.get(axis);
      for (int direction = 1; direction >= -1; direction -= 2) {
        if (direction * toDevice <= 0) {
          StepUpOutcome outcome = stepUp(axis, direction, squareBefore);
          if (outcome.isNearer()) {
            return outcome;
          }
          pathTooShort |= outcome == StepUpOutcome.PATH_TOO_SHORT;
        }
      }
    }
    return pathTooShort ? StepUpOutcome.PATH_TOO_SHORT : StepUpOutcome.NOT_NEARER;
  }

  /**
   * Steps up in one direction and slides on from there with that axis fixed. If the device is far
   * away, tries a few steps more. Takes everything back unless it led nearer to the device.
   */
  private StepUpOutcome stepUp(int axis, int direction, double squareBefore) {
    beforeStep.set(p);
    int legsBefore = legs.count();
    double pathBeforeMm = legs.lengthMm();
    int maxSteps = isFar(squareBefore) ? MAX_STEP_UPS_IF_FAR : 1;
    boolean outOfPath = false;
    StepTop top = StepTop.NONE;
    for (int step = 0; step < maxSteps && !outOfPath; step++) {
      top = findTop(axis, direction, squareBefore);
      if (top != StepTop.REACHABLE) {
        break;
      }
      addLeg(end, squareToDevice(end), true);
      voxel.locate(scene, p);
      outOfPath = slideUntilStuck(1 << axis) == SlideOutcome.OUT_OF_PATH;
      if (squareMm2 < squareBefore) {
        return outOfPath ? StepUpOutcome.NEARER_OUT_OF_PATH : StepUpOutcome.NEARER;
      }
      failedSteps.addEnd(p);
    }
    if (legs.count() > legsBefore) {
      takeBack(legsBefore, pathBeforeMm, squareBefore);
    }
    return outOfPath || top == StepTop.TOO_FAR
        ? StepUpOutcome.PATH_TOO_SHORT
        : StepUpOutcome.NOT_NEARER;
  }

  private void takeBack(int legsBefore, double pathBeforeMm, double squareBefore) {
    p.set(beforeStep);
    squareMm2 = squareBefore;
    voxel.locate(scene, p);
    legs.truncate(legsBefore, pathBeforeMm);
  }

  /** Examines the step beside the proxy and, if it can be taken, sets {@link #end} to its top. */
  private StepTop findTop(int axis, int direction, double squareBefore) {
    steps++;
    if (!voxel.isStepOpen(axis, direction, device)) {
      return StepTop.NONE;
    }
    double top = topOfStep(axis, direction);
    end.set(device);
    end.set(axis, top);
    if (squareToDevice(end) >= squareBefore) { // not even a free path on top would lead nearer
      failedSteps.addBestEnd(end);
      return StepTop.NONE;
    }
    end.set(p);
    end.set(axis, top);
    if (pathLimit.isExceededBy(legs, distance(p, end))) {
      return StepTop.TOO_FAR;
    }
    boolean free = voxel.isOffPlanesExcept(axis) || isFree(end);
    return free ? StepTop.REACHABLE : StepTop.NONE;
  }

  /**
   * Returns the coordinate just beyond the voxel of the proxy, on a step as high as that voxel. In
   * doubles, because beyond 2^31 voxels the cell is the last that has a number.
   */
  private double topOfStep(int axis, int direction) {
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
