package org.palpate.opencl;

import java.util.Arrays;
import java.util.concurrent.atomic.AtomicLong;
import org.palpate.collision.CollisionDevice;
import org.palpate.collision.LegBatch;
import org.palpate.collision.LegVerdict;
import org.palpate.geometry.AffineMap;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.PointSet;

/**
 * Measures on the machine at hand from how many legs a batch is faster than the CPU: the median
 * time of a batch, from sending the maps to the last verdict, over the CPU's time for a leg. A
 * device whose median comes near the deadline is not used.
 */
final class LaunchCost implements OpenClDevice.Chooser {
  /** The batches before the measured ones. Drivers compile kernels at the first of them. */
  private static final int WARM_UP_BATCHES = 5;

  private static final int MEASURED_BATCHES = 31;

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
  public long crossover(OpenClLegs batch, PointSet points, long firstNanos) {
    return crossover(batchNanos(batch, firstNanos), points.count());
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

  /** Returns the median time of a batch whose legs are short and lie amid the voxels, ns. */
  static double batchNanos(OpenClLegs batch, long firstNanos) {
    IntBox box = batch.voxels().bounds();
    AffineMap from = new AffineMap();
    AffineMap to = new AffineMap();
    if (!box.isEmpty()) {
      from.offsetX = (box.lowX + box.highX) / 2.0;
      from.offsetY = (box.lowY + box.highY) / 2.0;
      from.offsetZ = (box.lowZ + box.highZ) / 2.0;
    }
    to.set(from);
    to.offsetX += 0.3;
    to.offsetY -= 0.2;
    return medianNanos(WARM_UP_BATCHES, MEASURED_BATCHES, () -> batch.judge(from, to, firstNanos));
  }

  private static double measureCpu() {
    NearBall ball = new NearBall(LEGS);
    LegBatch batch = CollisionDevice.CPU.keep(ball.voxels()).newBatch(ball);
    batch.judge(ball.from(), ball.to());
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
      hits += batch.verdict(n) == LegVerdict.HIT ? 1 : 0;
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
