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
import org.palpate.benchmarks.Trajectories;
import org.palpate.benchmarks.Trajectory;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.GuardedSolver;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.Metric;
import org.palpate.proxy.Obstacles;
import org.palpate.volume.BitCube;
import org.palpate.volume.phantom.Phantom;

/**
 * The guarded frame in Java against its twin in C++, on the same slides, both by processor time and
 * checked to take the same way to the bit.
 */
public final class CppTwinRun {
  private static final int FRAMES = 20_000;
  private static final int PASSES = 120;
  private static final double DEPTH = 5;
  private static final double MAX_STEP_VOXELS = 8;
  private static final long SEED = 7;
  private static final List<String> SCENES = List.of("sphere:256", "plane:256", "torus:256");
  private static final List<Double> SPEEDS = List.of(0.05, 0.3, 2.0);

  private final ThreadMXBean threads = ManagementFactory.getThreadMXBean();
  private final InteractionPoint point = new InteractionPoint();
  private final Vec3 device = new Vec3();

  private CppTwinRun() {}

  /**
   * Runs it.
   *
   * @param folder where the twin is compiled
   * @param out gets the table
   * @return Java's time over the twin's, by slide
   * @throws IOException where there is no C++ compiler, or a way differs
   */
  public static Map<String, Object> run(Path folder, PrintWriter out)
      throws IOException, InterruptedException {
    Files.createDirectories(folder);
    CppTwin twin = CppTwin.in(folder);
    CppTwinRun run = new CppTwinRun();
    Map<String, Object> ratios = new LinkedHashMap<>();
    out.println(MachineLine.line(MachineLine.facts()));
    for (String scene : SCENES) {
      Phantom phantom = Phantom.parse(scene);
      BitCube bits = phantom.segments().segments().get(0).bits();
      for (double speed : SPEEDS) {
        Trajectory slide =
            Trajectories.slide(
                phantom.truth().orElseThrow(), phantom.edge(), DEPTH, speed, FRAMES, SEED);
        String name = scene + ", " + speed + " voxel a frame";
        CppTwin.Outcome cpp = twin.run(bits, slide, MAX_STEP_VOXELS, PASSES);
        CppTwin.Outcome java = run.inJava(bits, slide);
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
    }
    return ratios;
  }

  private static void check(String name, CppTwin.Outcome cpp, CppTwin.Outcome java)
      throws IOException {
    if (cpp.hash() != java.hash()) {
      throw new IOException(
          "the C++ twin took another way: " + name + ", rays in doubt: " + cpp.doubts());
    }
  }

  private CppTwin.Outcome inJava(BitCube bits, Trajectory slide) {
    GuardedSolver solver = new GuardedSolver(new Metric(1, 1, 1), MAX_STEP_VOXELS);
    Obstacles obstacles = new Obstacles(List.of(bits));
    List<Double> nanos = new ArrayList<>();
    long hash = 0;
    for (int pass = 0; pass < PASSES; pass++) {
      long begin = threads.getCurrentThreadCpuTime();
      hash = pass(solver, obstacles, slide);
      nanos.add((threads.getCurrentThreadCpuTime() - begin) / (double) FRAMES);
    }
    return new CppTwin.Outcome(hash, 0, nanos);
  }

  /** The hash that the twin computes too: of every frame, in their order. */
  private long pass(GuardedSolver solver, Obstacles obstacles, Trajectory slide) {
    solver.reset();
    slide.at(0, point.position);
    long hash = 0;
    for (int frame = 0; frame < FRAMES; frame++) {
      solver.follow(obstacles, slide.at(frame, device), point);
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
  private static double settled(CppTwin.Outcome outcome) {
    List<Double> later =
        outcome.nanosAFrame().subList(PASSES / 2, PASSES).stream().sorted().toList();
    return later.get(later.size() / 2);
  }
}
