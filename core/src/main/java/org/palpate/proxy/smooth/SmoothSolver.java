package org.palpate.proxy.smooth;

import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.ProxySolver;
import org.palpate.proxy.exact.GuardedSolver;
import org.palpate.proxy.smooth.field.GreyIsosurface;
import org.palpate.proxy.smooth.field.GreyIsosurfaceSource;
import org.palpate.proxy.smooth.field.OccupancyField;
import org.palpate.proxy.smooth.field.SeedCell;
import org.palpate.statistics.SkipCounters;

/**
 * Slides the interaction point along an isosurface of the occupancy field, so that forces feel like
 * the surface and not like voxels. The field is evaluated on the fly; nothing is precalculated.
 *
 * <p>A frame moves straight to a visible device. Otherwise it slides along the isosurface towards
 * the point closest to the device. If that gains nothing, as in slits that the field does not
 * resolve, the frame follows the voxel faces.
 *
 * <p>Guarantee: {@link VerifiedMotion} and {@link GuardedSolver} verify every leg exactly before
 * the point moves, whatever the field says. Rest: see {@link RestRule}.
 *
 * <p>References: Zilles and Salisbury 1995, Salisbury and Tarr 1997, Chan et al. 2011. Haptic
 * thread only; a frame allocates nothing.
 */
public final class SmoothSolver implements ProxySolver {
  /**
   * The longest edge of a voxel, in shortest edges, over which forces are measured. Beyond it they
   * are less and less exact, and the isosurface may not clear the voxels.
   */
  public static final double MAX_EDGE_RATIO = 10;

  /**
   * The windows of voxels that a frame reads at most, whatever the scene and the device do. They
   * bound the work of a frame.
   */
  public static final int MOST_WINDOWS = WindowBudget.MOST_WINDOWS;

  /**
   * The gain beyond the rule that a change from the isosurface to the voxel faces needs, so that
   * frames do not alternate between them.
   */
  private static final double CHANGE_TO_VOXELS_EDGES = 0.3;

  private final double shortestMm;
  private final OccupancyField field;
  private final WindowBudget budget;
  private final VerifiedMotion motion;
  private final StraightPath straightPath;
  private final SurfaceSlide surfaceSlide;
  private final GuardedSolver voxelSolver;
  private final RestRule restRule;
  private final SurfaceHeight surfaceHeight;
  private final ReadAhead readAhead;

  private final SeedCell seed = new SeedCell();

  /** The device position at which the last frame left the point where it was. */
  private final Vec3 settledDevice = new Vec3(Double.NaN, 0, 0);

  /** Whether the last frame in contact that moved the point slid along the isosurface. */
  private boolean lastOnSurface;

  private long evaluationsBefore;
  private long columnsBefore;
  private long windowsBefore;
  private int voxelSteps;
  private CollisionScene scene;
  private Vec3 device;
  private InteractionPoint point;

  /**
   * Creates a solver that knows the bits alone.
   *
   * @param metric the spacing of the grid
   * @param maxStepMm the longest path of the point in one frame, w_max, positive
   */
  public SmoothSolver(GridMetric metric, double maxStepMm) {
    this(metric, maxStepMm, OccupancyField.ofBitsOverTerraces(metric));
  }

  /**
   * Creates a solver that knows the grey values from which the solids were made by a threshold.
   * Where bits were edited since, the bits count.
   *
   * @param metric the spacing of the grid
   * @param maxStepMm the longest path of the point in one frame, w_max, positive
   * @param grey the values on the grid of the scene, and their threshold
   */
  public SmoothSolver(GridMetric metric, double maxStepMm, GreyIsosurface grey) {
    this(metric, maxStepMm, new GreyIsosurfaceSource(grey));
  }

  /**
   * Creates the same for grey values that may change; call {@link #reset} after each change.
   *
   * @param metric the spacing of the grid
   * @param maxStepMm the longest path of the point in one frame, w_max, positive
   * @param grey holds the present values on the grid of the scene
   */
  public SmoothSolver(GridMetric metric, double maxStepMm, GreyIsosurfaceSource grey) {
    this(metric, maxStepMm, OccupancyField.ofGrey(metric, grey));
  }

  private SmoothSolver(GridMetric metric, double maxStepMm, OccupancyField given) {
    if (!(maxStepMm > 0)) {
      throw new IllegalArgumentException("maxStepMm must be positive: maxStepMm=" + maxStepMm);
    }
    // Far from the solid, each frame evaluates the field at two distances in turn.
    field = given.level().isFar() ? given.forManyPlaces() : given;
    EdgeUnits units = new EdgeUnits(metric);
    shortestMm = units.shortestMm();
    budget = new WindowBudget(field);
    motion = new VerifiedMotion(metric, maxStepMm);
    straightPath = new StraightPath(field, motion);
    surfaceSlide = new SurfaceSlide(field, units, budget, motion, straightPath);
    voxelSolver = new GuardedSolver(metric, maxStepMm);
    restRule = new RestRule(new Potential(field, units), units);
    surfaceHeight = new SurfaceHeight(field, units);
    readAhead = new ReadAhead(field, units);
  }

