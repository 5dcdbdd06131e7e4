package org.palpate.opencl;

import java.util.Arrays;
import java.util.concurrent.atomic.AtomicLong;
import org.palpate.collision.CollisionDevice;
import org.palpate.collision.LegBatch;
import org.palpate.collision.LegVerdict;
import org.palpate.collision.MotionGroup;
import org.palpate.geometry.AffineMap;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.PointSet;
import org.palpate.opencl.OpenClDevice.Choice;

/**
 * Measures on the machine at hand from how many legs a batch is faster than the CPU: the median
 * time of a batch, from sending the maps to the last verdict, over the CPU's time for a leg. A
 * device whose median comes near the deadline is not used. Several motions share a launch if they
 * take less than twice the time of one.
 */
final class LaunchCost implements OpenClDevice.Chooser {
  /** The batches before the measured ones. Drivers compile kernels at the first of them. */
  private static final int WARM_UP_BATCHES = 5;

  private static final int MEASURED_BATCHES = 31;

  /** The most time of a launch for several motions, as a multiple of that for one. */
  private static final double MOST_FOR_SEVERAL = 2;

  private static final int LEGS = 2_000;
  private static final int WARM_UP_ROUNDS = 30;
  private static final int MEASURED_ROUNDS = 15;

  private final double mostNanos;
  private final double nanosPerLeg;

  /**
   * Measures the CPU. Takes some milliseconds.
   *
   * @param deadlineNanos the time within which a batch must be judged
   */
  LaunchCost(long deadlineNanos) {
    mostNanos = deadlineNanos / 2.0;
    nanosPerLeg = measureCpu();
  }

  /** Returns the time of the CPU for a leg near a surface, ns. */
  double nanosPerLeg() {
    return nanosPerLeg;
  }

  @Override
  public Choice choose(OpenClLegs batch, PointSet points, long firstNanos) {
    double one = batchNanos(batch, 1, firstNanos);
    long crossover = crossover(one, points.count());
    int most = MotionGroup.CAPACITY;
    return new Choice(
        crossover,
        crossover == LegBatch.NEVER ? 1 : motionsAtOnce(one, batchNanos(batch, most, firstNanos)));
  }

  /**
   * Returns the number of motions that a launch should judge.
   *
   * @param oneNanos the median time of a launch for one motion
   * @param severalNanos that of a launch for {@link MotionGroup#CAPACITY} motions
   */
  int motionsAtOnce(double oneNanos, double severalNanos) {
    boolean pays = severalNanos < MOST_FOR_SEVERAL * oneNanos && severalNanos <= mostNanos;
    return pays ? MotionGroup.CAPACITY : 1;
  }

  /**
   * Returns the number of legs from which a batch pays; {@link LegBatch#NEVER} if no motion of the
   * points has so many, or the batch takes too long.
   *
   * @param batchNanos the median time of a batch
   */
  long crossover(double batchNanos, int points) {
    double legs = Math.ceil(batchNanos / nanosPerLeg);
    return legs <= points && batchNanos <= mostNanos ? (long) legs : LegBatch.NEVER;
  }

  /**
   * Returns the median time of a launch whose legs are short and lie amid the voxels, ns.
   *
   * @param motions the number of motions that it judges
   */
  static double batchNanos(OpenClLegs batch, int motions, long firstNanos) {
    IntBox box = batch.voxels().bounds();
    AffineMap map = new AffineMap();
    if (!box.isEmpty()) {
      map.offsetX = (box.lowX + box.highX) / 2.0;
      map.offsetY = (box.lowY + box.highY) / 2.0;
      map.offsetZ = (box.lowZ + box.highZ) / 2.0;
    }
    MotionGroup group = new MotionGroup();
    group.begin(map);
    for (int n = 0; n < motions; n++) {
      map.offsetX += 0.3;
      map.offsetY -= 0.2;
      group.add(map);
    }
    return medianNanos(WARM_UP_BATCHES, MEASURED_BATCHES, () -> batch.judge(group, firstNanos));
  }

  private static double measureCpu() {
    NearBall ball = new NearBall(LEGS);
    LegBatch batch = CollisionDevice.CPU.keep(ball.voxels()).newBatch(ball);
    batch.judge(ball.motions(1));
    AtomicLong hits = new AtomicLong(); // read below, so that no judging can be left out
    double nanos =
        medianNanos(WARM_UP_ROUNDS, MEASURED_ROUNDS, () -> hits.addAndGet(countHits(batch)));
    if (hits.get() == 0) {
      throw new IllegalStateException("no leg near a surface touches it");
    }
    return Math.max(1, nanos / LEGS);
  }

  private static long countHits(LegBatch batch) {
    long hits = 0;
    for (int n = 0; n < LEGS; n++) {
      hits += batch.verdict(0, n) == LegVerdict.HIT ? 1 : 0;
    }
    return hits;
  }

  /** Runs an action often, after a warm-up, and returns the median of its times, ns. */
  private static double medianNanos(int warmUp, int measured, Runnable action) {
    long[] nanos = new long[measured];
    for (int n = -warmUp; n < measured; n++) {
      long start = System.nanoTime();
      action.run();
      if (n >= 0) {
        nanos[n] = System.nanoTime() - start;
      }
    }
    Arrays.sort(nanos);
    return nanos[measured / 2];
  }
}
