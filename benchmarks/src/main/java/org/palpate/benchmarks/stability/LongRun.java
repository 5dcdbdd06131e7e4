package org.palpate.benchmarks.stability;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.Arrays;
import java.util.List;
import java.util.function.Consumer;
import org.palpate.benchmarks.stability.Trial.SolverChoice;
import org.palpate.collision.CollisionScene;
import org.palpate.device.DeviceState;
import org.palpate.device.HandTarget;
import org.palpate.device.ReplayDevice;
import org.palpate.device.SimulatedDevice;
import org.palpate.device.Trajectory;
import org.palpate.edit.EditQueue;
import org.palpate.force.ForceSettings;
import org.palpate.frame.FrameOutcome;
import org.palpate.frame.FramePublisher;
import org.palpate.frame.FrameSettings;
import org.palpate.frame.GridDevice;
import org.palpate.frame.PointFrame;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.loop.Median;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.phantom.Phantom;

/**
 * Repeats the same closed motion of a hand over a head phantom. It checks that each round gives the
 * same bits as the one before, allocates nothing, and takes no longer.
 */
public final class LongRun {
  /** Frames of one round. */
  public static final int ROUND_FRAMES = 100_000;

  private static final long PERIOD_NANOS = 1_000_000;
  private static final int TIMED_ROUNDS = 10;

  /** The reference; the round before it starts with a solver without any history. */
  private static final int REFERENCE_ROUND = 1;

  private static final long HASH_FACTOR = 0x9E3779B97F4A7C15L;

  private final SegmentedVolume head = Phantom.parse("head:128").segments();
  private final ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
  private final ReplayDevice device;
  private final PointFrame frame;
  private long nowNanos;

  /**
   * The result of a long run.
   *
   * @param frames all frames
   * @param contactFrames the frames with contact
   * @param differingRounds rounds whose points or forces differ in a bit from the second round; the
   *     first round starts with a solver without any history
   * @param allocatingRounds rounds after the warm-up in which the thread allocated
   * @param firstNanosPerFrame the median of the first warm rounds
   * @param lastNanosPerFrame the median of the last rounds
   */
  public record Result(
      long frames,
      long contactFrames,
      long differingRounds,
      long allocatingRounds,
      double firstNanosPerFrame,
      double lastNanosPerFrame) {}

  /** Creates a run of one solver with a seeded hand. */
  public LongRun(SolverChoice solver, long seed) {
    GridMetric metric = GridMetric.of(head.grid().spacingMm());
    device = new ReplayDevice("closed motion", motion(seed));
    List<Segment> segments = head.segments();
    frame =
        new PointFrame(
            GridDevice.inGridCoordinates(device),
            solver.factory().make(metric, 8),
            new CollisionScene(segments.stream().map(Segment::bits).toList()),
            metric,
            FrameSettings.live(device.specification(), ForceSettings.of(0.5, 0.2)),
            new EditQueue(head.grid(), segments.size()),
            FramePublisher.NONE);
  }

  /** Returns a motion that starts and ends at the same free position. */
  private Trajectory motion(long seed) {
    double edge = head.grid().sizeX();
    HandTarget target =
        HandTarget.ofBox(
            new Vec3(0.1 * edge, 0.1 * edge, 0.1 * edge),
            new Vec3(0.9 * edge, 0.9 * edge, 0.9 * edge),
            1);
    SimulatedDevice hand = new SimulatedDevice(seed, target, PERIOD_NANOS);
    Trajectory motion = new Trajectory();
    DeviceState sample = new DeviceState();
    Vec3 home = new Vec3(-1.25, -2.5, -3.75);
    int homeFrames = ROUND_FRAMES / 20;
    for (int n = 0; n < ROUND_FRAMES; n++) {
      hand.read(sample);
      boolean atHome = n < homeFrames || n >= ROUND_FRAMES - homeFrames;
      Vec3 at = atHome ? home : sample.positionMm;
      motion.add(n, at.x, at.y, at.z);
    }
    return motion;
  }

  /**
   * Runs a number of rounds.
   *
   * @param rounds the number of rounds, at least 20
   * @param progress receives a line for every tenth round
   */
  public Result run(int rounds, Consumer<String> progress) {
    double[] nanos = new double[rounds];
    long reference = 0;
    long differing = 0;
    long allocating = 0;
    for (int round = 0; round < rounds; round++) {
      long allocated = threads.getCurrentThreadAllocatedBytes();
      long began = System.nanoTime();
      long hash = round();
      nanos[round] = (double) (System.nanoTime() - began) / ROUND_FRAMES;
      allocated = threads.getCurrentThreadAllocatedBytes() - allocated;
      reference = round <= REFERENCE_ROUND ? hash : reference;
      differing += hash == reference ? 0 : 1;
      allocating += round >= TIMED_ROUNDS && allocated > 0 ? 1 : 0;
      if (round % TIMED_ROUNDS == 0) {
        progress.accept("long run: round " + round + " of " + rounds);
      }
    }
    return new Result(
        frame.statistics().frames(),
        frame.statistics().contactFrames(),
        differing,
        allocating,
        medianOfRounds(nanos, TIMED_ROUNDS),
        medianOfRounds(nanos, rounds - TIMED_ROUNDS));
  }

  /** Runs a round and returns a hash of every bit of every point and force. */
  private long round() {
    device.rewind();
    long hash = 0;
    Vec3 point = frame.point().position;
    Vec3 force = frame.forceNewton();
    for (int n = 0; n < ROUND_FRAMES; n++) {
      FrameOutcome outcome = frame.run(nowNanos);
      assert outcome == FrameOutcome.RUNNING;
      nowNanos += PERIOD_NANOS;
      hash = mix(mix(hash, point), force);
    }
    return hash;
  }

  private static long mix(long hash, Vec3 value) {
    long mixed = hash;
    mixed = (mixed ^ Double.doubleToRawLongBits(value.x)) * HASH_FACTOR;
    mixed = (mixed ^ Double.doubleToRawLongBits(value.y)) * HASH_FACTOR;
    mixed = (mixed ^ Double.doubleToRawLongBits(value.z)) * HASH_FACTOR;
    return mixed ^ (mixed >>> 29);
  }

  private static double medianOfRounds(double[] nanos, int from) {
    return Median.of(Arrays.copyOfRange(nanos, from, from + TIMED_ROUNDS));
  }
}
