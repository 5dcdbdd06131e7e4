package org.palpate.frame;

import org.palpate.collision.CollisionScene;
import org.palpate.collision.NearestFreeVoxel;
import org.palpate.device.DeviceState;
import org.palpate.device.HapticDevice;
import org.palpate.device.ReadStatus;
import org.palpate.edit.EditQueue;
import org.palpate.force.ContactForce;
import org.palpate.force.ForceLimiter;
import org.palpate.force.ForceRamp;
import org.palpate.force.ForceSettings;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.ProxySolver;
import org.palpate.proxy.TouchedObjectFinder;

/**
 * One haptic frame, a plain method without a thread or a clock of its own: read the device, let
 * edits happen, follow with the interaction point, compute and limit the force, write it, publish.
 *
 * <pre>
 *   HapticFrame frame =
 *       new HapticFrame(deviceInGrid, solver, obstacles, metric,
 *           FrameSettings.live(device.specification(), ForceSettings.of(0.5, 0.2)),
 *           new EditQueue(grid, 1), touchProperties::publish);
 *   while (frame.run(System.nanoTime()) == FrameOutcome.RUNNING) { ... }
 *   frame.release();
 * </pre>
 *
 * <p>The device delivers grid coordinates and takes newtons along the grid's axes: {@code host}
 * wraps the real one. Belongs to the haptic thread; {@link #requestForce} and {@link
 * #requestSolver} are for any thread. Allocates nothing.
 */
public final class HapticFrame {
  private static final Vec3 NO_FORCE = new Vec3();

  private final HapticDevice device;
  private final CollisionScene obstacles;
  private final FrameSettings settings;
  private final EditQueue edits;
  private final FramePublisher publisher;
  private final NearestFreeVoxel freePlace;
  private final ContactForce contactForce;
  private final ForceLimiter limiter;
  private final ForceRamp ramp;
  private final Watchdog watchdog;
  private final FrameCounters tally = new FrameCounters();
  private final TouchedObjectFinder touched = new TouchedObjectFinder();

  private final DeviceState sample = new DeviceState();
  private final Vec3 deviceGrid = new Vec3();
  private final InteractionPoint point = new InteractionPoint();
  private final Vec3 forceNewton = new Vec3();
  private ProxySolver solver;
  private boolean placed;
  private boolean freed;
  private boolean followed;
  private boolean begun;
  private long lastNanos;
  private long sinceForceNanos;
  private long unreachableNanos;

  private volatile ForceSettings requestedForce;
  private volatile ProxySolver requestedSolver;

  /**
   * A frame that has not run yet.
   *
   * @param device read and written once a frame, never closed
   * @param metric the spacing of the obstacles' grid
   * @param edits changes of the obstacles, carried out before the point moves
   */
  public HapticFrame(
      HapticDevice device,
      ProxySolver solver,
      CollisionScene obstacles,
      GridMetric metric,
      FrameSettings settings,
      EditQueue edits,
      FramePublisher publisher) {
    this.device = device;
    this.solver = solver;
    this.obstacles = obstacles;
    this.settings = settings;
    this.edits = edits;
    this.publisher = publisher;
    freePlace = new NearestFreeVoxel(metric);
    contactForce = new ContactForce(metric, settings.force());
    limiter = new ForceLimiter(settings.maxForceNewton(), settings.slewNewtonPerMs());
    ramp = new ForceRamp(settings.rampNanos());
    watchdog = new Watchdog(settings.silenceNanos());
    requestedForce = settings.force();
    requestedSolver = solver;
  }

  /**
   * Runs one frame.
   *
   * @param nowNanos when it begins, on the caller's clock; it may jump
   */
  public FrameOutcome run(long nowNanos) {
    long elapsedNanos = begun ? nowNanos - lastNanos : 0;
    begun = true;
    lastNanos = nowNanos;
    ReadStatus status = device.read(sample);
    if (status == ReadStatus.DISCONNECTED) {
      release();
      return FrameOutcome.DEVICE_GONE;
    }
    ramp.advance(elapsedNanos);
    sinceForceNanos += Math.max(0, elapsedNanos);
    freed = false;
    takeRequests();
    editSolids();
    respond(watchdog.judge(status, sample, nowNanos), elapsedNanos);
    boolean reached = device.write(forceNewton);
    tally.count(point, forceNewton, freed);
    publisher.publish(deviceGrid, point.position, forceNewton, point.contact, tally.lastFrame());
    return reached(reached, elapsedNanos);
  }

