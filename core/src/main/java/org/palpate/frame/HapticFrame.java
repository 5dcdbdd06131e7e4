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
 * Runs one haptic frame, from the device's sample to the force on the hand.
 *
 * <pre>
 *   HapticFrame frame =
 *       new HapticFrame(deviceInGrid, solver, scene, metric,
 *           FrameSettings.live(device.specification(), ForceSettings.of(0.5, 0.2)),
 *           new EditQueue(grid, 1), touchProperties::publish);
 *   while (frame.run(System.nanoTime()) == FrameOutcome.RUNNING) { ... }
 *   frame.release();
 * </pre>
 *
 * <p>A frame is a plain method without a thread or a clock of its own. The device delivers grid
 * coordinates and takes newtons along the grid's axes; {@code host} wraps a real one accordingly.
 *
 * <p>Belongs to the haptic thread, except for the methods that state any thread. A frame allocates
 * nothing and takes no lock.
 */
public final class HapticFrame {
  private static final Vec3 NO_FORCE = new Vec3();

  private final HapticDevice device;
  private final CollisionScene scene;
  private final FrameSettings settings;
  private final EditQueue edits;
  private final FramePublisher publisher;
  private final NearestFreeVoxel nearestFreeVoxel;
  private final TouchedObjectFinder touchedObject = new TouchedObjectFinder();
  private final ContactForce contactForce;
  private final ForceLimiter limiter;
  private final ForceRamp ramp;
  private final Watchdog watchdog;
  private final FrameCounters counters = new FrameCounters();

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
  private long elapsedNanos;
  private long sinceForceNanos;
  private long unreachableNanos;

  private volatile ForceSettings requestedForce;
  private volatile ProxySolver requestedSolver;

  /**
   * Makes a frame that has not run yet.
   *
   * @param device read and written once a frame, never closed
   * @param solver moves the interaction point; belongs to the frame from now on
   * @param scene the solids
   * @param metric the spacing of the scene's grid
   * @param edits changes of the scene, applied before the point moves
   * @param publisher receives each frame's result
   */
  public HapticFrame(
      HapticDevice device,
      ProxySolver solver,
      CollisionScene scene,
      GridMetric metric,
      FrameSettings settings,
      EditQueue edits,
      FramePublisher publisher) {
    this.device = device;
    this.solver = solver;
    this.scene = scene;
    this.settings = settings;
    this.edits = edits;
    this.publisher = publisher;
    nearestFreeVoxel = new NearestFreeVoxel(metric);
    contactForce = new ContactForce(metric, settings.force());
    limiter = new ForceLimiter(settings.maxForceNewton(), settings.slewNewtonPerMs());
    ramp = new ForceRamp(settings.rampNanos());
    watchdog = new Watchdog(settings.silenceNanos());
    requestedForce = settings.force();
    requestedSolver = solver;
  }

  /**
   * Runs one frame: reads the device, applies requests and edits, follows the device with the
   * interaction point, computes and limits the force, writes it and publishes the result.
   *
   * <p>The watchdog decides whether the point follows, or the last force is held or dropped. There
   * is no step of its own for the collision candidates: the {@link CollisionScene} updates them
   * within {@code follow}, when a query leaves the region that its last search covered. A search at
   * the beginning of each frame would cost more, because most frames need none.
   *
   * @param nowNanos the beginning of the frame on the caller's clock, which may jump
   * @return whether the session goes on
   */
  public FrameOutcome run(long nowNanos) {
    advanceClock(nowNanos);
    sample.relocated = false; // Most devices never set it.
    ReadStatus status = device.read(sample);
    if (status == ReadStatus.DISCONNECTED) {
      release();
      return FrameOutcome.DEVICE_GONE;
    }
    beginFrame();
    applyRequests();
    applyEdits();
    applyVerdict(watchdog.judge(status, sample, nowNanos));
    if (followed) {
      follow();
      computeForce();
      limitForce();
    }
    writeForce();
    publish();
    return outcome();
  }

  private void advanceClock(long nowNanos) {
    elapsedNanos = begun ? nowNanos - lastNanos : 0;
    begun = true;
    lastNanos = nowNanos;
  }

  private void beginFrame() {
    ramp.advance(elapsedNanos);
    sinceForceNanos += Math.max(0, elapsedNanos);
    freed = false;
  }

  private void applyRequests() {
    contactForce.change(requestedForce);
    ProxySolver requested = requestedSolver;
    if (requested != solver) {
      changeSolver(requested);
    }
  }

  private void changeSolver(ProxySolver next) {
    counters.changeSolver(solver, next);
    solver = next;
    solver.reset();
    point.surfaceHeightMm = 0;
    point.limitsForceRate = false;
    freePointFromSolid(); // A baseline may have left it in a solid, where no other solver starts.
  }

