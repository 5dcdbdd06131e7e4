package org.palpate.benchmarks.speed;

import java.io.IOException;
import java.io.PrintWriter;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.palpate.benchmarks.input.RaySet;
import org.palpate.benchmarks.input.Trajectories;
import org.palpate.collision.CollisionScene;
import org.palpate.device.Trajectory;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.io.file.NumberText;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.exact.GuardedSolver;
import org.palpate.raycast.ExactRayCaster;
import org.palpate.raycast.Ray;
import org.palpate.raycast.RayHit;
import org.palpate.volume.BitCube;
import org.palpate.volume.phantom.Phantom;

/**
 * The exact ray cast and the guarded frame in Java against their twins in C++, on the same rays and
 * slides, both by processor time and checked to find the same to the bit.
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
  private static final int RAY_COUNT = 20_000; // more than a branch predictor learns by heart
  private static final int RAY_PASSES = 200;

  private final ThreadMXBean threads = ManagementFactory.getThreadMXBean();
  private final InteractionPoint point = new InteractionPoint();
  private final Vec3 device = new Vec3();

  private final Ray ray = new Ray();
  private final RayHit hit = new RayHit();
  private final CppPort twin;
  private final PrintWriter out;
  private final Map<String, Object> ratios = new LinkedHashMap<>();

  private CppComparison(CppPort twin, PrintWriter out) {
    this.twin = twin;
    this.out = out;
  }

  /**
   * Runs it.
   *
   * @param folder where the twin is compiled
   * @param out gets the table
   * @return Java's time over the twin's, by kind of ray and by slide
   * @throws IOException where there is no C++ compiler, or a way differs
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

  /** Kinds of rays and their length, as {@link RaySet} has them. */
  private record Rays(String place, double length) {}

  private void castRays() throws IOException, InterruptedException {
    Phantom phantom = Phantom.parse(SCENES.get(0));
    BitCube bits = phantom.segments().segments().get(0).bits();
    for (Rays kind : RAYS) {
      RaySet rays =
          RaySet.of(
              phantom.truth().orElseThrow(),
              phantom.edge(),
              kind.place,
              kind.length,
              RAY_COUNT,
              SEED);
      String name = "a ray, " + kind.place + ", length " + NumberText.people(kind.length);
      tell(name, twin.cast(bits, rays, RAY_PASSES), castInJava(bits, rays));
    }
  }

  private void slide(Phantom phantom, String scene) throws IOException, InterruptedException {
    BitCube bits = phantom.segments().segments().get(0).bits();
    for (double speed : SPEEDS) {
      Trajectory slide =
          Trajectories.slide(
              phantom.truth().orElseThrow(), phantom.edge(), DEPTH, speed, FRAMES, SEED);
      String name = scene + ", " + speed + " voxel a frame";
      tell(name, twin.follow(bits, slide, MAX_STEP_VOXELS, PASSES), followInJava(bits, slide));
    }
  }

  private void tell(String name, CppPort.Outcome cpp, CppPort.Outcome java) throws IOException {
    check(name, cpp, java);
    double ratio = settled(java) / settled(cpp);
    ratios.put(name, ratio);
    out.printf(
        Locale.ROOT,
        "%-32s Java %7.1f ns  C++ %7.1f ns  %.2f of it, same bits%n",
        name,
        settled(java),
        settled(cpp),
        ratio);
    out.flush();
  }

  private static void check(String name, CppPort.Outcome cpp, CppPort.Outcome java)
      throws IOException {
    if (cpp.hash() != java.hash()) {
      throw new IOException(
          "the C++ twin took another way: " + name + ", rays in doubt: " + cpp.doubts());
    }
  }

  private CppPort.Outcome followInJava(BitCube bits, Trajectory slide) {
    GuardedSolver solver = new GuardedSolver(new GridMetric(1, 1, 1), MAX_STEP_VOXELS);
    CollisionScene obstacles = new CollisionScene(List.of(bits));
    List<Double> nanos = new ArrayList<>();
    long hash = 0;
    for (int pass = 0; pass < PASSES; pass++) {
      long begin = threads.getCurrentThreadCpuTime();
      hash = pass(solver, obstacles, slide);
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

  /** The hash that the twin computes too: of every hit, in their order. */
  private long pass(ExactRayCaster caster, BitCube bits, RaySet rays) {
    long hash = 0;
    for (int n = 0; n < rays.count(); n++) {
      boolean found = caster.cast(bits, rays.at(n, ray), hit);
      hash = hash * 31 + (found ? Double.doubleToRawLongBits(hit.t) + 7 * (hit.axis + 1L) : 0);
    }
    return hash;
  }

  /** The hash that the twin computes too: of every frame, in their order. */
  private long pass(GuardedSolver solver, CollisionScene obstacles, Trajectory slide) {
    solver.reset();
    slide.position(0, point.position);
    long hash = 0;
    for (int frame = 0; frame < FRAMES; frame++) {
      solver.follow(obstacles, slide.position(frame, device), point);
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

  /** The median of the later half: compiled, and with warm caches. */
  private static double settled(CppPort.Outcome outcome) {
    List<Double> later =
        outcome.nanosPerPass().stream().skip(outcome.nanosPerPass().size() / 2).sorted().toList();
    return later.get(later.size() / 2);
  }
}
