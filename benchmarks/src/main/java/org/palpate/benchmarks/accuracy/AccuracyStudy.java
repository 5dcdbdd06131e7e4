package org.palpate.benchmarks.accuracy;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Consumer;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.loop.Median;
import org.palpate.proxy.InteractionPoint;

/** Runs every solver on every slide: first for its errors, then in alternation for its time. */
final class AccuracyStudy {
  static final List<String> SHAPES = List.of("plane", "sphere", "torus");

  /** Processor time is used because other processes may use the machine too. */
  private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();

  private static final int EDGE = 192;
  private static final long SEED = 7;
  private static final int ROUNDS = 7;
  private static final int WARM_UP_ROUNDS = 2;
  private static final GridMetric UNIT = new GridMetric(1, 1, 1);

  private final double[] depths;
  private final double[] speeds;
  private final int frames;
  private final Consumer<String> progress;

  /** Creates a study; {@code quick} uses one depth, one speed and fewer frames. */
  AccuracyStudy(boolean quick, Consumer<String> progress) {
    depths = quick ? new double[] {5} : new double[] {2, 5, 10};
    speeds = quick ? new double[] {0.3} : new double[] {0.05, 0.3, 2};
    frames = quick ? 3000 : 20000;
    this.progress = progress;
  }

  /** Measures all rows. */
  List<AccuracyRow> rows() {
    List<AccuracyRow> rows = new ArrayList<>();
    for (String shape : SHAPES) {
      AccuracyScene scene = new AccuracyScene(shape, EDGE);
      for (double depth : depths) {
        for (double speed : speeds) {
          progress.accept(shape + ", " + depth + " voxels deep, " + speed + " per frame");
          rows.addAll(slide(scene, shape, depth, speed));
        }
      }
    }
    return rows;
  }

  private List<AccuracyRow> slide(AccuracyScene scene, String shape, double depth, double speed) {
    SlideTrajectory slide = new SlideTrajectory(scene.truth, EDGE, depth, speed, frames, SEED);
    List<ComparedSolver> solvers = ComparedSolver.all(scene);
    double[] nanos = times(solvers, slide);
    List<AccuracyRow> rows = new ArrayList<>();
    for (int n = 0; n < solvers.size(); n++) {
      ComparedSolver one = solvers.get(n);
      Accuracy accuracy =
          new AccuracyMeter(scene.truth, UNIT, slide, depth).measure(one.solver(), one.scene());
      rows.add(new AccuracyRow(one.name(), shape, depth, speed, accuracy, nanos[n]));
    }
    return rows;
  }

  /** Returns each solver's median over rounds in which the solvers alternate. */
  private static double[] times(List<ComparedSolver> solvers, SlideTrajectory slide) {
    double[][] nanos = new double[solvers.size()][ROUNDS];
    for (int round = -WARM_UP_ROUNDS; round < ROUNDS; round++) {
      for (int n = 0; n < solvers.size(); n++) {
        double time = time(solvers.get(n), slide);
        if (round >= 0) {
          nanos[n][round] = time;
        }
      }
    }
    return Arrays.stream(nanos).mapToDouble(Median::of).toArray();
  }

  private static double time(ComparedSolver one, SlideTrajectory slide) {
    InteractionPoint point = new InteractionPoint();
    Vec3 device = new Vec3();
    one.solver().reset();
    slide.device(0, point.position);
    long begin = THREADS.getCurrentThreadCpuTime();
    for (int frame = 0; frame < slide.frames(); frame++) {
      one.solver().follow(one.scene(), slide.device(frame, device), point);
    }
    return (THREADS.getCurrentThreadCpuTime() - begin) / (double) slide.frames();
  }

  /** Returns the angles between force and true normal for the first frames of a slide. */
  static double[] angles(AccuracyScene scene, ComparedSolver one, double depth, int count) {
    SlideTrajectory slide = new SlideTrajectory(scene.truth, EDGE, depth, 0.05, count, SEED);
    InteractionPoint point = new InteractionPoint();
    Vec3 device = new Vec3();
    Vec3 normal = new Vec3();
    one.solver().reset();
    slide.device(0, point.position);
    double[] angles = new double[count];
    for (int frame = 0; frame < slide.frames(); frame++) {
      one.solver().follow(one.scene(), slide.device(frame, device), point);
      if (frame >= slide.slideStart()) {
        Vec3 force = point.position.sub(device, device);
        double cosine = force.dot(slide.normal(frame, normal)) / force.length();
        angles[frame - slide.slideStart()] =
            Math.toDegrees(Math.acos(Math.max(-1, Math.min(1, cosine))));
      }
    }
    return angles;
  }
}
