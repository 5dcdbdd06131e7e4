package org.palpate.benchmarks;

import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;
import org.palpate.collision.CollisionScene;
import org.palpate.device.HandTarget;
import org.palpate.device.HapticDevice;
import org.palpate.device.SimulatedDevice;
import org.palpate.edit.EditQueue;
import org.palpate.force.ForceSettings;
import org.palpate.frame.FramePublisher;
import org.palpate.frame.FrameSettings;
import org.palpate.frame.GridDevice;
import org.palpate.frame.PointFrame;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.exact.GuardedSolver;
import org.palpate.recording.RecordingDevice;
import org.palpate.recording.SampleRecorder;
import org.palpate.sync.Accumulator;
import org.palpate.sync.TouchProperties;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.phantom.Phantom;

/**
 * Time of a whole haptic frame, from the reading of the device to its force, for a simulated hand
 * on the head phantom; alone, or with a recorder and the properties that the scene shows.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class WholeFrameBenchmark {
  private static final int FRAMES = 1_000;
  private static final long FRAME_NANOS = 1_000_000;
  private static final long SEED = 7;

  /** Whether the frame is recorded and shown. */
  @Param({"bare", "recorded and shown"})
  public String frameOf;

  private final SampleRecorder recorder = new SampleRecorder();
  private PointFrame frame;
  private long nowNanos;

  /** Makes the phantom and the hand. */
  @Setup
  public void prepare() {
    SegmentedVolume volume = Phantom.parse("head:256").segments();
    GridMetric metric = GridMetric.of(volume.grid().spacingMm());
    CollisionScene scene =
        new CollisionScene(volume.segments().stream().map(segment -> segment.bits()).toList());
    HandTarget target = HandTarget.ofBox(new Vec3(40, 40, 40), new Vec3(216, 216, 216), 1);
    SimulatedDevice hand = new SimulatedDevice(SEED, target, FRAME_NANOS);
    boolean whole = frameOf.startsWith("recorded");
    HapticDevice device = whole ? new RecordingDevice(hand, recorder) : hand;
    TouchProperties touch = new TouchProperties(new Accumulator());
    frame =
        new PointFrame(
            GridDevice.inGridCoordinates(device),
            new GuardedSolver(metric, 8),
            scene,
            metric,
            FrameSettings.live(hand.specification(), ForceSettings.of(0.5, 0.2)),
            new EditQueue(volume.grid(), volume.segments().size()),
            whole ? touch::publish : FramePublisher.NONE);
  }

  /** Runs a second of a session. */
  @Benchmark
  @OperationsPerInvocation(FRAMES)
  public long run() {
    for (int n = 0; n < FRAMES; n++) {
      nowNanos += FRAME_NANOS;
      frame.run(nowNanos);
    }
    recorder.drainTo((sample, flags) -> {});
    return nowNanos;
  }
}
