package org.palpate.benchmarks.rigid;

import java.util.List;
import java.util.Optional;
import org.HdrHistogram.Histogram;
import org.palpate.collision.CollisionDevice;
import org.palpate.collision.DeviceVoxels;
import org.palpate.collision.LegBatch;
import org.palpate.collision.LegVerdict;
import org.palpate.collision.MotionGroup;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.PointSet;
import org.palpate.geometry.Pose;
import org.palpate.volume.BitCube;

/**
 * Counts, for a tool that slides, what a device that judges legs would have to do.
 *
 * @param condition scene, tool and clearance
 * @param points the number of sample points
 * @param motions motions that are verified in a frame, mean
 * @param legsP50 legs that remain after culling in a launch, median
 * @param legsP99 the same, 99th percentile
 * @param legsMost the same, maximum
 * @param alone launches in a frame, mean, if each motion is a launch of its own
 * @param together the same, if a launch judges a motion and its fractions
 * @param above the same, if a launch costs as much as each of {@link #COSTS} legs on the CPU
 */
public record LaunchCount(
    String condition,
    int points,
    double motions,
    long legsP50,
    long legsP99,
    long legsMost,
    double alone,
    double together,
    List<Double> above) {
  /** The costs of a launch, legs of the CPU. */
  public static final List<Integer> COSTS = List.of(100, 1_000, 10_000);

  /** The percentage whose percentile is the maximum. */
  private static final double MOST = 100;

  /** Returns the number of conditions. */
  public static int conditions() {
    return TimedCondition.all().size();
  }

  /**
   * Slides a tool.
   *
   * @param number the number of the condition, from 0
   * @param frames how many frames it slides
   */
  public static LaunchCount of(int number, int frames) {
    TimedCondition condition = TimedCondition.all().get(number);
    CountingDevice plain = new CountingDevice(LegBatch.NEVER, 1);
    int points = slide(condition, plain, frames);
    CountingDevice together = slid(condition, 0, MotionGroup.CAPACITY, frames);
    return new LaunchCount(
        condition.label(),
        points,
        (double) plain.motions() / frames,
        together.legs(50),
        together.legs(99),
        together.legs(MOST),
        perFrame(slid(condition, 0, 1, frames), frames),
        perFrame(together, frames),
        COSTS.stream()
            .map(cost -> perFrame(slid(condition, cost, MotionGroup.CAPACITY, frames), frames))
            .toList());
  }

  private static double perFrame(CountingDevice device, int frames) {
    return (double) device.batches() / frames;
  }

  private static CountingDevice slid(
      TimedCondition condition, long cost, int motionsAtOnce, int frames) {
    CountingDevice device = new CountingDevice(cost, motionsAtOnce);
    slide(condition, device, frames);
    return device;
  }

  private static int slide(TimedCondition condition, CountingDevice device, int frames) {
    TimedCondition.Pressed pressed = condition.pressed(device);
    device.reset();
    Pose pose = new Pose();
    for (int frame = 0; frame < frames; frame++) {
      pressed.run().follow(pressed.device().device(frame, pose));
    }
    return pressed.run().tool.count();
  }

  /**
   * A collision device that counts what a card would have to do, and lets the CPU do it. Its counts
   * do not depend on the machine. One thread.
   */
  private static final class CountingDevice implements CollisionDevice {
    private final long crossover;
    private final int motionsAtOnce;
    private final Histogram legs = new Histogram(3);
    private long motions;
    private long launches;
    private long verdicts;

    /**
     * Creates a device.
     *
     * @param crossover the number of legs that take the CPU as long as a launch
     * @param motionsAtOnce the number of motions in a launch
     */
    CountingDevice(long crossover, int motionsAtOnce) {
      this.crossover = crossover;
      this.motionsAtOnce = motionsAtOnce;
    }

    /** Forgets all counts. */
    void reset() {
      motions = 0;
      launches = 0;
      verdicts = 0;
      legs.reset();
    }

    /** Returns the number of motions that no launch before had judged. */
    long motions() {
      return motions;
    }

    @Override
    public long batches() {
      return launches;
    }

    /** Returns a percentile of the number of legs that a launch had to judge after culling. */
    long legs(double percent) {
      return legs.getValueAtPercentile(percent);
    }

    private void endMotion() {
      if (verdicts > 0) {
        legs.recordValue(verdicts);
      }
      verdicts = 0;
    }

    @Override
    public DeviceVoxels keep(BitCube voxels) {
      DeviceVoxels kept = CPU.keep(voxels);
      return new DeviceVoxels() {
        @Override
        public void voxelsChanged(IntBox box) {}

        @Override
        public LegBatch newBatch(PointSet points) {
          return new Batch(kept.newBatch(points));
        }
      };
    }

    @Override
    public String name() {
      return "counting";
    }

    @Override
    public Optional<String> failure() {
      return Optional.empty();
    }

    @Override
    public void close() {}

    private final class Batch implements LegBatch {
      private final LegBatch exact;

      Batch(LegBatch exact) {
        this.exact = exact;
      }

      @Override
      public long crossover() {
        motions++;
        return crossover;
      }

      @Override
      public int motionsAtOnce() {
        return motionsAtOnce;
      }

      @Override
      public boolean judge(MotionGroup group) {
        endMotion();
        launches++;
        return exact.judge(group);
      }

      @Override
      public LegVerdict verdict(int motion, int point) {
        verdicts++;
        return exact.verdict(motion, point);
      }

      @Override
      public double emptyAround(int point) {
        return exact.emptyAround(point);
      }
    }
  }
}
