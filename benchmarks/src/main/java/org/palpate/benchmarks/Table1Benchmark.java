package org.palpate.benchmarks;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;
import org.palpate.benchmarks.baseline.PlainBaseline;
import org.palpate.benchmarks.input.Scans;
import org.palpate.benchmarks.input.Trajectories;
import org.palpate.collision.CollisionScene;
import org.palpate.collision.NearestFreeVoxel;
import org.palpate.device.Trajectory;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.ProxySolver;
import org.palpate.proxy.exact.GuardedSolver;
import org.palpate.proxy.reference.CollisionOnlySolver;
import org.palpate.proxy.smooth.SmoothSolver;
import org.palpate.raycast.ExactRayCaster;
import org.palpate.volume.BitCube;

/**
 * The paper's Table 1 on scans. A device moves 0.3 voxel per frame between random positions,
 * through solids as well; the point is free, pressed and dragged in turn, which is less than the
 * paper's peak load. Head and thorax have their own size or are resampled (nearest voxel) to the
 * sizes of the paper's data.
 *
 * <p>Reads the folder that the system property palpate.data names.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(
    value = 1,
    jvmArgsAppend = {"-Xmx3g"})
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class Table1Benchmark {
  private static final int FRAMES = 20_000;
  private static final double SPEED = 0.3;
  private static final double MAX_STEP_MM = 8;
  private static final long SEED = 7;

  @Param({"CThead 256x256x113", "CThead to 532x532x464", "LIDC 512x512x275", "LIDC to 512x512x520"})
  public String data;

  @Param({"none", "guarded", "smooth", "twin"})
  public String solver;

  private final Vec3 start = new Vec3();
  private final Vec3 device = new Vec3();
  private TrajectoryFollower follower;
  private PlainBaseline baseline;
  private Trajectory trajectory;
  private GridMetric metric;

  /** Reads the scan and resamples it if its name says so. */
  @Setup
  public void prepare() throws IOException {
    Scans scan = Scans.read(Path.of(System.getProperty("palpate.data")), data);
    BitCube bits = scan.bone();
    metric = data.contains(" to ") ? new GridMetric(1, 1, 1) : GridMetric.of(scan.spacingMm());
    CollisionScene scene = new CollisionScene(List.of(bits));
    trajectory = Trajectories.wander(bits.sizeX(), bits.sizeY(), bits.sizeZ(), SPEED, FRAMES, SEED);
    trajectory.position(0, start);
    if (solver.equals("twin")) {
      baseline = new PlainBaseline(bits, MAX_STEP_MM);
    } else {
      follower = new TrajectoryFollower(newSolver(), scene, trajectory);
    }
    if (baseline != null || scene.touches(start.x, start.y, start.z)) {
      new NearestFreeVoxel(metric).find(scene, start, start);
    }
  }

  private ProxySolver newSolver() {
    return switch (solver) {
      case "none" -> new CollisionOnlySolver(new ExactRayCaster(), metric);
      case "guarded" -> new GuardedSolver(metric, MAX_STEP_MM);
      case "smooth" -> new SmoothSolver(metric, MAX_STEP_MM);
      default -> throw new IllegalArgumentException("no such solver: " + solver);
    };
  }

  /** Follows the whole trajectory. */
  @Benchmark
  @OperationsPerInvocation(FRAMES)
  public double wander() {
    double sum = 0;
    if (follower == null) {
      baseline.place(start.x, start.y, start.z);
      for (int frame = 0; frame < FRAMES; frame++) {
        trajectory.position(frame, device);
        baseline.frame(device.x, device.y, device.z);
        sum += baseline.x();
      }
      return sum;
    }
    return follower.followFromStart(start);
  }
}