  private void takeRequests() {
    contactForce.change(requestedForce);
    ProxySolver wanted = requestedSolver;
    if (wanted != solver) {
      tally.changeSolver(solver, wanted);
      solver = wanted;
      solver.reset();
      point.surfaceHeightMm = 0;
      point.limitsForceRate = false;
      if (placed && isBuried()) {
        setFree(point.position); // a baseline may have left it in a solid, where no other starts
      }
    }
  }

  private void editSolids() {
    if (edits.applyTo(obstacles, settings.editVoxelsAFrame()) && placed) {
      solver.reset();
      if (isBuried()) {
        setFree(point.position);
      }
    }
  }

  private void respond(Watchdog.Verdict verdict, long elapsedNanos) {
    followed = verdict == Watchdog.Verdict.FRESH || verdict == Watchdog.Verdict.RESUMED;
    if (verdict == Watchdog.Verdict.RESUMED) {
      ramp.start();
      limiter.reset();
    }
    if (followed) {
      touch(elapsedNanos);
    } else {
      point.legs.clear();
      if (verdict == Watchdog.Verdict.SILENT) {
        dropForce();
      }
    }
  }

  private void touch(long elapsedNanos) {
    deviceGrid.set(sample.positionMm);
    if (!placed) {
      place();
    }
    solver.follow(obstacles, deviceGrid, point);
    if (contactForce.settings().distinguishesObjects()) {
      touched.find(obstacles, deviceGrid, point);
    }
    contactForce.compute(point, deviceGrid, sinceForceNanos, forceNewton);
    sinceForceNanos = 0;
    forceNewton.mul(ramp.factor(), forceNewton);
    limiter.clamp(forceNewton, elapsedNanos);
  }

  /** Starts the point at the device, or as near as a solid allows. */
  private void place() {
    placed = true;
    point.position.set(deviceGrid);
    solver.reset();
    if (isBuried()) {
      setFree(deviceGrid);
    }
  }

  private boolean isBuried() {
    return obstacles.touches(point.position.x, point.position.y, point.position.z);
  }

  private void setFree(Vec3 from) {
    freePlace.find(obstacles, from, point.position);
    solver.reset();
    freed = true;
    ramp.start();
    dropForce();
  }

  private void dropForce() {
    forceNewton.set(0, 0, 0);
    limiter.reset();
  }

  private FrameOutcome reached(boolean reached, long elapsedNanos) {
    if (reached) {
      unreachableNanos = 0;
      return FrameOutcome.RUNNING;
    }
    tally.countUnreached();
    unreachableNanos += Math.max(0, elapsedNanos);
    return unreachableNanos > settings.silenceNanos()
        ? FrameOutcome.DEVICE_GONE
        : FrameOutcome.RUNNING;
  }

  /**
   * Sends zero force at once, past the slew limit. Haptic thread, after the last frame.
   *
   * @return false where the device could not be reached
   */
  public boolean release() {
    dropForce();
    return device.write(NO_FORCE);
  }

  /** Changes what the surface feels like from the next frame on. Any thread. */
  public void requestForce(ForceSettings wanted) {
    requestedForce = wanted;
  }

  /** Changes the solver from the next frame on; it is given away. Any thread. */
  public void requestSolver(ProxySolver wanted) {
    requestedSolver = wanted;
  }

  /** The interaction point with the legs of the last frame. The frame's own. */
  public InteractionPoint point() {
    return point;
  }

  /** What the device gave last, unchecked. The frame's own. */
  public DeviceState sample() {
    return sample;
  }

  /** The force that was written last, N. The frame's own. */
  public Vec3 forceNewton() {
    return forceNewton;
  }

  /** Whether the last frame set the point free, so that a new chain of legs begins. */
  public boolean wasFreed() {
    return freed;
  }

  /** Whether the last frame had a new sample and moved the point after it. */
  public boolean followed() {
    return followed;
  }

  /** The device that it reads and writes. */
  public HapticDevice device() {
    return device;
  }

  /** The counts so far; allocates. Haptic thread, or anyone after the last frame. */
  public FrameStatistics counts() {
    return tally.counts(watchdog, solver, obstacles, contactForce, limiter);
  }

  /** What any thread may look at while frames run. */
  public FrameCounters tally() {
    return tally;
  }
}
