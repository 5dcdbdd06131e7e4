package org.palpate.benchmarks.carve;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.Arrays;
import java.util.List;
import org.palpate.benchmarks.rigid.Quantile;
import org.palpate.benchmarks.rigid.RigidFigure;

/**
 * Measures the time of cutting: a burr of 6 mm diameter and about 1,000 points moves through voxels
 * of 0.25 mm at 60 mm/s, pressed 2 mm deep. Times are those of the processor, without
 * interruptions.
 *
 * <p>Every pass does the same work. The least time of a frame over several passes is that of its
 * work; the times of one pass also have what other programs on the machine cost it.
 */
final class CarveTimes {
  private static final double NANOS_PER_MICRO = 1e3;

  /** The least number of frames before a session switches the force on. */
  private static final int WARM_UP_FRAMES = 10_000;

  private static final int PASSES = 5;

  private final ThreadMXBean threads = ManagementFactory.getThreadMXBean();
  private final double[] carveMicros;
  private final double[] frameMicros;
  private final double[] leastCarveMicros;
  private final double[] leastFrameMicros;
  private long removed;

  CarveTimes(int frames) {
    carveMicros = new double[frames];
    frameMicros = new double[frames];
    leastCarveMicros = new double[frames];
    leastFrameMicros = new double[frames];
    Arrays.fill(leastCarveMicros, Double.POSITIVE_INFINITY);
    Arrays.fill(leastFrameMicros, Double.POSITIVE_INFINITY);
  }

  /** Warms up as long as a live session does, and returns the figures. */
  List<RigidFigure> figures() {
    for (int frames = 0; frames < WARM_UP_FRAMES; frames += frameMicros.length) {
      run();
    }
    for (int pass = 0; pass < PASSES; pass++) {
      run();
      keepLeast(carveMicros, leastCarveMicros);
      keepLeast(frameMicros, leastFrameMicros);
    }
    String burr = DrilledSlab.NAME;
    return List.of(
        figure(burr, "cut p50", Quantile.of(carveMicros, 0.5), Double.NaN),
        figure(burr, "cut p99.9", Quantile.of(carveMicros, 0.999), 50),
        figure(burr, least("cut p99.9"), Quantile.of(leastCarveMicros, 0.999), Double.NaN),
        figure(burr, "cut and motion p50", Quantile.of(frameMicros, 0.5), Double.NaN),
        figure(burr, "cut and motion p99.9", Quantile.of(frameMicros, 0.999), 300),
        figure(
            burr, least("cut and motion p99.9"), Quantile.of(leastFrameMicros, 0.999), Double.NaN),
        RigidFigure.of("time", burr, "voxels removed", (double) removed, ""));
  }

  private static void keepLeast(double[] micros, double[] least) {
    for (int n = 0; n < micros.length; n++) {
      least[n] = Math.min(least[n], micros[n]);
    }
  }

  private static String least(String name) {
    return name + ", least of " + PASSES + " passes";
  }

  private static RigidFigure figure(String burr, String name, double micros, double target) {
    return new RigidFigure("time", burr, name, micros, "us", target);
  }

  private void run() {
    DrilledSlab slab = new DrilledSlab();
    for (int n = 0; n < frameMicros.length; n++) {
      slab.moveHand();
      long start = threads.getCurrentThreadCpuTime();
      slab.cut();
      long cut = threads.getCurrentThreadCpuTime();
      slab.follow();
      frameMicros[n] = (threads.getCurrentThreadCpuTime() - start) / NANOS_PER_MICRO;
      carveMicros[n] = (cut - start) / NANOS_PER_MICRO;
    }
    removed = slab.removed();
  }
}
