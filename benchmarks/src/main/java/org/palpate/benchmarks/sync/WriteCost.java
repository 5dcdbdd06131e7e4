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
import org.palpate.sync.Accumulator;
import org.palpate.sync.Property;
import org.palpate.sync.TouchProperties;

/**
 * What handing the properties of one frame (three positions and contact) to a reader at 30 Hz costs
 * the thread that writes: by nothing, which is what the loop around it takes, by the paper's
 * synchronized accumulators and by wait-free ones, in turns in one run. The reader does nothing
 * with what it takes, so that the hand-over alone is measured.
 */
final class WriteCost {
  private static final int ROUNDS = 9;
  private static final int WARM_UP_ROUNDS = 2;
  private static final int FRAMES = 400_000;
  private static final long READER_PERIOD_NANOS = 1_000_000_000L / 30;
  private static final long LONGEST_NANOS = 10_000_000_000L;

  /**
   * What one way costs.
   *
   * @param nanos of a frame whose values changed: median over the rounds, processor time
   * @param unchangedNanos of a frame whose values did not
   * @param p999Nanos of single frames, by the clock
   * @param maxNanos of single frames, by the clock
   */
  record Row(String way, double nanos, double unchangedNanos, long p999Nanos, long maxNanos) {}

  private final Vec3 device = new Vec3();
  private final Vec3 point = new Vec3();
  private final Vec3 force = new Vec3();

  /** A way with its reader. */
  private record Way(String name, FramePublisher publisher, Runnable reader) {}

  List<Row> measure() throws InterruptedException {
    PaperSync paper = new PaperSync();
    TouchProperties ours = new TouchProperties(new Accumulator());
    List<Way> ways =
        List.of(
            new Way("nothing", (d, p, f, touching, frame) -> {}, () -> {}),
            new Way("paper, synchronized", paper::publish, () -> paper.synchronize(WriteCost::no)),
            new Way("wait-free", ours::publish, () -> takeAll(ours.accumulator())));
    double[][] changed = new double[ways.size()][ROUNDS];
    double[][] unchanged = new double[ways.size()][ROUNDS];
    Histogram[] single = new Histogram[ways.size()];
    Arrays.setAll(single, n -> new Histogram(LONGEST_NANOS, 3));
    for (int round = -WARM_UP_ROUNDS; round < ROUNDS; round++) {
      for (int n = 0; n < ways.size(); n++) {
        Way way = ways.get(n);
        Thread reader = startReader(way.reader());
        double moving = nanosAFrame(way.publisher(), 1);
        double resting = nanosAFrame(way.publisher(), 0);
        if (round >= 0) {
          changed[n][round] = moving;
          unchanged[n][round] = resting;
          record(way.publisher(), single[n]);
        }
        reader.interrupt();
        reader.join();
      }
    }
    List<Row> rows = new ArrayList<>();
    for (int n = 0; n < ways.size(); n++) {
      rows.add(
          new Row(
              ways.get(n).name(),
              median(changed[n]),
              median(unchanged[n]),
              single[n].getValueAtPercentile(99.9),
              single[n].getMaxValue()));
    }
    return rows;
  }

  private static void no(Vec3 device, Vec3 point, Vec3 force, boolean contact) {}

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

  /** Processor time of a frame, the values moving by {@code step} from frame to frame. */
  private double nanosAFrame(FramePublisher publisher, double step) {
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

  private static double median(double[] values) {
    double[] sorted = values.clone();
    Arrays.sort(sorted);
    return sorted[sorted.length / 2];
  }
}