  @Override
  public void addSkips(SkipCounters dest) {
    voxelSolver.addSkips(dest);
    motion.addSkips(dest);
  }

  @Override
  public void reset() {
    field.forget();
    resetAllButField();
  }

  @Override
  public void resetAfterEdit(IntBox changed) {
    field.forget(changed);
    resetAllButField();
  }

  private void resetAllButField() {
    voxelSolver.reset();
    restRule.reset();
    settledDevice.x = Double.NaN;
  }

  /**
   * Returns the work of the last frame: evaluations of the field, columns that it interpolated,
   * segments that were cast, and steps of the voxel solver. Not included are words of voxels that
   * were read; a {@link org.palpate.volume.BitCube} can count them.
   */
  @Override
  public int steps() {
    long evaluations = field.sample().evaluation() - evaluationsBefore;
    long columns = field.interpolatedColumns() - columnsBefore;
    return (int) (evaluations + columns) + motion.casts() + voxelSteps;
  }

  /** {@return the windows of voxels that the last frame read, at most {@link #MOST_WINDOWS}} */
  public int windows() {
    return (int) (field.windowReads() - windowsBefore);
  }

  @Override
  public void follow(CollisionScene newScene, Vec3 devicePosition, InteractionPoint newPoint) {
    beginFrame(newScene, devicePosition, newPoint);
    if (isSettled(newScene)) {
      return;
    }
    useScene(newScene);
    double distanceMm = motion.distanceMm(point.position, device);
    if (!motion.reaches(distanceMm)) {
      restRule.beginFarFrame(device);
    }
    if (canMoveFreely(distanceMm)) {
      motion.commit(false);
      restRule.noteFreeMotion(distanceMm / shortestMm);
    } else {
      followSurface(distanceMm / shortestMm);
    }
    endFrame();
  }

  private void beginFrame(CollisionScene newScene, Vec3 devicePosition, InteractionPoint newPoint) {
    device = devicePosition;
    point = newPoint;
    newPoint.limitsForceRate = true;
    motion.beginFrame(newScene, newPoint);
    evaluationsBefore = field.sample().evaluation();
    columnsBefore = field.interpolatedColumns();
    windowsBefore = field.windowReads();
    voxelSteps = 0;
  }

  /** Whether nothing has changed that the answer depends on: then position and contact stay. */
  private boolean isSettled(CollisionScene newScene) {
    return device.sameBits(settledDevice) && newScene == scene;
  }

  private void useScene(CollisionScene newScene) {
    scene = newScene;
    field.use(newScene);
    budget.beginFrame();
    straightPath.beginFrame(device);
    restRule.beginFrame(straightPath.isDeviceInSolid());
  }

  /** Proposes and verifies a leg straight towards the device, if the rest rule allows one. */
  private boolean canMoveFreely(double distanceMm) {
    if (motion.reaches(distanceMm)) {
      return straightPath.verifyToDevice(device);
    }
    boolean open = field.evaluate(seed.set(point.position), point.position).isOpen();
    return open && restRule.allowsFreeMotion(distanceMm / shortestMm) && motion.verify(device);
  }

  /** Slides along the isosurface, or follows the voxels where that gains nothing. */
  private void followSurface(double distanceEdges) {
    double limit = restRule.potentialLimit(point.position, device, distanceEdges);
    surfaceSlide.slide(device, restRule, limit);
    if (counts(limit)) {
      point.surfaceHeightMm = surfaceHeight.onSurfaceMm(point.legs.lengthMm());
      lastOnSurface = true;
    } else {
      motion.takeBack();
      followVoxels(lastOnSurface ? limit - CHANGE_TO_VOXELS_EDGES : limit);
    }
  }

  private void followVoxels(double limit) {
    voxelSolver.reset();
    voxelSolver.follow(scene, device, point);
    voxelSteps = voxelSolver.steps();
    if (counts(limit)) {
      point.surfaceHeightMm = surfaceHeight.onVoxelsMm(point.legs.lengthMm());
      lastOnSurface = false;
    } else {
      motion.takeBack();
    }
  }

  /** Whether the point has moved in this frame, and the rest rule accepts it. */
  private boolean counts(double limit) {
    return motion.hasMoved() && restRule.accepts(point.position, device, limit);
  }

  private void endFrame() {
    point.contact = !point.position.sameBits(device) && straightPath.isBlocked(device);
    settledDevice.set(device);
    if (motion.hasMoved()) {
      settledDevice.x = Double.NaN;
    }
    restRule.endFrame(device);
    if (field.interpolatedColumns() == columnsBefore) {
      readAhead.read(point.position);
    }
  }
}
