package org.palpate.imagej;

import ij.IJ;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.locks.LockSupport;
import org.palpate.geometry.Vec3;
import org.palpate.host.ContactScene;
import org.palpate.host.TouchSession;
import org.palpate.interaction.FrameRecorder;
import org.palpate.interaction.LoopEnd;
import org.palpate.interaction.LoopSettings;
import org.palpate.interaction.LoopStatus;
import org.palpate.io.Landmark;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;

/**
 * A stack being touched, from "Touch Volume..." until Escape, the end of its time, the device's
 * end, or the image closes.
 *
 * <p>{@link #run} keeps the thread of the command that began it; other commands ask {@link
 * #tipGrid} and add landmarks or brush strokes meanwhile, from their own threads.
 */
final class StackSession implements AutoCloseable {
  private static final double RATE_HZ = 1000;
  private static final long TICK_NANOS = 33_333_333;
  private static final long STATUS_TICKS = 15;
  private static final double NANOS_PER_SECOND = 1e9;

  private final StackVolume volume;
  private final StackGeometry geometry;
  private final TouchSession session;
  private final StackWatcher watcher;
  private final List<VoxelRule> rules;
  private final List<Landmark> landmarks = new ArrayList<>();
  private final Vec3 taken = new Vec3();
  private volatile Vec3 tip = new Vec3(Double.NaN, Double.NaN, Double.NaN);
  private volatile boolean stopAsked;

  /**
   * Makes segments, opens the device and gets ready.
   *
   * @throws StackRefused where the stack, the device or the choice does not allow it
   */
  StackSession(StackVolume volume, TouchOptions options, Optional<FrameRecorder> recorder)
      throws StackRefused {
    this.volume = volume;
    geometry = StackGeometry.of(volume.image());
    rules = options.rules(volume);
    IJ.showStatus("Palpate: making segments...");
    List<Segment> segments =
        StackSegments.of(volume, rules, k -> IJ.showProgress(k + 1, volume.slices()));
    refuseEmpty(segments, options);
    ContactScene scene =
        new ContactScene(new SegmentedVolume(geometry.grid(), segments), options.contactSettings());
    LoopSettings loop = LoopSettings.ofRate(RATE_HZ);
    StackDevice device = StackDevice.open(options.device(), scene.handTarget(), loop.periodNanos());
    session =
        new TouchSession(
            scene, device.device(), device.defaultNewtonPerMm(), loop, recorder, end -> {});
    watcher = new StackWatcher(volume, rules, segments, scene.edits());
  }

  private static void refuseEmpty(List<Segment> segments, TouchOptions options)
      throws StackRefused {
    long solids = segments.stream().mapToLong(segment -> segment.bits().solidCount()).sum();
    if (solids == 0) {
      throw new StackRefused(
          "No voxel has a value from "
              + options.lower()
              + " to "
              + options.upper()
              + ": choose other thresholds.");
    }
  }

  /**
   * Runs to the end, zero force sent last.
   *
   * @param seconds how long; for ever where 0
   */
  LoopEnd run(double seconds) {
    IJ.resetEscape();
    session.start();
    long tick = 0;
    long beganNanos = 0;
    while (!session.supervise() && !isOver(beganNanos, seconds)) {
      if (beganNanos == 0 && session.status().frames() > 0) {
        beganNanos = System.nanoTime();
      }
      if (beganNanos != 0) {
        takeTip();
      }
      watcher.carryOverWhenUpdated();
      if (++tick % STATUS_TICKS == 0) {
        showStatus();
      }
      LockSupport.parkNanos(TICK_NANOS);
    }
    return session.stop();
  }

  private boolean isOver(long beganNanos, double seconds) {
    boolean late =
        seconds > 0
            && beganNanos != 0
            && System.nanoTime() - beganNanos >= seconds * NANOS_PER_SECOND;
    return late || stopAsked || watcher.isClosed() || IJ.escapePressed();
  }

  private void takeTip() {
    session.takeUnseen();
    session.properties().interactionPoint().read(taken);
    tip = new Vec3(taken.x, taken.y, taken.z);
  }

  private void showStatus() {
    LoopStatus status = session.status();
    Vec3 at = geometry.gridToCalibrated(tip, new Vec3());
    IJ.showStatus(
        String.format(
            Locale.ROOT,
            "Palpate: (%.2f, %.2f, %.2f) %s, %s, %.2f N; Escape ends",
            at.x,
            at.y,
            at.z,
            geometry.unit(),
            status.contact() ? "contact" : "free",
            status.forceNewton()));
  }

  /** Asks the session to end. Any thread. */
  void askToStop() {
    stopAsked = true;
  }

  /** Where the interaction point is, grid coordinates; NaN before the first frame. Any thread. */
  Vec3 tipGrid() {
    Vec3 now = tip;
    return new Vec3(now.x, now.y, now.z);
  }

  StackVolume volume() {
    return volume;
  }

  StackGeometry geometry() {
    return geometry;
  }

  /** What makes a voxel belong to the first segment. */
  VoxelRule firstRule() {
    return rules.get(0);
  }

  /** Makes what was just written into the stack felt. Any thread. */
  void stackChanged() {
    watcher.carryOver();
  }

  /** The landmarks so far, to be added to. Hold its monitor. */
  List<Landmark> landmarks() {
    return landmarks;
  }

  LoopStatus status() {
    return session.status();
  }

  @Override
  public void close() {
    watcher.close();
    session.close();
  }
}
