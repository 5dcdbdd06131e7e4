package org.palpate.benchmarks.elastic;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.List;
import java.util.concurrent.locks.LockSupport;
import org.palpate.benchmarks.rigid.Quantile;
import org.palpate.benchmarks.rigid.RigidFigure;
import org.palpate.elastic.ElasticThread;

/**
 * Measures the processor time of frames as a session runs them: one each millisecond, while the
 * updates run in a thread of their own. In each millisecond the same clock also measures a fixed
 * calculation in registers. What its slowest runs take longer than usual is the share of the
 * machine. Of every two milliseconds, one begins with the frame and one with the calculation.
 */
final class SessionTimes {
  private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();
  private static final double NANOS_PER_MICRO = 1e3;
  private static final long PERIOD_NANOS = 1_000_000;

  /** The steps of the fixed calculation, which then takes about as long as a frame. */
  private static final int CALCULATION_STEPS = 700;

  private final double[] frameMicros;
  private final double[] fixedMicros;
  private final double clockMicros;
  private double result = 1;

  SessionTimes(int frames) {
    frameMicros = new double[frames];
    fixedMicros = new double[frames];
    clockMicros = ElasticTimes.clockMicros();
  }

  /** Returns the figures of a session that presses and slides with a solver. */
  List<RigidFigure> figures(Softness softness) {
    ElasticSession session = ElasticTimes.warm(softness);
    try (ElasticThread updates = new ElasticThread(session.body())) {
      updates.start();
      run(session);
    }
    if (!(result > 0)) {
      throw new IllegalStateException("the calculation gave " + result);
    }
    String condition = softness.solver() + ", updates in their own thread";
    String study = ElasticTimes.STUDY;
    return List.of(
        new RigidFigure(study, condition, "frame p50", Quantile.of(frameMicros, 0.5), "us", 1.5),
        new RigidFigure(study, condition, "frame p99.9", Quantile.of(frameMicros, 0.999), "us", 10),
        fixed(condition, "fixed calculation p50", 0.5),
        fixed(condition, "fixed calculation p99.9", 0.999));
  }

  private RigidFigure fixed(String condition, String name, double part) {
    double micros = Quantile.of(fixedMicros, part);
    return RigidFigure.of(ElasticTimes.STUDY, condition, name, micros, "us");
  }

  private void run(ElasticSession session) {
    long next = System.nanoTime();
    for (int n = 0; n < frameMicros.length; n++) {
      ElasticTimes.slide(session, n);
      if (n % 2 == 0) {
        frameMicros[n] = frameMicros(session);
        fixedMicros[n] = fixedMicros();
      } else {
        fixedMicros[n] = fixedMicros();
        frameMicros[n] = frameMicros(session);
      }
      next = Math.max(next + PERIOD_NANOS, System.nanoTime());
      LockSupport.parkNanos(next - System.nanoTime());
    }
  }

  private double frameMicros(ElasticSession session) {
    long begin = THREADS.getCurrentThreadCpuTime();
    session.runFrame();
    return (THREADS.getCurrentThreadCpuTime() - begin) / NANOS_PER_MICRO - clockMicros;
  }

  private double fixedMicros() {
    long begin = THREADS.getCurrentThreadCpuTime();
    double value = result;
    for (int n = 0; n < CALCULATION_STEPS; n++) {
      value = 0.5 * value + 1;
    }
    result = value;
    return (THREADS.getCurrentThreadCpuTime() - begin) / NANOS_PER_MICRO - clockMicros;
  }
}
