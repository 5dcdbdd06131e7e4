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
import org.palpate.benchmarks.input.Trajectories;
import org.palpate.collision.CollisionScene;
import org.palpate.device.Trajectory;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.exact.GuardedSolver;
import org.palpate.volume.BitCube;
import org.palpate.volume.phantom.Phantom;

/**
 * Time of one pressed frame of {@code guarded} on a ball of bits, by the edge of the grid. The hand
 * {@code voxels} moves the same number of voxels per frame; {@code scaled} moves the same fraction
 * of the ball, which is 8 times as many voxels at 2048 as at 256. Caches are warm at the hand;
 * {@code cold} has each frame elsewhere.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(
    value = 1,
    jvmArgsAppend = {"-Xmx10g", "-XX:MaxNewSize=256m"}) // 4096^3 bits are 8.1 GB in one array
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class ScaleBenchmark {
  private static final int FRAMES = 20_000;
  private static final double DEPTH = 5;
  private static final double SPEED = 0.2;
  private static final int SCALED_FROM = 256;
  private static final long SEED = 7;

  @Param({"256", "512", "1024", "2048", "4096"})
  public int edge;

  @Param({"voxels", "scaled", "cold"})
  public String hand;

  private final InteractionPoint point = new InteractionPoint();
  private final Vec3 device = new Vec3();
  private GuardedSolver solver;
  private CollisionScene scene;
  private TrajectoryFollower follower;
  private double[] positions;

  /** Makes the ball and the hand. */
  @Setup
  public void prepare() {
    Phantom phantom = Phantom.parse("sphere:" + edge);
    BitCube bits = phantom.segments().segments().get(0).bits();
    scene = new CollisionScene(List.of(bits));
    double scale = hand.equals("scaled") ? (double) edge / SCALED_FROM : 1;
    Trajectory trajectory =
        Trajectories.slide(
            phantom.analyticSurface().orElseThrow(),
            edge,
            DEPTH * scale,
            SPEED * scale,
            FRAMES,
            SEED);
    solver = new GuardedSolver(new GridMetric(1, 1, 1), 8 * scale);
    follower = new TrajectoryFollower(solver, scene, trajectory);
    computePositions(phantom);
  }

  /** Computes positions just above the surface, all over the ball, for the cold hand. */
  private void computePositions(Phantom phantom) {
    Trajectory all =
        Trajectories.approach(phantom.analyticSurface().orElseThrow(), edge, 1, 14, FRAMES, SEED);
    positions = new double[3 * FRAMES];
    for (int frame = 0; frame < FRAMES; frame++) {
      all.position(frame, device);
      for (int axis = 0; axis < 3; axis++) {
        positions[3 * frame + axis] = device.get(axis);
      }
    }
  }

  /** Follows the hand; the cold hand presses from a new position in each frame. */
  @Benchmark
  @OperationsPerInvocation(FRAMES)
  public double follow() {
    return hand.equals("cold") ? followCold() : follower.follow();
  }

  private double followCold() {
    double sum = 0;
    double middle = edge / 2.0;
    for (int at = 0; at < positions.length; at += 3) {
      point.position.set(positions[at], positions[at + 1], positions[at + 2]);
      device.set(
          positions[at] + 0.1 * Math.signum(middle - positions[at]),
          positions[at + 1] + 0.1 * Math.signum(middle - positions[at + 1]),
          positions[at + 2] + 0.1 * Math.signum(middle - positions[at + 2]));
      solver.reset();
      solver.follow(scene, device, point);
      sum += point.position.x;
    }
    return sum;
  }
}