  private void applyEdits() {
    boolean changed = edits.applyTo(scene, settings.editVoxelsAFrame());
    if (changed && placed) {
      solver.reset();
      freePointFromSolid();
    }
  }

  private void freePointFromSolid() {
    if (placed && touchesSolid()) {
      setFree(point.position);
    }
  }

  /**
   * Decides between following a new sample, holding the last force and dropping it. After a silence
   * the force starts from zero.
   */
  private void applyVerdict(Watchdog.Verdict verdict) {
    followed = verdict == Watchdog.Verdict.FRESH || verdict == Watchdog.Verdict.RESUMED;
    if (!followed) {
      point.legs.clear();
    }
    if (verdict == Watchdog.Verdict.SILENT) {
      dropForce();
    } else if (verdict == Watchdog.Verdict.RESUMED) {
      ramp.start();
      limiter.reset();
    }
  }

  private void follow() {
    deviceGrid.set(sample.positionMm);
    if (!placed) {
      placePoint();
    } else if (sample.relocated) {
      relocatePoint();
    }
    solver.follow(scene, deviceGrid, point);
    if (contactForce.settings().distinguishesObjects()) {
      touchedObject.find(scene, deviceGrid, point);
    }
  }

  /** Starts the point at the device, or as near to it as the solids permit. */
  private void placePoint() {
    placed = true;
    point.position.set(deviceGrid);
    solver.reset();
    if (touchesSolid()) {
      setFree(deviceGrid);
    }
  }

  /** Sets the point free at a device that jumped, or as near to it as the solids permit. */
  private void relocatePoint() {
    point.position.set(deviceGrid);
    if (touchesSolid()) {
      setFree(deviceGrid);
    } else {
      beginAnew();
    }
  }

  private boolean touchesSolid() {
    return scene.touches(point.position.x, point.position.y, point.position.z);
  }

  private void setFree(Vec3 from) {
    nearestFreeVoxel.find(scene, from, point.position);
    beginAnew();
  }

  /** Begins a new chain of legs at the present position, with a force that rises from zero. */
  private void beginAnew() {
    solver.reset();
    freed = true;
    ramp.start();
    dropForce();
  }

  private void computeForce() {
    contactForce.compute(point, deviceGrid, sinceForceNanos, forceNewton);
    sinceForceNanos = 0;
    forceNewton.mul(ramp.factor(), forceNewton);
  }

  private void limitForce() {
    limiter.clamp(forceNewton, elapsedNanos);
  }

  private void dropForce() {
    forceNewton.set(0, 0, 0);
    limiter.reset();
  }

  private void writeForce() {
    boolean reached = device.write(forceNewton);
    if (reached) {
      unreachableNanos = 0;
    } else {
      unreachableNanos += Math.max(0, elapsedNanos);
      counters.countUnreached();
    }
  }

  private void publish() {
    counters.countFrame(point, forceNewton, freed);
    publisher.publish(deviceGrid, point.position, forceNewton, point.contact, counters.lastFrame());
  }

  private FrameOutcome outcome() {
    return unreachableNanos > settings.silenceNanos()
        ? FrameOutcome.DEVICE_GONE
        : FrameOutcome.RUNNING;
  }

  /**
   * Sends zero force at once, without the slew limit. Haptic thread, after the last frame.
   *
   * @return false if the device could not be reached
   */
  public boolean release() {
    dropForce();
    return device.write(NO_FORCE);
  }

  /** Changes materials and friction from the next frame on. Any thread. */
  public void requestForce(ForceSettings requested) {
    requestedForce = requested;
  }

  /**
   * Changes the solver from the next frame on. The solver then belongs to the frame. Any thread.
   */
  public void requestSolver(ProxySolver requested) {
    requestedSolver = requested;
  }

  /** Returns the interaction point with the legs of the last frame. It belongs to the frame. */
  public InteractionPoint point() {
    return point;
  }

  /** Returns the device's last sample, unchecked. It belongs to the frame. */
  public DeviceState sample() {
    return sample;
  }

  /** Returns the last written force, N. It belongs to the frame. */
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

  /** Returns the device that the frame reads and writes. Any thread. */
  public HapticDevice device() {
    return device;
  }

  /** Returns the number of frames so far. Any thread. */
  public long frameCount() {
    return counters.frames();
  }

  /** Whether the last frame ended in contact. Any thread. */
  public boolean inContact() {
    return counters.contact();
  }

  /** Returns the length of the last force, N. Any thread. */
  public double forceLengthNewton() {
    return counters.forceNewton();
  }

  /**
   * Returns the statistics so far. Allocates. Haptic thread, or any thread after the last frame.
   */
  public FrameStatistics statistics() {
    return counters.statistics(watchdog, solver, scene, contactForce, limiter);
  }
}
