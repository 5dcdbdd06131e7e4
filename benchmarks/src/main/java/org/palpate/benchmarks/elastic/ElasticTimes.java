package org.palpate.benchmarks.elastic;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.palpate.benchmarks.rigid.Quantile;
import org.palpate.benchmarks.rigid.RigidFigure;
import org.palpate.geometry.GridMetric;

/**
 * Measures the time of frames, between updates in the same thread, and of updates, while a hand
 * presses 5 mm deep and slides at 15 mm/s. Times are those of the processor for one thread, without
 * interruptions and, in frames, without the reading of the clock.
 */
final class ElasticTimes {
  static final String STUDY = "time";
  static final String UPDATE_P99 = "update p99";
  static final String UPDATE_P50 = "update p50";

  private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();
  private static final double NANOS_PER_MICRO = 1e3;
  private static final double NANOS_PER_MILLI = 1e6;
  private static final int CELL = 4;
  private static final double MOST_MS = 33;

  /** The least number of frames before a session switches the force on. */
  private static final int WARM_UP_FRAMES = 10_000;

  /** Widths and heights of blocks, in cells. */
  private static final int[][] BLOCKS = {{8, 5}, {12, 8}, {16, 10}, {18, 13}, {20, 16}, {24, 15}};

  private static final double[] RESIDUALS = {1e-2, 1e-3};

  private final int frames;
  private final int updates;

  ElasticTimes(int frames, int updates) {
    this.frames = frames;
    this.updates = updates;
  }

  /** Returns the figures of frames. */
  List<RigidFigure> frameFigures() {
    List<RigidFigure> figures = new ArrayList<>();
    figures.addAll(frameFigures(Softness.USUAL));
    figures.addAll(frameFigures(Softness.USUAL.withSmooth()));
    return figures;
  }

  private List<RigidFigure> frameFigures(Softness softness) {
    ElasticSession session = warm(softness);
    double[] micros = new double[frames];
    double clockMicros = clockMicros();
    double fewestBytes = Double.POSITIVE_INFINITY;
    for (int quarter = 0; quarter < 4; quarter++) {
      double bytes = 0;
      for (int n = quarter * frames / 4; n < (quarter + 1) * frames / 4; n++) {
        slide(session, n);
        session.update();
        long allocated = THREADS.getCurrentThreadAllocatedBytes();
        long begin = THREADS.getCurrentThreadCpuTime();
        session.runFrame();
        micros[n] = (THREADS.getCurrentThreadCpuTime() - begin) / NANOS_PER_MICRO - clockMicros;
        bytes += THREADS.getCurrentThreadAllocatedBytes() - allocated;
      }
      fewestBytes = Math.min(fewestBytes, bytes);
    }
    String solver = softness.solver();
    return List.of(
        new RigidFigure(STUDY, solver, "frame p50", Quantile.of(micros, 0.5), "us", 1.5),
        RigidFigure.of(STUDY, solver, "frame p99.9", Quantile.of(micros, 0.999), "us"),
        new RigidFigure(STUDY, solver, "bytes in frames", fewestBytes, "B", 0));
  }

  /** Returns a session that presses, after enough frames for the compiler. */
  static ElasticSession warm(Softness softness) {
    ElasticSession session = pressed(SoftScene.block(), softness);
    for (int n = 0; n < WARM_UP_FRAMES; n++) {
      slide(session, n);
      session.run();
    }
    return session;
  }

  /** Returns the median time that two reads of the clock measure if nothing happens between. */
  static double clockMicros() {
    double[] micros = new double[WARM_UP_FRAMES];
    for (int n = 0; n < micros.length; n++) {
      long begin = THREADS.getCurrentThreadCpuTime();
      micros[n] = (THREADS.getCurrentThreadCpuTime() - begin) / NANOS_PER_MICRO;
    }
    return Quantile.of(micros, 0.5);
  }

  private static ElasticSession pressed(SoftScene scene, Softness softness) {
    ElasticSession session = new ElasticSession(scene, softness);
    double middle = scene.soft().sizeX() / 2.0;
    double top = SoftScene.FLOOR + heightOf(scene);
    session.hand().set(middle + 0.3, middle + 0.4, top + 4);
    session.run();
    session.moveTo(middle + 0.3, middle + 0.4, top - 5, 300);
    return session;
  }

  private static int heightOf(SoftScene scene) {
    return scene.soft().bounds().highZ + 1 - SoftScene.FLOOR;
  }

  /** Moves the hand to and fro at 15 mm/s, by up to 8 mm. */
  static void slide(ElasticSession session, int frame) {
    session.hand().x += frame / 500 % 2 == 0 ? 0.015 : -0.015;
  }

  /** Returns the figures of updates, by number of elements and residual. */
  List<RigidFigure> updateFigures() {
    List<RigidFigure> figures = new ArrayList<>();
    for (double residual : RESIDUALS) {
      for (int[] block : BLOCKS) {
        figures.addAll(updateFigures(block, residual));
      }
    }
    return figures;
  }

  private List<RigidFigure> updateFigures(int[] block, double residual) {
    SoftScene scene = SoftScene.block(block[0] * CELL, block[1] * CELL, new GridMetric(1, 1, 1));
    Softness softness = Softness.USUAL.withCells(CELL, 2 * CELL).withResidual(residual);
    ElasticSession session = pressed(scene, softness);
    List<Double> millis = new ArrayList<>();
    for (int n = 0; millis.size() < updates; n++) {
      slide(session, n);
      boolean updating = session.updatesNext();
      long begin = THREADS.getCurrentThreadCpuTime();
      session.update();
      if (updating) {
        millis.add((THREADS.getCurrentThreadCpuTime() - begin) / NANOS_PER_MILLI);
      }
      session.runFrame();
    }
    double[] all = millis.stream().mapToDouble(Double::doubleValue).toArray();
    int elements = session.body().hexahedra();
    double p99 = Quantile.of(all, 0.99);
    String condition = condition(residual, elements);
    double reached = session.body().counters().worstResidual();
    return List.of(
        RigidFigure.of(STUDY, condition, UPDATE_P50, Quantile.of(all, 0.5), "ms"),
        new RigidFigure(STUDY, condition, UPDATE_P99, p99, "ms", target(residual, elements)),
        RigidFigure.of(STUDY, condition, "largest residual", reached, ""));
  }

  /** Returns the condition of an update; {@link ElasticPlots} reads the elements back. */
  static String condition(double residual, int elements) {
    return String.format(Locale.ROOT, "residual %s, %d elements", residual, elements);
  }

  /** Lattices up to the wanted number of elements must meet the time, the larger ones need not. */
  private static double target(double residual, int elements) {
    int wanted = residual >= 1e-2 ? 10_400 : 7_300;
    return elements <= wanted ? MOST_MS : Double.NaN;
  }
}
