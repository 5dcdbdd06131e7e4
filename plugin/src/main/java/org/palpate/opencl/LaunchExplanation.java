package org.palpate.opencl;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.palpate.collision.LegBatch;

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
      NearBall ball = new NearBall(points);
      Optional<Double> nanos =
          device.attempt(
              () ->
                  LaunchCost.batchNanos(
                      device.newBatch(ball.voxels(), ball), OpenClDevice.FIRST_DEADLINE_NANOS));
      lines.add(nanos.map(each -> line(points, each, cost)).orElse("the device has failed"));
    }
    return lines;
  }

  private static String line(int points, double batchNanos, LaunchCost cost) {
    long legs = cost.crossover(batchNanos, points);
    String from =
        legs == LegBatch.NEVER
            ? "never used"
            : String.format(Locale.ROOT, "used from %,d legs in a motion on", legs);
    return String.format(
        Locale.ROOT, "%,9d points: %,8.0f us for a batch: %s", points, batchNanos / 1e3, from);
  }
}
