package org.palpate.benchmarks.carve;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.Arrays;
import java.util.List;
import org.palpate.benchmarks.rigid.Quantile;
import org.palpate.benchmarks.rigid.RigidFigure;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.carve.CarveSettings;
import org.palpate.carve.ToolCarver;
import org.palpate.collision.CollisionScene;
import org.palpate.edit.VoxelWriter;
import org.palpate.geometry.Pose;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.RigidSettings;
import org.palpate.rigid.RigidSolver;
import org.palpate.rigid.ToolMotion;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.RodShape;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/**
 * Measures the time of cutting: a burr of 6 mm diameter and about 1,000 points moves through voxels
 * of 0.25 mm at 60 mm/s, pressed 2 mm deep. Times are those of the processor, without
 * interruptions.
 *
 * <p>Every pass does the same work. The least time of a frame over several passes is that of its
 * work; the times of one pass also have what other programs on the machine cost it.
 */
final class CarveTimes {
  private static final double EDGE_MM = 0.25;
  private static final int SIZE = 160;
  private static final int HEIGHT = 64;
  private static final double RADIUS_MM = 3;

  /** The cover radius that gives the burr about 1,000 points, mm. */
  private static final double COVER_MM = 0.257;

  private static final double MM_PER_FRAME = 0.06;
  private static final double DEPTH_MM = 2;
  private static final double NEWTON_PER_MM = 0.5;
  private static final double RATE = 40;
  private static final double NANOS_PER_MICRO = 1e3;

  /** The least number of frames before a session switches the force on. */
  private static final int WARM_UP_FRAMES = 10_000;

  private static final int PASSES = 5;

  private final ThreadMXBean threads = ManagementFactory.getThreadMXBean();
  private final BitCube bits = new BitCube(SIZE, SIZE, HEIGHT);
  private final double[] carveMicros;
  private final double[] frameMicros;
  private final double[] leastCarveMicros;
  private final double[] leastFrameMicros;
  private final Pose device = new Pose();
  private final Vec3 stretch = new Vec3();

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
    String burr = "burr of 6 mm in voxels of 0.25 mm";
    return List.of(
        figure(burr, "cut p50", Quantile.of(carveMicros, 0.5), Double.NaN),
        figure(burr, "cut p99.9", Quantile.of(carveMicros, 0.999), 50),
        figure(burr, least("cut p99.9"), Quantile.of(leastCarveMicros, 0.999), Double.NaN),
        figure(burr, "cut and motion p50", Quantile.of(frameMicros, 0.5), Double.NaN),
        figure(burr, "cut and motion p99.9", Quantile.of(frameMicros, 0.999), 300),
        figure(
            burr, least("cut and motion p99.9"), Quantile.of(leastFrameMicros, 0.999), Double.NaN),
        RigidFigure.of(
            "time", burr, "voxels removed", (double) (filled() - bits.solidCount()), ""));
  }

  private static void keepLeast(double[] micros, double[] least) {
    for (int n = 0; n < micros.length; n++) {
      least[n] = Math.min(least[n], micros[n]);
    }
  }

  private static String least(String name) {
    return name + ", least of " + PASSES + " passes";
  }

  private static long filled() {
    return (long) SIZE * SIZE * (HEIGHT / 2);
  }

  private static RigidFigure figure(String burr, String name, double micros, double target) {
    return new RigidFigure("time", burr, name, micros, "us", target);
  }

  private void run() {
    fill();
    Body body = new Body("bone", bits, grid(), Mobility.FIXED);
    BodyScene bodies = new BodyScene(List.of(body));
    RigidTool tool = ToolSampler.ofShape(RodShape.sphere(RADIUS_MM), COVER_MM);
    RigidSolver solver =
        new RigidSolver(bodies, tool, RigidSettings.ofWholeBodies(2, bodies, tool));
    VoxelWriter writer =
        new VoxelWriter(
            new CollisionScene(List.of(bits)), (segment, box) -> body.voxelsChanged(box));
    ToolCarver carver =
        new ToolCarver(CarveSettings.ofRate(RATE), bodies, solver.newBlockingVoxels(), writer);
    ToolMotion motion = solver.newMotion();
    double surfaceMm = HEIGHT / 2 * EDGE_MM;
    device.setIdentity();
    device.translation.set(8, 8, surfaceMm + RADIUS_MM + 1);
    solver.place(device, motion);
    double way = 0;
    for (int n = 0; n < frameMicros.length; n++) {
      way += MM_PER_FRAME;
      double x = 8 + Math.abs(way % 48 - 24); // to and fro
      double y = 8 + Math.min(24, n * 0.002);
      device.translation.set(x, y, surfaceMm + RADIUS_MM - DEPTH_MM);
      double newton =
          NEWTON_PER_MM * motion.pose().translation.sub(device.translation, stretch).length();
      long start = threads.getCurrentThreadCpuTime();
      carver.carve(device, newton, 1_000_000);
      long cut = threads.getCurrentThreadCpuTime();
      solver.follow(device, motion);
      frameMicros[n] = (threads.getCurrentThreadCpuTime() - start) / NANOS_PER_MICRO;
      carveMicros[n] = (cut - start) / NANOS_PER_MICRO;
    }
  }

  private void fill() {
    for (int k = 0; k < HEIGHT / 2; k++) {
      for (int j = 0; j < SIZE; j++) {
        for (int i = 0; i < SIZE; i++) {
          bits.set(i, j, k);
        }
      }
    }
  }

  private static VoxelGrid grid() {
    RigidTransform axes =
        new RigidTransform(new Vec3(1, 0, 0), new Vec3(0, 1, 0), new Vec3(0, 0, 1), new Vec3());
    return new VoxelGrid(SIZE, SIZE, HEIGHT, new Vec3(EDGE_MM, EDGE_MM, EDGE_MM), axes);
  }
}
