package org.palpate.frame;

import java.util.List;
import java.util.Map;
import org.palpate.carve.CarveSettings;
import org.palpate.device.DeviceState;
import org.palpate.device.HapticDevice;
import org.palpate.device.ReadStatus;
import org.palpate.edit.VoxelWriter;
import org.palpate.force.ForceLimiter;
import org.palpate.force.ForceRamp;
import org.palpate.force.HandState;
import org.palpate.force.HapticEffect;
import org.palpate.force.HapticEffects;
import org.palpate.force.guide.NearestApproach;
import org.palpate.geometry.Vec3;

/**
 * Runs one haptic frame, from the device's sample to force and torque on the hand. A {@link
 * PointFrame} moves an interaction point, a {@link ToolFrame} a rigid tool. Everything around the
 * tool is here, once: reading, the watchdog, ramp and limits, writing, counting.
 *
 * <pre>
 *   HapticFrame frame =
 *       new PointFrame(GridDevice.fromWorld(device, grid), solver, scene, metric,
 *           FrameSettings.live(device.specification(), ForceSettings.of(0.5, 0.2)),
 *           new EditQueue(grid, 1), touchProperties::publish);
 *   while (frame.run(System.nanoTime()) == FrameOutcome.RUNNING) { ... }
 *   frame.release();
 * </pre>
 *
 * <p>A frame is a plain method without a thread or a clock of its own.
 *
 * <p>Belongs to the haptic thread, except for the methods that state any thread. A frame allocates
 * nothing and takes no lock.
 */
public abstract sealed class HapticFrame permits PointFrame, ToolFrame {
  private static final Vec3 ZERO = new Vec3();

  /** The device's last sample, unchecked. */
  final DeviceState sample = new DeviceState();

  /** The last written force on the hand, N. */
  final Vec3 forceNewton = new Vec3();

  /** The last written torque on the hand about the tool's reference point, N mm. */
  final Vec3 torqueNewtonMm = new Vec3();

  final FrameCounters counters = new FrameCounters();

  private final HapticDevice device;
  private final long reportIntervalNanos;
  private final FrameSettings settings;
  private final ForceLimiter forceLimiter;
  private final ForceLimiter torqueLimiter;
  private final boolean givesTorque;
  private final ForceRamp ramp;
  private final HapticEffects effects = new HapticEffects();
  private final HandState hand = new HandState();
  private final Vec3 contactForce = new Vec3();
  private final Vec3 contactTorque = new Vec3();
  private final Watchdog watchdog;
  private boolean freed;
  private boolean followed;

  /** The number of new samples that the device has delivered. */
  private long samples;

  private boolean isSampleNew;

  private boolean begun;
  private long lastNanos;
  private long elapsedNanos;
  private long sinceForceNanos;
  private long unreachableNanos;
  private NearestApproach[] approaches = {};

  /** Receives what frames did; null if nobody asks. */
  private FrameObserver observer;

  private final FrameRecord record = new FrameRecord();
  private volatile List<HapticEffect> requestedEffects = List.of();

  /**
   * Makes a frame that has not run yet.
   *
   * @param device read and written once a frame, never closed
   */
  HapticFrame(HapticDevice device, FrameSettings settings) {
    this.device = device;
    reportIntervalNanos = device.specification().reportIntervalNanos();
    this.settings = settings;
    forceLimiter = new ForceLimiter(settings.maxForceNewton(), settings.slewNewtonPerMs());
    torqueLimiter = new ForceLimiter(settings.maxTorqueNewtonMm(), settings.slewNewtonMmPerMs());
    givesTorque = settings.maxTorqueNewtonMm() > 0;
    ramp = new ForceRamp(settings.rampNanos());
    watchdog = new Watchdog(settings.silenceNanos());
  }

  /**
   * Runs one frame: reads the device, applies requests and edits, follows the device with the tool,
   * computes and limits force and torque, writes them and publishes the result.
   *
   * <p>The watchdog decides whether the tool follows, or the last force is held or dropped. There
   * is no step of its own for the collision candidates: a solver updates them within {@code
   * follow}, when a query leaves the region that the last search covered. A search at the beginning
   * of each frame would cost more, because most frames need none.
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
    isSampleNew = status == ReadStatus.FRESH;
    samples += isSampleNew ? 1 : 0;
    beginFrame();
    applyEffects();
    applyRequests();
    applyEdits(settings.editVoxelsAFrame());
    applyVerdict(watchdog.judge(status, sample, nowNanos));
    if (followed) {
      follow();
      computeForce();
    }
    writeForce();
    countFrame();
    publish(counters.lastFrame());
    noteApproaches();
    showObserver();
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

  private void applyEffects() {
    List<HapticEffect> wanted = requestedEffects;
    if (!wanted.isEmpty() && !effects.areActive()) {
      hand.forget(); // It moved unwatched while there were no effects.
    }
    effects.use(wanted);
  }

  /** Applies what other threads requested. */
  abstract void applyRequests();

