package org.palpate.benchmarks.speed;

import java.io.IOException;
import java.io.PrintWriter;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.palpate.benchmarks.input.RaySet;
import org.palpate.benchmarks.input.Trajectories;
import org.palpate.benchmarks.report.MachineSummary;
import org.palpate.collision.CollisionScene;
import org.palpate.device.Trajectory;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.io.file.NumberText;
import org.palpate.loop.Median;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.exact.GuardedSolver;
import org.palpate.raycast.ExactRayCaster;
import org.palpate.raycast.Ray;
import org.palpate.raycast.RayHit;
import org.palpate.volume.BitCube;
import org.palpate.volume.phantom.Phantom;

/**
 * Compares the exact ray cast and the guarded frame in Java with a port to C++, on the same rays
 * and slides and by processor time. Both must give the same bits.
 */
public final class CppComparison {
  private static final int FRAMES = 20_000;
  private static final int PASSES = 120;
  private static final double DEPTH = 5;
  private static final double MAX_STEP_VOXELS = 8;
  private static final long SEED = 7;
  private static final List<String> SCENES = List.of("sphere:256", "plane:256", "torus:256");
  private static final List<Double> SPEEDS = List.of(0.05, 0.3, 2.0);
  private static final List<Rays> RAYS =
      List.of(
          new Rays("free", 1),
          new Rays("near", 4),
          new Rays("anywhere", 50),
          new Rays("slide", 0.1));
  private static final int RAY_COUNT = 20_000; // more than a branch predictor can learn
  private static final int RAY_PASSES = 200;

  private final ThreadMXBean threads = ManagementFactory.getThreadMXBean();
  private final InteractionPoint point = new InteractionPoint();
  private final Vec3 device = new Vec3();

  private final Ray ray = new Ray();
  private final RayHit hit = new RayHit();
  private final CppPort port;
  private final PrintWriter out;
  private final Map<String, Object> ratios = new LinkedHashMap<>();

  private CppComparison(CppPort port, PrintWriter out) {
    this.port = port;
    this.out = out;
  }

  /**
   * Runs the comparison.
   *
   * @param folder the folder in which the port is compiled
   * @param out receives the table
   * @return Java's time relative to the port's, by kind of ray and by slide
   * @throws IOException if there is no C++ compiler or a result differs
   */
  public static Map<String, Object> run(Path folder, PrintWriter out)
      throws IOException, InterruptedException {
    Files.createDirectories(folder);
    CppComparison run = new CppComparison(CppPort.in(folder), out);
    out.println(MachineSummary.line(MachineSummary.facts()));
    run.castRays();
    for (String scene : SCENES) {
      run.slide(Phantom.parse(scene), scene);
    }
    return run.ratios;
  }

  /** A kind of rays and their length, as in {@link RaySet}. */
  private record Rays(String place, double length) {}

  private void castRays() throws IOException, InterruptedException {
    Phantom phantom = Phantom.parse(SCENES.get(0));
    BitCube bits = phantom.segments().segments().get(0).bits();
    for (Rays kind : RAYS) {
      RaySet rays =
          RaySet.of(
              phantom.analyticSurface().orElseThrow(),
              phantom.edge(),
              kind.place,
              kind.length,
              RAY_COUNT,
              SEED);
      String name = "a ray, " + kind.place + ", length " + NumberText.display(kind.length);
      report(name, port.cast(bits, rays, RAY_PASSES), castInJava(bits, rays));
    }
  }

  private void slide(Phantom phantom, String scene) throws IOException, InterruptedException {
    BitCube bits = phantom.segments().segments().get(0).bits();
    for (double speed : SPEEDS) {
      Trajectory slide =
          Trajectories.slide(
              phantom.analyticSurface().orElseThrow(), phantom.edge(), DEPTH, speed, FRAMES, SEED);
      String name = scene + ", " + speed + " voxel a frame";
      report(name, port.follow(bits, slide, MAX_STEP_VOXELS, PASSES), followInJava(bits, slide));
    }
  }

  private void report(String name, CppPort.Outcome cpp, CppPort.Outcome java) throws IOException {
    check(name, cpp, java);
    double ratio = warmMedian(java) / warmMedian(cpp);
    ratios.put(name, ratio);
    out.printf(
        Locale.ROOT,
        "%-32s Java %7.1f ns  C++ %7.1f ns  ratio %.2f, same bits%n",
        name,
        warmMedian(java),
        warmMedian(cpp),
        ratio);
    out.flush();
  }

  private static void check(String name, CppPort.Outcome cpp, CppPort.Outcome java)
      throws IOException {
    if (cpp.hash() != java.hash()) {
      throw new IOException(
          "the C++ port gave another result: " + name + ", undecided rays: " + cpp.doubts());
    }
  }

  private CppPort.Outcome followInJava(BitCube bits, Trajectory slide) {
    GuardedSolver solver = new GuardedSolver(new GridMetric(1, 1, 1), MAX_STEP_VOXELS);
    CollisionScene scene = new CollisionScene(List.of(bits));
    List<Double> nanos = new ArrayList<>();
    long hash = 0;
    for (int pass = 0; pass < PASSES; pass++) {
      long begin = threads.getCurrentThreadCpuTime();
      hash = pass(solver, scene, slide);
      nanos.add((threads.getCurrentThreadCpuTime() - begin) / (double) FRAMES);
    }
    return new CppPort.Outcome(hash, 0, nanos);
  }

  private CppPort.Outcome castInJava(BitCube bits, RaySet rays) {
    ExactRayCaster caster = new ExactRayCaster();
    List<Double> nanos = new ArrayList<>();
    long hash = 0;
    for (int pass = 0; pass < RAY_PASSES; pass++) {
      long begin = threads.getCurrentThreadCpuTime();
      hash = pass(caster, bits, rays);
      nanos.add((threads.getCurrentThreadCpuTime() - begin) / (double) rays.count());
    }
    return new CppPort.Outcome(hash, 0, nanos);
  }

  /** Returns the port's hash of every hit, in order. */
  private long pass(ExactRayCaster caster, BitCube bits, RaySet rays) {
    long hash = 0;
    for (int n = 0; n < rays.count(); n++) {
      boolean found = caster.cast(bits, rays.at(n, ray), hit);
      hash = hash * 31 + (found ? Double.doubleToRawLongBits(hit.t) + 7 * (hit.axis + 1L) : 0);
    }
    return hash;
  }

  /** Returns the port's hash of every frame, in order. */
  private long pass(GuardedSolver solver, CollisionScene scene, Trajectory slide) {
    solver.reset();
    slide.position(0, point.position);
    long hash = 0;
    for (int frame = 0; frame < FRAMES; frame++) {
      solver.follow(scene, slide.position(frame, device), point);
      hash =
          hash * 31
              + Double.doubleToRawLongBits(point.position.x)
              + 7 * Double.doubleToRawLongBits(point.position.y)
              + 13 * Double.doubleToRawLongBits(point.position.z)
              + (point.contact ? 1 : 0)
              + 3L * point.legs.count();
    }
    return hash;
  }

  /** Returns the median of the later half of the passes, with compiled code and warm caches. */
  private static double warmMedian(CppPort.Outcome outcome) {
    double[] nanos = outcome.nanosPerPass().stream().mapToDouble(Double::doubleValue).toArray();
    return Median.of(Arrays.copyOfRange(nanos, nanos.length / 2, nanos.length));
  }
}
