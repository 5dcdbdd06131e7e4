package org.palpate.benchmarks.sync;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.locks.LockSupport;
import org.HdrHistogram.Histogram;
import org.palpate.frame.FramePublisher;
import org.palpate.geometry.Vec3;
import org.palpate.loop.Median;
import org.palpate.sync.Accumulator;
import org.palpate.sync.Property;
import org.palpate.sync.TouchProperties;

/**
 * The cost of publishing the properties of one frame (three positions and contact) to a reader at
 * 30 Hz, for the writing thread. The candidates alternate: nothing, which is the cost of the loop,
 * the paper's synchronized accumulators, and wait-free ones. The reader ignores the values, so that
 * only the publication is measured.
 */
final class WriteCost {
  private static final int ROUNDS = 9;
  private static final int WARM_UP_ROUNDS = 2;
  private static final int FRAMES = 400_000;
  private static final long READER_PERIOD_NANOS = 1_000_000_000L / 30;
  private static final long LONGEST_NANOS = 10_000_000_000L;

  /**
   * The cost of one candidate.
   *
   * @param candidate its name
   * @param nanos a frame whose values changed: processor time, median over the rounds
   * @param unchangedNanos a frame whose values did not change
   * @param p999Nanos 99.9th percentile of single frames, by the clock
   * @param maxNanos maximum of single frames, by the clock
   */
  record Row(String candidate, double nanos, double unchangedNanos, long p999Nanos, long maxNanos) {
    /** Returns the cells of its row in {@code sync-writes.csv}. */
    List<Object> cells() {
      return List.of(candidate, nanos, unchangedNanos, p999Nanos, maxNanos);
    }
  }

  private final Vec3 device = new Vec3();
  private final Vec3 point = new Vec3();
  private final Vec3 force = new Vec3();

  /** A publisher with its reader. */
  private record Candidate(String name, FramePublisher publisher, Runnable reader) {}

  /** Measures all candidates. */
  List<Row> measure() throws InterruptedException {
    PaperSync paper = new PaperSync();
    TouchProperties waitFree = new TouchProperties(new Accumulator());
    List<Candidate> candidates =
        List.of(
            new Candidate("nothing", (d, p, f, touching, frame) -> {}, () -> {}),
            new Candidate(
                "paper, synchronized", paper::publish, () -> paper.synchronize(WriteCost::ignore)),
            new Candidate("wait-free", waitFree::publish, () -> takeAll(waitFree.accumulator())));
    double[][] changed = new double[candidates.size()][ROUNDS];
    double[][] unchanged = new double[candidates.size()][ROUNDS];
    Histogram[] single = new Histogram[candidates.size()];
    Arrays.setAll(single, n -> new Histogram(LONGEST_NANOS, 3));
    for (int round = -WARM_UP_ROUNDS; round < ROUNDS; round++) {
      for (int n = 0; n < candidates.size(); n++) {
        Candidate candidate = candidates.get(n);
        Thread reader = startReader(candidate.reader());
        double moving = nanosPerFrame(candidate.publisher(), 1);
        double resting = nanosPerFrame(candidate.publisher(), 0);
        if (round >= 0) {
          changed[n][round] = moving;
          unchanged[n][round] = resting;
          record(candidate.publisher(), single[n]);
        }
        reader.interrupt();
        reader.join();
      }
    }
    List<Row> rows = new ArrayList<>();
    for (int n = 0; n < candidates.size(); n++) {
      rows.add(
          new Row(
              candidates.get(n).name(),
              Median.of(changed[n]),
              Median.of(unchanged[n]),
              single[n].getValueAtPercentile(99.9),
              single[n].getMaxValue()));
    }
    return rows;
  }

  private static void ignore(Vec3 device, Vec3 point, Vec3 force, boolean contact) {}

  private static void takeAll(Accumulator accumulator) {
    if (accumulator.take()) {
      for (Property property : accumulator.properties()) {
        property.markApplied();
      }
    }
  }

  private static Thread startReader(Runnable read) {
    Thread reader =
        new Thread(
            () -> {
              while (!Thread.currentThread().isInterrupted()) {
                read.run();
                LockSupport.parkNanos(READER_PERIOD_NANOS);
              }
            },
            "palpate-reader");
    reader.start();
    return reader;
  }

  /** Returns the processor time of a frame whose values change by {@code step} per frame. */
  private double nanosPerFrame(FramePublisher publisher, double step) {
    ThreadMXBean time = ManagementFactory.getThreadMXBean();
    long began = time.getCurrentThreadCpuTime();
    for (int frame = 0; frame < FRAMES; frame++) {
      publish(publisher, frame * step, frame);
    }
    return (time.getCurrentThreadCpuTime() - began) / (double) FRAMES;
  }

  private void record(FramePublisher publisher, Histogram single) {
    for (int frame = 0; frame < FRAMES; frame++) {
      long began = System.nanoTime();
      publish(publisher, frame, frame);
      single.recordValue(Math.min(LONGEST_NANOS, System.nanoTime() - began));
    }
  }

  private void publish(FramePublisher publisher, double at, long frame) {
    device.set(at, 1, 2);
    point.set(at, 3, 4);
    force.set(at, 5, 6);
    publisher.publish(device, point, force, true, frame);
  }
}