  /** Applies waiting edits, and sets the tool free if a solid came to it. */
  abstract void applyEdits(int maxVoxels);

  /**
   * Decides between following a new sample, holding the last force and dropping it. After a silence
   * the force starts from zero.
   */
  private void applyVerdict(Watchdog.Verdict verdict) {
    followed = verdict == Watchdog.Verdict.FRESH || verdict == Watchdog.Verdict.RESUMED;
    if (!followed) {
      rest();
    }
    if (verdict == Watchdog.Verdict.SILENT) {
      dropForce();
    } else if (verdict == Watchdog.Verdict.RESUMED) {
      ramp.start();
      resetLimiters();
    }
  }

  /** Leaves the tool where it is in a frame without a new sample. */
  abstract void rest();

  /** Moves the tool after the new sample. */
  abstract void follow();

  /** Drops the force and lets it return from zero, because the tool was set free. */
  final void setFree() {
    freed = true;
    ramp.start();
    dropForce();
    beginEffectsAnew();
  }

  private void computeForce() {
    computeForce(sinceForceNanos);
    forceNewton.mul(ramp.factor(), forceNewton);
    torqueNewtonMm.mul(ramp.factor(), torqueNewtonMm);
    limitForce(Math.min(sinceForceNanos, Math.max(elapsedNanos, reportIntervalNanos)));
    sinceForceNanos = 0;
  }

  /**
   * Writes force and torque without the limits of the device.
   *
   * @param sinceLastNanos time since they were computed last
   */
  abstract void computeForce(long sinceLastNanos);

  /** Adds the effects to force and torque, about the reference point of what is held. */
  final void addEffects(long sinceLastNanos) {
    if (effects.areActive()) {
      describe(hand);
      hand.contact = isTouching();
      hand.contactNewton.set(forceNewton);
      hand.contactTorqueNewtonMm.set(torqueNewtonMm);
      hand.advance(sinceLastNanos);
      effects.add(hand, sinceLastNanos, forceNewton, torqueNewtonMm);
      if (!hand.isRigid) {
        torqueNewtonMm.set(0, 0, 0);
      }
    }
  }

  /** Writes poses and what is held. */
  abstract void describe(HandState dest);

  /** Lets effects begin anew, because the hand holds something else from now on. */
  final void beginEffectsAnew() {
    if (effects.areActive()) {
      hand.forget();
      effects.beginAnew();
    }
  }

  /** Returns the length of the force with which the tool presses, without that of effects, N. */
  final double pressingNewton() {
    double felt = forceNewton.length();
    return effects.areActive() ? Math.min(felt, hand.contactNewton.length()) : felt;
  }

  /** Returns the part of the last force that no effect made, until the next call. */
  final Vec3 forceOfContact() {
    return forceNewton.sub(effects.lastForceNewton(), contactForce);
  }

  /** Returns the part of the last torque that no effect made, until the next call. */
  final Vec3 torqueOfContact() {
    return torqueNewtonMm.sub(effects.lastTorqueNewtonMm(), contactTorque);
  }

  /**
   * Limits force and torque; a device without torque gets none.
   *
   * @param nanos the time that counts for the slew: that of the frame, or the device's report
   *     interval if there are several frames in one
   */
  private void limitForce(long nanos) {
    forceLimiter.clamp(forceNewton, nanos);
    if (givesTorque) {
      torqueLimiter.clamp(torqueNewtonMm, nanos);
    } else {
      torqueNewtonMm.set(0, 0, 0);
    }
  }

  private void dropForce() {
    forceNewton.set(0, 0, 0);
    torqueNewtonMm.set(0, 0, 0);
    effects.drop();
    resetLimiters();
  }

  private void resetLimiters() {
    forceLimiter.reset();
    torqueLimiter.reset();
  }

  private void writeForce() {
    boolean reached = device.write(forceNewton, torqueNewtonMm);
    boolean isZero = forceNewton.length() == 0 && torqueNewtonMm.length() == 0;
    counters.noteForce(!reached || !isZero);
    if (reached) {
      unreachableNanos = 0;
    } else {
      unreachableNanos += Math.max(0, elapsedNanos);
      counters.countUnreached();
    }
  }

  private void countFrame() {
    counters.countFrame(isTouching(), forceNewton, freed);
    if (givesTorque) {
      counters.countTorque(torqueNewtonMm);
    }
  }

  /** Whether the tool is in contact. */
  abstract boolean isTouching();

