package org.palpate.opencl;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.palpate.collision.LegBatch;
import org.palpate.collision.MotionGroup;

/** Measures and describes from how many points a device is faster than the CPU. */
public final class LaunchExplanation {
  private static final int[] POINTS = {100, 1_000, 10_000, 100_000, 1_000_000};

  private LaunchExplanation() {}

  /** Returns a line for each number of points. Takes some seconds. */
  public static List<String> of(OpenClDevice device) {
    List<String> lines = new ArrayList<>();
    LaunchCost cost = new LaunchCost(OpenClDevice.DEADLINE_NANOS);
    lines.add(
        String.format(
            Locale.ROOT, "the CPU takes %.0f ns for a leg near a surface", cost.nanosPerLeg()));
    for (int points : POINTS) {
      lines.add(device.attempt(() -> line(device, points, cost)).orElse("the device has failed"));
    }
    return lines;
  }

  private static String line(OpenClDevice device, int points, LaunchCost cost) {
    NearBall ball = new NearBall(points);
    OpenClLegs batch = device.newBatch(ball.voxels(), ball);
    double one = LaunchCost.batchNanos(batch, 1, OpenClDevice.FIRST_DEADLINE_NANOS);
    double all =
        LaunchCost.batchNanos(batch, MotionGroup.CAPACITY, OpenClDevice.FIRST_DEADLINE_NANOS);
    return line(points, one, all, cost);
  }

  private static String line(int points, double oneNanos, double allNanos, LaunchCost cost) {
    long legs = cost.crossover(oneNanos, points);
    String from =
        legs == LegBatch.NEVER
            ? "never used"
            : String.format(
                Locale.ROOT,
                "used from %,d legs in a motion on, %d motions at once",
                legs,
                cost.motionsAtOnce(oneNanos, allNanos));
    return String.format(
        Locale.ROOT,
        "%,9d points: %,8.0f us for a motion, %,8.0f us for %d: %s",
        points,
        oneNanos / 1e3,
        allNanos / 1e3,
        MotionGroup.CAPACITY,
        from);
  }
}
