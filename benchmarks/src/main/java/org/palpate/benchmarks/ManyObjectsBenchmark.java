package org.palpate.benchmarks;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
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
import org.palpate.collision.CollisionScene;
import org.palpate.collision.CollisionSceneVariants;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.exact.GuardedSolver;
import org.palpate.volume.BitCube;

/**
 * Time of one frame of {@code guarded} among many objects, five of which lie where the hand slides,
 * with and without the tree that finds the near ones.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(
    value = 1,
    jvmArgsAppend = {"-Xmx2g"}) // a thousand cubes of 128^3 bits
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class ManyObjectsBenchmark {
  private static final int EDGE = 128;
  private static final int NEAR = 5;
  private static final int FRAMES = 20_000;
  private static final double DEPTH = 5;
  private static final double SPEED = 0.2;
  private static final double MAX_STEP_VOXELS = 8;
  private static final long SEED = 3;

  /** The number of objects; the near ones are always the same. */
  @Param({"5", "1000"})
  public int objects;

  /** The broad phase: a tree, or a test of each object. */
  @Param({"tree", "each"})
  public String candidates;

  private final GuardedSolver solver = new GuardedSolver(new GridMetric(1, 1, 1), MAX_STEP_VOXELS);
  private final InteractionPoint point = new InteractionPoint();
  private final Vec3 device = new Vec3();
  private CollisionScene scene;

  /** Makes five slabs that form a floor, and small objects in the rest of the grid. */
  @Setup
  public void prepare() {
    SplittableRandom random = new SplittableRandom(SEED);
    List<BitCube> cubes = new ArrayList<>();
    for (int n = 0; n < objects; n++) {
      BitCube cube = new BitCube(EDGE, EDGE, EDGE);
      if (n < NEAR) {
        fill(cube, 20 * n, 40, 0, 20, 40, 20 + n % 2);
      } else {
        fill(
            cube,
            random.nextInt(EDGE - 4),
            random.nextInt(EDGE - 4),
            64 + random.nextInt(EDGE - 64 - 4),
            4,
            4,
            4);
      }
      cubes.add(cube);
    }
    scene =
        candidates.equals("tree")
            ? CollisionSceneVariants.withBroadPhase(cubes)
            : CollisionSceneVariants.withoutBroadPhase(cubes);
  }

  private static void fill(BitCube cube, int i, int j, int k, int x, int y, int z) {
    for (int n = 0; n < x * y * z; n++) {
      cube.set(i + n % x, j + n / x % y, k + n / (x * y));
    }
  }

  /** Slides back and forth over the floor of five objects, pressed into it. */
  @Benchmark
  @OperationsPerInvocation(FRAMES)
  public double slide() {
    point.position.set(5, 60, 30);
    solver.reset();
    double sum = 0;
    for (int frame = 0; frame < FRAMES; frame++) {
      double along = SPEED * frame;
      device.set(5 + 45 * (1 - Math.cos(along / 45)), 60 + 15 * Math.sin(along / 31), 20.3 - DEPTH);
      solver.follow(scene, device, point);
      sum += point.position.x;
    }
    return sum;
  }
}