  /** Publishes the result of the frame. */
  abstract void publish(long frame);

  private void noteApproaches() {
    for (int n = 0; followed && n < approaches.length; n++) {
      note(counters.lastFrame(), approaches[n]);
    }
  }

  /** Notes where the tool is at the end of a frame. */
  abstract void note(long frame, NearestApproach dest);

  private void showObserver() {
    if (observer == null || !followed) {
      return;
    }
    record.timeNanos = sample.timeNanos;
    record.relocated = sample.relocated;
    record.freed = freed;
    record.forceNewton.set(forceNewton);
    record.pressingNewton = pressingNewton();
    describe(record);
    observer.accept(record);
  }

  /** Writes positions, contacts and what is held. */
  abstract void describe(FrameRecord dest);

  /** Whether somebody asks what frames did. */
  final boolean isObserved() {
    return observer != null;
  }

  private FrameOutcome outcome() {
    return unreachableNanos > settings.silenceNanos()
        ? FrameOutcome.DEVICE_GONE
        : FrameOutcome.RUNNING;
  }

  /**
   * Sends zero force and torque at once, without the slew limit. Haptic thread, after the last
   * frame.
   *
   * @return false if the device could not be reached
   */
  public boolean release() {
    dropForce();
    return device.write(ZERO, ZERO);
  }

  /** Returns the time since force and torque were computed last. */
  final long sinceForceNanos() {
    return sinceForceNanos;
  }

  /** {@return what changes the voxels of the scene; haptic thread, or before the first frame} */
  public abstract VoxelWriter voxels();

  /**
   * Notes how near the tool comes to segments. Call it before the first frame.
   *
   * @param segments one record for each segment that is watched; kept
   */
  public void watch(List<NearestApproach> segments) {
    approaches = segments.toArray(new NearestApproach[0]);
  }

  /**
   * Sets who receives what frames did. Call it before the first frame.
   *
   * @param newObserver receives each frame's record on the haptic thread; it must not allocate or
   *     wait
   */
  public void observe(FrameObserver newObserver) {
    observer = newObserver;
  }

  /**
   * Cuts with the tool from now on. Call it before the first frame.
   *
   * @param settings how fast, and what is kept
   */
  public abstract void carve(CarveSettings settings);

  /**
   * Passes to these effects from the next frame on, without a step in the force; see {@link
   * HapticEffects}. They then belong to the frame. Any thread.
   *
   * @param wanted new effects in the order in which they add up; empty for none
   */
  public void requestEffects(List<HapticEffect> wanted) {
    requestedEffects = List.copyOf(wanted);
  }

  /**
   * {@return the number, from 0, under which a recording notes changes of voxels by this frame} A
   * replay has a frame for each new sample. So it is the number of the frame's own new sample or,
   * if the frame has none, that of the next one. Haptic thread.
   */
  public long sampleOfChanges() {
    return isSampleNew ? samples - 1 : samples;
  }

  /** {@return the device's last sample, unchecked} It belongs to the frame. */
  public DeviceState sample() {
    return sample;
  }

  /** {@return the last written force, N} It belongs to the frame. */
  public Vec3 forceNewton() {
    return forceNewton;
  }

  /** {@return the last written torque about the tool's reference point, N mm} */
  public Vec3 torqueNewtonMm() {
    return torqueNewtonMm;
  }

  /** {@return whether the last frame set the tool free, so that a new chain of legs begins} */
  public boolean wasFreed() {
    return freed;
  }

  /** {@return whether the last frame had a new sample and moved the tool after it} */
  public boolean followed() {
    return followed;
  }

  /** {@return the device that the frame reads and writes} Any thread. */
  public HapticDevice device() {
    return device;
  }

  /** {@return the number of frames so far} Any thread. */
  public long frameCount() {
    return counters.frames();
  }

  /** {@return whether the last frame ended in contact} Any thread. */
  public boolean inContact() {
    return counters.contact();
  }

  /**
   * {@return whether the device may exert a force or a torque: the last ones that were written were
   * not zero, or did not arrive} Any thread.
   */
  public boolean mayExertForce() {
    return counters.mayExertForce();
  }

  /** {@return the length of the last force, N} Any thread. */
  public double forceLengthNewton() {
    return counters.forceNewton();
  }

  /**
   * {@return the statistics so far} Allocates. Haptic thread, or any thread after the last frame.
   */
  public FrameStatistics statistics() {
    long notFinite = forceLimiter.notFinite() + torqueLimiter.notFinite();
    return counters.statistics(watchdog, skipped(), notFinite);
  }

  /** Returns how often work was skipped, by key. */
  abstract Map<String, Long> skipped();
}
