package org.palpate.benchmarks.accuracy;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import org.palpate.geometry.Vec3;
import org.palpate.loop.Median;
import org.palpate.proxy.InteractionPoint;

/** Runs every solver on every slide: first for its errors, then in alternation for its time. */
final class AccuracyStudy {
  static final List<String> SHAPES = List.of("plane", "sphere", "torus");

  /** Processor time is used because other processes may use the machine too. */
  private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();

  /** The edge of the cube that a phantom fills, mm. */
  static final int EDGE = 192;

  /** The same for cubes whose surface has wider terraces. */
  private static final int LARGE_EDGE = 256;

  private static final long SEED = 7;
  private static final int ROUNDS = 7;
  private static final int WARM_UP_ROUNDS = 2;

  /** Voxels of 1 mm. */
  static final String CUBES = "1:1:1";

  /** The edges of voxels, mm; the shortest is 1. */
  private static final List<String> SPACINGS =
      List.of(
          CUBES, "1:1:1.2", "1:1:1.4", "1:1:2", "1:1:3", "1:1:5", "1:1:8", "1:1:10", "1:2:2",
          "1:3:3");

  private static final double USUAL_DEPTH = 5;
  private static final double USUAL_SPEED = 0.3;

  private final double[] depths;
  private final double[] speeds;
  private final int frames;
  private final Consumer<String> progress;

  /** Creates a study; {@code quick} uses one depth, one speed and fewer frames. */
  AccuracyStudy(boolean quick, Consumer<String> progress) {
    depths = quick ? new double[] {USUAL_DEPTH} : new double[] {2, USUAL_DEPTH, 10};
    speeds = quick ? new double[] {USUAL_SPEED} : new double[] {0.05, USUAL_SPEED, 2};
    frames = quick ? 3000 : 20000;
    this.progress = progress;
  }

  /** Measures all rows. */
  List<AccuracyRow> rows() {
    List<AccuracyRow> rows = new ArrayList<>();
    for (String spacing : SPACINGS) {
      for (String shape : SHAPES) {
        AccuracyScene scene = scene(shape, spacing);
        for (double depth : depths) {
          for (double speed : speeds) {
            rows.addAll(slide(scene, shape, spacing, depth, speed));
          }
        }
      }
    }
    for (String shape : SHAPES) {
      AccuracyScene large = new AccuracyScene(shape, LARGE_EDGE, new Vec3(1, 1, 1));
      rows.addAll(slide(large, shape, CUBES, USUAL_DEPTH, USUAL_SPEED));
    }
    return rows;
  }

  /**
   * Makes the scene of a phantom.
   *
   * @param spacing the edges of a voxel, mm, as 1:1:3
   */
  static AccuracyScene scene(String shape, String spacing) {
    double[] edges = Arrays.stream(spacing.split(":")).mapToDouble(Double::parseDouble).toArray();
    return new AccuracyScene(shape, EDGE, new Vec3(edges[0], edges[1], edges[2]));
  }

  private List<AccuracyRow> slide(
      AccuracyScene scene, String shape, String spacing, double depth, double speed) {
    progress.accept(
        String.format(
            Locale.ROOT,
            "%s:%d, voxels of %s mm, %s mm deep, %s mm per frame",
            shape,
            scene.edge,
            spacing,
            depth,
            speed));
    SlideTrajectory slide =
        new SlideTrajectory(scene.truth, scene.edge, depth, speed, frames, SEED);
    List<ComparedSolver> solvers =
        spacing.equals(CUBES) && scene.edge == EDGE
            ? ComparedSolver.all(scene)
            : ComparedSolver.ours(scene);
    double[] nanos = times(scene, solvers, slide);
    List<AccuracyRow> rows = new ArrayList<>();
    for (int n = 0; n < solvers.size(); n++) {
      ComparedSolver one = solvers.get(n);
      Accuracy accuracy =
          new AccuracyMeter(scene.truth, scene.metric, slide, depth)
              .measure(one.solver(), one.scene());
      rows.add(
          new AccuracyRow(
              one.name(), shape, scene.edge, spacing, depth, speed, accuracy, nanos[n]));
    }
    return rows;
  }

  /** Returns each solver's median over rounds in which the solvers alternate. */
  private static double[] times(
      AccuracyScene scene, List<ComparedSolver> solvers, SlideTrajectory slide) {
    double[][] nanos = new double[solvers.size()][ROUNDS];
    for (int round = -WARM_UP_ROUNDS; round < ROUNDS; round++) {
      for (int n = 0; n < solvers.size(); n++) {
        double time = time(scene, solvers.get(n), slide);
        if (round >= 0) {
          nanos[n][round] = time;
        }
      }
    }
    return Arrays.stream(nanos).mapToDouble(Median::of).toArray();
  }

  private static double time(AccuracyScene scene, ComparedSolver one, SlideTrajectory slide) {
    InteractionPoint point = new InteractionPoint();
    Vec3 device = new Vec3();
    one.solver().reset();
    scene.toGrid(slide.device(0, device), point.position);
    long begin = THREADS.getCurrentThreadCpuTime();
    for (int frame = 0; frame < slide.frames(); frame++) {
      one.solver().follow(one.scene(), scene.toGrid(slide.device(frame, device), device), point);
    }
    return (THREADS.getCurrentThreadCpuTime() - begin) / (double) slide.frames();
  }

  /** Returns the angles between force and true normal for the first frames of a slide. */
  static double[] angles(AccuracyScene scene, ComparedSolver one, double depth, int count) {
    SlideTrajectory slide = new SlideTrajectory(scene.truth, EDGE, depth, 0.05, count, SEED);
    InteractionPoint point = new InteractionPoint();
    Vec3 device = new Vec3();
    Vec3 normal = new Vec3();
    Vec3 force = new Vec3();
    one.solver().reset();
    scene.toGrid(slide.device(0, device), point.position);
    double[] angles = new double[count];
    for (int frame = 0; frame < slide.frames(); frame++) {
      scene.toGrid(slide.device(frame, device), device);
      one.solver().follow(one.scene(), device, point);
      if (frame >= slide.slideStart()) {
        scene.toMm(point.position.sub(device, force), force);
        angles[frame - slide.slideStart()] =
            AccuracyMeter.angleDegrees(force, slide.normal(frame, normal));
      }
    }
    return angles;
  }
}
