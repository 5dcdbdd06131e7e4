package org.palpate.benchmarks;

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
import org.palpate.benchmarks.input.Trajectories;
import org.palpate.collision.CollisionScene;
import org.palpate.collision.NearestFreeVoxel;
import org.palpate.device.Trajectory;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.ProxySolver;
import org.palpate.proxy.exact.GuardedSolver;
import org.palpate.proxy.reference.BorderVoxels;
import org.palpate.proxy.reference.CollisionOnlySolver;
import org.palpate.proxy.reference.DotSolver;
import org.palpate.proxy.reference.PaperSolver;
import org.palpate.proxy.smooth.SmoothSolver;
import org.palpate.raycast.ExactRayCaster;
import org.palpate.raycast.SampledRayCaster;
import org.palpate.volume.BitCube;
import org.palpate.volume.phantom.AnalyticSurface;
import org.palpate.volume.phantom.Phantom;

/**
 * Time of one frame of response, by solver, on the same trajectory: the hand presses and slides, or
 * moves otherwise. {@link AlternatingForks} runs it with alternating solvers.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1) // the paper's listing is slow to reach its steady state
@Measurement(iterations = 5, time = 1)
public class ResponseBenchmark {
  private static final int FRAMES = 20_000;
  private static final double MAX_STEP_VOXELS = 8;
  private static final long SEED = 7;

  @Param({"twin", "guarded", "paper", "dot"})
  public String solver;

  @Param({"sphere:256", "plane:256", "torus:256"})
  public String scene;

  @Param({"5"})
  public double depth;

  /** The motion of the hand, see {@link Trajectories}. */
  @Param({"slide"})
  public String motion;

  @Param({"0.05", "0.3", "2"})
  public double speed;

  private final Vec3 start = new Vec3();
  private final Vec3 device = new Vec3();
  private Trajectory trajectory;
  private PlainBaseline baseline;
  private TrajectoryFollower follower;

  /** Makes the phantom and the trajectory. */
  @Setup
  public void prepare() {
    Phantom phantom = Phantom.parse(scene);
    BitCube bits = phantom.segments().segments().get(0).bits();
    trajectory = trajectory(phantom);
    baseline = new PlainBaseline(bits, MAX_STEP_VOXELS);
    CollisionScene collisionScene = new CollisionScene(List.of(bits));
    trajectory.position(0, start);
    if (collisionScene.touches(start.x, start.y, start.z)) { // a hand in a groove starts pressed
      new NearestFreeVoxel(new GridMetric(1, 1, 1)).find(collisionScene, start, start);
    }
    if (!solver.equals("twin")) {
      follower = new TrajectoryFollower(solverOf(solver), collisionScene, trajectory);
    }
  }

  private Trajectory trajectory(Phantom phantom) {
    int edge = phantom.edge();
    AnalyticSurface truth = phantom.analyticSurface().orElse(null); // jumps need no surface
    return switch (motion) {
      case "slide" -> Trajectories.slide(truth, edge, depth, speed, FRAMES, SEED);
      case "press" -> Trajectories.approach(truth, edge, depth, speed, FRAMES, SEED);
      case "groove" -> Trajectories.grooves(truth, edge, depth, speed, FRAMES, SEED);
      case "free" -> Trajectories.free(truth, edge, depth, speed, FRAMES, SEED);
      case "jump" -> Trajectories.jumps(edge, edge, edge, FRAMES, SEED);
      case "wander" -> Trajectories.wander(edge, edge, edge, speed, FRAMES, SEED);
      default -> throw new IllegalArgumentException("no such motion: " + motion);
    };
  }

  private static ProxySolver solverOf(String name) {
    GridMetric metric = new GridMetric(1, 1, 1);
    SampledRayCaster sampled = new SampledRayCaster(1);
    return switch (name) {
      case "guarded" -> new GuardedSolver(metric, MAX_STEP_VOXELS);
      case "smooth" -> new SmoothSolver(metric, MAX_STEP_VOXELS);
      case "none" -> new CollisionOnlySolver(new ExactRayCaster(), metric);
      case "paper" -> new PaperSolver(sampled, metric, MAX_STEP_VOXELS, BorderVoxels.onTheFly());
      case "dot" -> new DotSolver(sampled, metric, MAX_STEP_VOXELS, BorderVoxels.onTheFly());
      default -> throw new IllegalArgumentException("no such solver: " + name);
    };
  }

  /** Follows the whole trajectory. */
  @Benchmark
  @OperationsPerInvocation(FRAMES)
  public double pressAndSlide() {
    return follower == null ? baselineFrames() : follower.followFromStart(start);
  }

  private double baselineFrames() {
    baseline.place(start.x, start.y, start.z);
    double sum = 0;
    for (int frame = 0; frame < FRAMES; frame++) {
      trajectory.position(frame, device);
      baseline.frame(device.x, device.y, device.z);
      sum += baseline.x();
    }
    return sum;
  }
}
