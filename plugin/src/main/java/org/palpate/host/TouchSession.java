package org.palpate.host;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.palpate.device.HandTarget;
import org.palpate.device.HapticDevice;
import org.palpate.device.SimulatedDevice;
import org.palpate.frame.FrameSettings;
import org.palpate.frame.HapticFrame;
import org.palpate.loop.HapticLoop;
import org.palpate.loop.LoopEnd;
import org.palpate.loop.LoopReport;
import org.palpate.loop.LoopSettings;
import org.palpate.loop.LoopStatus;
import org.palpate.loop.NanoClock;
import org.palpate.loop.WarmUp;
import org.palpate.recording.RecordingDevice;
import org.palpate.recording.SampleRecorder;
import org.palpate.sync.Accumulator;
import org.palpate.sync.Property;
import org.palpate.sync.SyncCounters;
import org.palpate.sync.TouchProperties;

/**
 * A live session: a device that touches a scene, in a haptic thread of its own.
 *
 * <pre>
 *   try (TouchSession session = new TouchSession(scene, device, 0.5, LoopSettings.ofRate(1000), recorder, end -&gt; {})) {
 *     session.start();
 *     while (!session.supervise()) { ... some 30 times a second ... }
 *   }   // zero force was sent last, the device is closed
 * </pre>
 *
 * <p>Made, supervised and closed by one thread; {@link #stop} is for any.
 */
public final class TouchSession implements AutoCloseable {
  /** The least frames that are rehearsed before force comes on, so that they find compiled code. */
  private static final int WARM_UP_LEAST_FRAMES = 10_000;

  private static final long WARM_UP_NANOS = 1_000_000_000L;
  private static final long WARM_UP_SEED = 1;

  private final HapticDevice device;
  private final HapticLoop loop;
  private final ContactTuning feel;
  private final TouchProperties properties = new TouchProperties(new Accumulator());
  private final List<Property> taken = properties.accumulator().properties();
  private long ticks;

  /**
   * A session that has not started.
   *
   * @param worldDevice positions in world mm; closed with the session
   * @param defaultNewtonPerMm stiffness where the scene's settings give none
   * @param settings pace; the warm-up is added here
   * @param recorder takes what the device sends, where one is given
   * @param listener hears of the end, once
   */
  public TouchSession(
      ContactScene scene,
      HapticDevice worldDevice,
      double defaultNewtonPerMm,
      LoopSettings settings,
      Optional<SampleRecorder> recorder,
      Consumer<LoopEnd> listener) {
    device = recorder.isPresent() ? new RecordingDevice(worldDevice, recorder.get()) : worldDevice;
    FrameSettings frameSettings = scene.liveFrame(worldDevice.specification(), defaultNewtonPerMm);
    HapticFrame frame =
        scene.newFrame(new GridDevice(device, scene.grid()), frameSettings, properties::publish);
    feel = new ContactTuning(frame, scene, frameSettings.force(), worldDevice.specification());
    Runnable warmUp = warmUp(scene, frameSettings, settings.periodNanos());
    loop = new HapticLoop(frame, settings.withWarmUp(warmUp), listener);
  }

  private static Runnable warmUp(
      ContactScene scene, FrameSettings frameSettings, long periodNanos) {
    HandTarget target = scene.handTarget();
    HapticDevice hand = new SimulatedDevice(WARM_UP_SEED, target, periodNanos);
    HapticFrame rehearsal = scene.newWarmUpFrame(new GridDevice(hand, scene.grid()), frameSettings);
    return new WarmUp(rehearsal, WARM_UP_LEAST_FRAMES, WARM_UP_NANOS, NanoClock.SYSTEM);
  }

  /** Starts the haptic thread: it warms up, then force is on. */
  public void start() {
    loop.start();
  }

  /**
   * Ends a session whose frame does not come back. To be called some 30 times a second.
   *
   * @return whether the session has ended
   */
  public boolean supervise() {
    return loop.supervise(NanoClock.SYSTEM.nanoTime());
  }

  /**
   * Takes what the frames published where no view does: the reader of {@link #properties} of a
   * session without a window.
   */
  public void takeUnseen() {
    ticks++;
    properties.accumulator().take();
    for (Property property : taken) {
      if (property.isDirty()) {
        property.markApplied();
      }
    }
  }

  /** What the surface feels like, to be changed while it is touched. Any thread. */
  public ContactTuning feel() {
    return feel;
  }

  /** A glance at the loop. Any thread. */
  public LoopStatus status() {
    return loop.status();
  }

  /** What the frames publish. Its reader is a view, or {@link #takeUnseen}, but not both. */
  public TouchProperties properties() {
    return properties;
  }

  /** How often {@link #takeUnseen} was called. */
  public long ticks() {
    return ticks;
  }

  /** What was published and taken; whole after {@link #stop}. */
  public SyncCounters syncCounts() {
    return properties.accumulator().counters();
  }

  /**
   * Ends the session: zero force is sent last, and it is waited for. Any thread, any number of
   * times.
   *
   * @return how the loop ended, now or before
   */
  public LoopEnd stop() {
    return loop.stop();
  }

  /** What was measured; whole after {@link #stop}. */
  public LoopReport report() {
    return loop.report();
  }

  /** Stops and lets the device go. */
  @Override
  public void close() {
    try {
      loop.stop();
    } finally {
      device.close();
    }
  }
}
